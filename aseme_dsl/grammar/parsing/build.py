"""From the objects that textX makes of a file to the tree."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeVar

from aseme_dsl.amola.operators import USUAL
from aseme_dsl.diagnostics import Diagnostic, Problem, Related
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.formulas.expression import read_duration, read_expression, read_path, read_text
from aseme_dsl.grammar.formulas.formula import read_formula
from aseme_dsl.grammar.formulas.transition import read_transition
from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES, RESERVED, Malformed
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import HOLE, PLACEHOLDER
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source, Span

_T = TypeVar("_T")

COMM_TYPES = ("signal", "state", "data")
_COUNTS = {"one": 1, "two": 2, "three": 3}
_LONGEST_INTEGER = 18


def build(
    source: Source, file: Any, comments: tuple[tree.Comment, ...]
) -> tuple[tree.File, list[Diagnostic]]:
    """The tree of a file, and what is wrong inside formulas, expressions, numbers and names."""
    builder = _Builder(source)
    declarations: tuple[tree.Declaration, ...] = builder.all(builder.declaration, file.declarations)
    language = builder.integer_number(file.language) if file.language else None
    return tree.File(source, language, declarations, comments), builder.diagnostics


class _Builder:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.diagnostics: list[Diagnostic] = []
        self.declare: dict[str, Callable[[Any], Any]] = {
            "System": self.system,
            "Import": self.import_,
            "Let": self.let,
            "Enum": self.enum,
            "Message": self.message,
            "Topic": self.topic,
            "Function": self.function,
            "Sag": self.sag,
            "Suc": self.suc,
            "Aip": self.aip,
            "Srm": self.srm,
            "Statechart": self.statechart,
            "Team": self.team,
            "Scenario": self.scenario,
            "Property": self.property,
        }

    # ---- pieces --------------------------------------------------------------------------------

    def all(self, make: Callable[[Any], _T | None], nodes: Iterable[Any]) -> tuple[_T, ...]:
        """What `make` makes of the nodes; junk, and what it cannot make, is left out."""
        made = (make(node) for node in nodes if not isinstance(node, str))
        return tuple(item for item in made if item is not None)

    def span(self, node: Any) -> Span:
        return Span(self.source, node._tx_position, node._tx_position_end)

    def spot(self, text: Token) -> Span:
        return Span(self.source, text.start, text.end)

    def name(self, text: Token) -> tree.Name:
        """A name that is used."""
        return tree.Name(str(text), Span(self.source, text.start, text.start + len(text)))

    def new_name(self, text: Token, kind: str, words: Sequence[str] = ()) -> tree.Name:
        """A name that is declared, and is none of the words of its block nor of those that no name can be."""
        return self.checked_name(text, kind, (*RESERVED, *BUILT_IN_TYPES, *words))

    def checked_name(self, text: Token, kind: str, words: Sequence[str]) -> tree.Name:
        """A name that is declared, and is none of `words`; the compiler refuses what no name can be."""
        made = self.name(text)
        if text in words:
            self.report(characters.WordAsName(made.text, kind, text in BUILT_IN_TYPES), made.span)
        return made

    def names(self, texts: Iterable[Token]) -> tuple[tree.Name, ...]:
        return tuple(self.name(text) for text in texts)

    def integer(self, text: Token) -> int | None:
        digits = text.replace(" ", "")
        if len(digits) > _LONGEST_INTEGER:
            self.report(characters.TooManyDigits(str(text)), self.spot(text))
            return None
        return int("".join(text.split()))

    def integer_number(self, text: Token) -> tree.Number | None:
        value = self.integer(text)
        return tree.Number(value, self.spot(text)) if value is not None else None

    def tried(self, make: Callable[[], _T]) -> _T | None:
        try:
            return make()
        except Malformed as malformed:
            self.diagnostics.append(malformed.diagnostic)
            return None

    def text(self, text: Token) -> tree.Text:
        return read_text(self.source, text)

    def duration(self, text: Token) -> tree.Duration | None:
        return self.tried(lambda: read_duration(self.source, text))

    def again(self, clause: str | None, first: Span, second: Span) -> None:
        """E114 for a clause that begins with the same word as one before it; a requirement has no word."""
        self.report(problems.SaidTwice(clause), second, (Related(first, "first said here"),))

    def report(
        self, problem: Problem, span: Span, related: tuple[Related, ...] = (), fix: str | None = None
    ) -> None:
        self.diagnostics.append(Diagnostic(problem, span, related, fix))

    # ---- the file ------------------------------------------------------------------------------

    def declaration(self, node: Any) -> tree.Declaration | None:
        made: tree.Declaration | None = self.declare[type(node).__name__](node)
        return made

    def system(self, node: Any) -> tree.System:
        return tree.System(self.new_name(node.name, "system"), self.span(node))

    def import_(self, node: Any) -> tree.Import:
        target = self.text(node.path) if node.path else self.name(node.library)
        return tree.Import(target, self.span(node))

    def let(self, node: Any, words: Sequence[str] = ()) -> tree.Let | None:
        name = self.checked_name(node.name, "let", words)
        expression = self.tried(lambda: read_expression(self.source, node.tokens))
        return tree.Let(name, expression, self.span(node)) if expression is not None else None

    def var(self, node: Any, words: Sequence[str] = ()) -> tree.Var:
        name = self.checked_name(node.name, "variable", words)
        initial = self.tried(lambda: read_expression(self.source, node.tokens)) if node.tokens else None
        return tree.Var(name, self.name(node.type), initial, self.span(node))

    # ---- messages ------------------------------------------------------------------------------

    def enum(self, node: Any) -> tree.Enum:
        name = self.name(node.name)

        def constant(entry: Any) -> tree.EnumConstant:
            number = self.integer(entry.number) if entry.number else None
            return tree.EnumConstant(self.name(entry.name), number, self.span(entry))

        return tree.Enum(name, self.all(constant, node.constants), self.span(node))

    def message(self, node: Any) -> tree.Message:
        name = self.checked_name(node.name, "message", COMM_TYPES)

        def field(entry: Any) -> tree.Field:
            number = self.integer(entry.number) if entry.number else None
            return tree.Field(
                str(entry.label or ""),
                self.name(entry.type),
                self.name(entry.name),
                number,
                self.span(entry),
            )

        return tree.Message(name, self.all(field, node.fields), self.span(node))

    def topic(self, node: Any) -> tree.Topic:
        name = self.name(node.name)
        under = self.name(node.under[0]) if node.under else None
        radio = self.integer_number(node.radio[0]) if node.radio else None
        for clause, given in (("under", node.under), ("radio", node.radio)):
            if len(given) > 1:
                self.again(clause, self.spot(given[0]), self.spot(given[1]))
        return tree.Topic(name, under, radio, self.all(self.topic_entry, node.entries), self.span(node))

    def topic_entry(self, node: Any) -> tree.TopicEntry:
        sources: tuple[tree.Name, ...] = ()
        every: tree.Duration | None = None
        flags: set[str] = set()
        said = _Once(self)
        for clause in node.clauses:
            match type(clause).__name__:
                case "TopicFrom":
                    said.check("from", self.span(clause))
                    sources = self.names(clause.sources)
                case "TopicEvery":
                    said.check("every", self.span(clause))
                    every = self.duration(clause.every)
                case _:
                    said.check(str(clause.flag), self.span(clause))
                    flags.add(str(clause.flag))
        return tree.TopicEntry(
            self.name(node.comm),
            self.names(node.messages),
            sources,
            every,
            "queued" in flags,
            "persist" in flags,
            self.span(node),
        )

    def function(self, node: Any) -> tree.Function:
        def parameter(entry: Any) -> tree.Parameter:
            return tree.Parameter(
                self.name(entry.type), self.new_name(entry.name, "parameter"), self.span(entry)
            )

        return tree.Function(
            self.name(node.name),
            self.all(parameter, node.parameters),
            self.name(node.result),
            self.text(node.target),
            self.span(node),
        )

    # ---- requirements --------------------------------------------------------------------------

    def sag(self, node: Any) -> tree.Sag:
        return tree.Sag(self.all(self.actor, node.actors), self.span(node))

    def actor(self, node: Any) -> tree.Actor:
        return tree.Actor(
            self.new_name(node.name, "actor", ("actor", "goal")),
            self.all(self.goal, node.goals),
            self.span(node),
        )

    def goal(self, node: Any) -> tree.Goal:
        depends: tuple[tree.Name, ...] = ()
        requirements: tree.Text | None = None
        said = _Once(self)
        for clause in node.clauses:
            if type(clause).__name__ == "Depends":
                said.check("depends on", self.span(clause))
                depends = self.names(clause.actors)
            else:
                said.check(None, self.span(clause))
                requirements = self.text(clause.text)
        return tree.Goal(
            self.new_name(node.name, "goal", ("goal", "depends")), depends, requirements, self.span(node)
        )

    def suc(self, node: Any) -> tree.Suc:
        entries = [entry for entry in node.entries if not isinstance(entry, str)]
        roles = self.all(self.roles, (entry for entry in entries if type(entry).__name__ == "Roles"))
        usecases = self.all(self.usecase, (entry for entry in entries if type(entry).__name__ == "UseCase"))
        return tree.Suc(roles, usecases, self.span(node))

    def roles(self, node: Any) -> tree.Roles:
        type_ = self.name(node.type) if node.type else None
        return tree.Roles(
            tuple(self.new_name(text, "role", ("role", "usecase")) for text in node.names),
            type_,
            self.span(node),
        )

    def usecase(self, node: Any) -> tree.UseCase:
        lists: dict[str, tuple[tree.Name, ...]] = {}
        requirements: tree.Text | None = None
        said = _Once(self)
        for clause in node.clauses:
            match type(clause).__name__:
                case "By":
                    said.check("by", self.span(clause))
                    lists["by"] = self.names(clause.roles)
                case "Includes":
                    said.check("includes", self.span(clause))
                    lists["includes"] = self.names(clause.usecases)
                case "Realises":
                    said.check("realises", self.span(clause))
                    lists["realises"] = self.names(clause.names)
                case _:
                    said.check(None, self.span(clause))
                    requirements = self.text(clause.text)
        return tree.UseCase(
            self.new_name(node.name, "use case", ("role", "usecase", "by", "includes", "realises")),
            lists.get("by", ()),
            lists.get("includes", ()),
            lists.get("realises", ()),
            requirements,
            self.span(node),
        )

    # ---- protocols -----------------------------------------------------------------------------

    def aip(self, node: Any) -> tree.Aip:
        words = BLOCKS["JunkAip"].words
        kinds = _by_kind(node.entries)
        return tree.Aip(
            self.new_name(node.name, "protocol"),
            self.all(self.participant, kinds["Participant"]),
            tuple(self.text(entry.text) for entry in kinds["Outcome"]),
            self.all(lambda entry: self.let(entry, words), kinds["Let"]),
            self.all(self.clause, kinds["Clause"]),
            self.all(self.control, kinds["Control"]),
            self.span(node),
        )

    def participant(self, node: Any) -> tree.Participant:
        words = BLOCKS["JunkParticipant"].words
        kinds = _by_kind(node.entries)
        helpers = tuple(word for word in words if word != "process")
        return tree.Participant(
            self.new_name(node.name, "participant", BLOCKS["JunkAip"].words),
            self.multiplicity(node) if node.least else None,
            tuple(self.text(entry.text) for entry in kinds["Engage"]),
            self.all(lambda entry: self.var(entry, words), kinds["Var"]),
            self.all(lambda entry: self.let(entry, words), kinds["Let"]),
            self.agent_messages(kinds["Sends"]),
            self.agent_messages(kinds["Receives"]),
            self.all(lambda entry: self.formula(entry, helpers), kinds["Process"]),
            self.span(node),
        )

    def multiplicity(self, node: Any) -> tree.Multiplicity | None:
        least = self.integer(node.least)
        most = least
        if node.most == "*":
            most = None
        elif node.most:
            most = self.integer(node.most)
            if most is None:
                return None
        if least is None:
            return None
        end = node.most or node.least
        span = Span(self.source, node.least.start, end.end)
        if most is not None and (most < least or most == 0):
            self.report(problems.EmptyMultiplicity(least, most), span)
            return None
        return tree.Multiplicity(least, most, span)

    def agent_messages(self, entries: Iterable[Any]) -> tuple[tree.AgentMessage, ...]:
        return tuple(
            tree.AgentMessage(self.name(item.performative), self.name(item.message), self.span(item))
            for entry in entries
            for item in entry.messages
        )

    def formula(self, node: Any, words: Sequence[str] = ()) -> tree.NamedFormula | None:
        name = self.new_name(node.name, "formula", words)
        formula = self.tried(lambda: read_formula(self.source, node.tokens))
        parameters = self.all(self.formula_parameter, node.parameters)
        if formula is None:
            return None
        self.holes(node.tokens)
        return tree.NamedFormula(name, formula, self.span(node), parameters)

    def holes(self, tokens: Sequence[Token]) -> None:
        """E109 for each operator of a formula that is still to be chosen."""
        for token in tokens:
            if token == HOLE:
                written = PLACEHOLDER.match(self.source.text, token.start)
                end = written.end() if written is not None else token.end
                usual = tuple((item.value, item.row.meaning) for item in USUAL)
                self.report(problems.OperatorToChoose(usual), Span(self.source, token.start, end))

    def formula_parameter(self, node: Any) -> tree.FormulaParameter:
        name = self.new_name(node.name, "parameter")
        return tree.FormulaParameter(name, self.name(node.type) if node.type else None, self.span(node))

    def clause(self, node: Any) -> tree.Clause:
        rule = node.rule
        match type(rule).__name__:
            case "AtMost":
                count = _COUNTS.get(rule.count) or self.integer(rule.count) or 0
                return tree.Clause("at most", self.places(rule.first), (), count, None, self.span(node))
            case "LeadsTo":
                within = self.duration(rule.within) if rule.within else None
                return tree.Clause(
                    "leads to", self.places(rule.first), self.places(rule.second), 0, within, self.span(node)
                )
            case _:
                return tree.Clause(
                    "before", self.places(rule.first), self.places(rule.second), 0, None, self.span(node)
                )

    def places(self, node: Any) -> tuple[tree.Place, ...]:
        return tuple(
            tree.Place(self.name(item.name), self.name(item.at) if item.at else None, self.span(item))
            for item in node.places
        )

    # ---- control -------------------------------------------------------------------------------

    def control(self, node: Any) -> tree.Control:
        reactive = self.name(node.reactive).span if node.reactive else None
        return tree.Control(
            self.name(node.name), self.all(self.control_entry, node.entries), self.span(node), reactive
        )

    def control_entry(self, node: Any) -> tree.Way | tree.LabelledWay | None:
        return self.way(node) if type(node).__name__ == "Way" else self.labelled_way(node)

    def way(self, node: Any) -> tree.Way | None:
        formula = self.tried(lambda: read_formula(self.source, node.term))
        expression = self.transition(node) if formula is not None else None
        if formula is None or expression is None:
            return None
        if node.every:
            expression = replace(expression, every=self.duration(node.every))
        span = formula.span
        occurrence = None
        if node.occurrence:
            occurrence = self.integer(node.occurrence)
            span = Span(self.source, span.start, node.occurrence.end)
        return tree.Way(
            tree.Name(str(node.verb), self.spot(node.verb)),
            tree.Term(formula, occurrence, span),
            expression,
            self.span(node),
        )

    def labelled_way(self, node: Any) -> tree.LabelledWay | None:
        expression = self.transition(node)
        if expression is None:
            return None
        return tree.LabelledWay(self.name(node.source), self.name(node.target), expression, self.span(node))

    def transition(self, node: Any) -> tree.TransitionExpression | None:
        end = node._tx_position_end
        place = Span(self.source, end - 1, end)
        written = self.tried(lambda: read_transition(self.source, node.tokens, place))
        if written is not None and isinstance(written.condition, tree.Hole):
            self.report(problems.ConditionToWrite(), written.condition.span)
        return written

    # ---- roles ---------------------------------------------------------------------------------

    def srm(self, node: Any) -> tree.Srm:
        words = BLOCKS["JunkSrm"].words
        kinds = _by_kind(node.entries)
        return tree.Srm(
            self.new_name(node.name, "role"),
            tuple(self.plays(part) for entry in kinds["Plays"] for part in entry.parts),
            self.all(self.capability, kinds["Capability"]),
            self.all(lambda entry: self.var(entry, words), kinds["Var"]),
            self.all(lambda entry: self.let(entry, words), kinds["Let"]),
            self.all(self.formula, (formula for entry in kinds["Liveness"] for formula in entry.formulas)),
            self.all(self.activity, (item for entry in kinds["Activities"] for item in entry.activities)),
            self.all(self.module, (item for entry in kinds["Modules"] for item in entry.modules)),
            self.all(self.functionality, kinds["Functionality"]),
            self.all(self.control, kinds["Control"]),
            self.span(node),
            tuple(self.name(role) for entry in kinds["Inclusion"] for role in entry.roles),
            bool(node.abstract),
        )

    def plays(self, node: Any) -> tree.Plays:
        return tree.Plays(
            self.name(node.protocol),
            self.name(node.participant),
            self.new_name(node.alias, "participant", ("with",)) if node.alias else None,
            tuple(
                tree.Binding(self.name(item.abstract), self.name(item.own), self.span(item))
                for item in node.bindings
            ),
            self.span(node),
        )

    def capability(self, node: Any) -> tree.Capability:
        description = self.text(node.description) if node.description else None
        return tree.Capability(
            self.new_name(node.name, "capability"),
            description,
            self.names(node.activities),
            self.span(node),
        )

    def activity(self, node: Any) -> tree.Activity:
        uses: tuple[tree.Name, ...] = ()
        durations: dict[str, tree.Duration | None] = {}
        kind: tree.Name | None = None
        ends: tuple[tree.Name, ...] = ()
        reads: list[tree.ActivityRead] = []
        writes: list[tree.Path] = []
        simulated: Span | None = None
        said = _Once(self)
        for clause in node.clauses:
            match type(clause).__name__:
                case "Every":
                    said.check("every", self.span(clause))
                    durations["every"] = self.duration(clause.duration)
                case "Takes":
                    said.check("takes", self.span(clause))
                    durations["takes"] = self.duration(clause.duration)
                case "Simulated":
                    said.check("simulated", self.span(clause))
                    simulated = self.span(clause)
                case "Within":
                    said.check("within", self.span(clause))
                    durations["within"] = self.duration(clause.duration)
                case "Ends":
                    ends += self.names(clause.outcomes)
                case "As":
                    said.check("as", self.span(clause))
                    kind = self.name(clause.kind)
                case "Uses":
                    uses += self.names(clause.functionalities)
                case "Reads":
                    reads += [self.read(item) for item in clause.reads]
                case _:
                    writes += [read_path(self.source, path) for path in clause.paths]
        return tree.Activity(
            self.new_name(node.name, "activity"),
            uses,
            durations.get("every"),
            durations.get("takes"),
            kind,
            tuple(reads),
            tuple(writes),
            self.span(node),
            durations.get("within"),
            ends,
            self.all(self.activity_parameter, getattr(node, "parameters", ())),  # a module has none
            simulated,
        )

    def activity_parameter(self, node: Any) -> tree.ActivityParameter:
        name = self.new_name(node.name, "parameter")
        return tree.ActivityParameter(name, self.name(node.type), self.span(node))

    def module(self, node: Any) -> tree.Module:
        target = self.text(node.code.target) if node.code else None
        return tree.Module(self.activity(node), target, self.span(node))

    def read(self, node: Any) -> tree.ActivityRead:
        history = self.duration(node.history) if node.history else None
        return tree.ActivityRead(
            str(node.reach) if node.reach else "on",
            read_path(self.source, node.path),
            history,
            self.span(node),
        )

    def functionality(self, node: Any) -> tree.Functionality:
        texts: dict[str, tree.Text] = {}
        said = _Once(self)
        for entry in node.entries:
            if not isinstance(entry, str):
                said.check(str(entry.kind), self.span(entry))
                texts[str(entry.kind)] = self.text(entry.text)
        return tree.Functionality(
            self.new_name(node.name, "functionality"),
            texts.get("technology"),
            texts.get("permissions"),
            texts.get("environment"),
            texts.get("algorithm"),
            self.span(node),
        )

    # ---- statecharts ---------------------------------------------------------------------------

    def statechart(self, node: Any) -> tree.Statechart:
        words = BLOCKS["JunkChart"].words
        kinds = _by_kind(node.entries)
        return tree.Statechart(
            self.new_name(node.name, "statechart"),
            self.all(lambda entry: self.var(entry, words), kinds["Var"]),
            self.all(lambda entry: self.let(entry, words), kinds["Let"]),
            self.all(self.chart_node, kinds["ChartNode"]),
            self.all(
                self.chart_way, (entry for entry in node.entries if type(entry).__name__ in _CHART_WAYS)
            ),
            self.all(self.activity, (item for entry in kinds["Activities"] for item in entry.activities)),
            self.all(self.module, (item for entry in kinds["Modules"] for item in entry.modules)),
            self.span(node),
        )

    def chart_way(self, node: Any) -> tree.LabelledWay | tree.StandingWay | None:
        if type(node).__name__ == "LabelledWay":
            return self.labelled_way(node)
        expression = self.transition(node)
        if expression is None:
            return None
        return tree.StandingWay(self.name(node.verb), self.name(node.state), expression, self.span(node))

    def chart_node(self, node: Any) -> tree.ChartNode:
        name: tree.Name | tree.Text | None = None
        if node.name:
            name = self.text(node.name) if node.name[0] == '"' else self.name(node.name)
        return tree.ChartNode(
            self.name(node.label),
            self.name(node.type),
            name,
            self.name(node.activity) if node.activity else None,
            self.span(node),
        )

    # ---- deployment and verification -----------------------------------------------------------

    def team(self, node: Any) -> tree.Team:
        return tree.Team(
            self.new_name(node.name, "team"), self.all(self.agents, node.entries), self.span(node)
        )

    def agents(self, node: Any) -> tree.TeamAgents:
        names = tuple(
            (self.new_name(item.name, "agent"), self.range(item) if item.least else None)
            for item in node.names
        )
        settings = self.all(self.setting, node.settings)
        return tree.TeamAgents(names, self.name(node.role), self.span(node), settings)

    def setting(self, node: Any) -> tree.Setting | None:
        value = self.tried(lambda: read_expression(self.source, node.tokens))
        return tree.Setting(self.name(node.name), value, self.span(node)) if value is not None else None

    def range(self, node: Any) -> tuple[int, int] | None:
        least, most = self.integer(node.least), self.integer(node.most)
        if least is None or most is None:
            return None
        if most < least:
            span = Span(self.source, node.least.start, node.most.end)
            self.report(problems.EmptyRange(least, most), span, fix=f"{most}..{least}")
            return None
        return least, most

    def scenario(self, node: Any) -> tree.Scenario:
        statements: list[list[tree.Name]] = []
        depth = 0
        for name, first_on_line in self.body(node):
            begins = depth == 0 and first_on_line and (name.text[0].isalpha() or name.text[0] == "_")
            if begins or not statements:
                statements.append([])
            statements[-1].append(name)
            depth += (name.text in ("{", "(", "[")) - (name.text in ("}", ")", "]"))
        return tree.Scenario(self.text(node.title), tuple(map(tuple, statements)), self.span(node))

    def property(self, node: Any) -> tree.Property:
        return tree.Property(
            self.text(node.title), tuple(name for name, _ in self.body(node)), self.span(node)
        )

    def body(self, node: Any) -> list[tuple[tree.Name, bool]]:
        """The tokens between the braces, and whether each is the first on its line."""
        found: list[tuple[tree.Name, bool]] = []
        text = self.source.text
        todo = list(reversed(node.tokens))
        end = node.title.end
        while todo:
            item = todo.pop()
            if not isinstance(item, Token):
                todo += [item.close, *reversed(item.tokens), item.open]
                continue
            found.append((tree.Name(str(item), self.spot(item)), "\n" in text[end : item.start]))
            end = item.end
        return found


class _Once:
    """Reports what is said twice in one entry."""

    def __init__(self, builder: _Builder) -> None:
        self.builder = builder
        self.said: dict[str | None, Span] = {}

    def check(self, clause: str | None, span: Span) -> None:
        first = self.said.setdefault(clause, span)
        if first is not span:
            self.builder.again(clause, first, span)


class _Kinds(dict[str, list[Any]]):
    def __missing__(self, kind: str) -> list[Any]:
        return []


_CHART_WAYS = ("LabelledWay", "StandingWay")
"""The transitions of a `statechart`; their order counts."""


def _by_kind(entries: Iterable[Any]) -> _Kinds:
    kinds = _Kinds()
    for entry in entries:
        if not isinstance(entry, str):
            kinds.setdefault(type(entry).__name__, []).append(entry)
    return kinds
