"""Documents: requirements as the text of `sag`, `suc`, `aip` and `srm` blocks.

A line that the compiler refuses is written as a comment, and listed as something to decide.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field

from aseme_dsl.interop.emf.identifiers import Names
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.interop.emf.requirements import (
    ForeignActivity,
    ForeignFormula,
    ForeignProtocol,
    ForeignRole,
    ForeignSrmRole,
    Requirements,
)
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_TOKEN = re.compile(r"\?\w*\?|[A-Za-z_]\w*(?:-\w+)*|\|\||[0-9]+|\S", re.ASCII)
_SIGNS = frozenset(["||", "|", ".", "~", "*", "+", "(", ")", "[", "]", "?", "ω"])


@dataclass(slots=True)
class Documents:
    """The blocks of several models. `problems` are the compiler's, by the key of a line."""

    requirements: Requirements
    problems: dict[str, str] = field(default_factory=dict)
    names: Names = field(default_factory=Names)
    functionalities: Names = field(default_factory=Names)
    modules: tuple[str, ...] = ()
    """What the first role gets that has no chart."""

    def name(self, text: str) -> str:
        """The same name for the same text everywhere: a role is called like its actor."""
        return self.names.of(text, "unnamed")

    def roles(self) -> set[str]:
        """The names of the roles that have an `srm`."""
        return {self.name(role.name) for role in self.requirements.srm_roles}

    def written(self, charts: frozenset[str] = frozenset()) -> DocumentText:
        """All blocks. The formulas of roles that are `charts` come from these."""
        return _Writer(self, charts).written()


@dataclass(frozen=True, slots=True)
class DocumentText:
    """Lines, the keys of those that may be refused, and what became of each element."""

    lines: tuple[str, ...]
    keys: Mapping[int, str]
    rows: tuple[Row, ...]
    inside: Mapping[str, tuple[tuple[str, ...], Mapping[int, str]]] = field(default_factory=dict)
    """What roles that are charts get besides, likewise."""
    has_modules: bool = False


class _Writer:
    def __init__(self, documents: Documents, charts: frozenset[str]) -> None:
        self.charts = charts
        self.inside: dict[str, tuple[tuple[str, ...], Mapping[int, str]]] = {}
        self.documents = documents
        self.found = documents.requirements
        self.name = documents.name
        self.lines: list[str] = []
        self.keys: dict[int, str] = {}
        self.rows: list[Row] = []
        self.has_modules = False

    def written(self) -> DocumentText:
        if self.found.actors or self.found.goals:
            self._sag()
        if self.found.roles or self.found.usecases:
            self._suc()
        for protocol in _merged(self.found.protocols):
            if self.name(protocol.name) in self.charts:
                self._charted(protocol)
            else:
                self._aip(protocol)
        for role in self.found.srm_roles:
            name = self.name(role.name)
            if name in self.charts:
                self._beside(name, role)
            else:
                self._srm(name, role)
        for what, place, why in self.found.lost:
            self.rows.append(Row(Fate.LEFT_OUT, what, place, why))
        return DocumentText(tuple(self.lines), self.keys, tuple(self.rows), self.inside, self.has_modules)

    def _row(self, what: str, text: str, place: Span, now: str) -> None:
        name = self.name(text)
        fate = Fate.KEPT if name == text else Fate.CHANGED
        self.rows.append(Row(fate, f"{what} {text}", place, now if name == text else f"{now}; called {name}"))

    def _line(self, key: str, text: str, what: str, name: str, place: Span, now: str) -> None:
        """A line that the compiler may refuse: then it is a comment."""
        problem = self.documents.problems.get(key)
        if problem is not None:
            self.lines.append(f"  // {text.strip()}")
            self.rows.append(Row(Fate.HOLE, f"{what} {name}", place, f"{problem}; a comment in {now}"))
            return
        self.keys[len(self.lines)] = key
        self.lines.append(text)
        self._row(what, name, place, now)

    # ---- goals and use cases -----------------------------------------------------------------

    def _sag(self) -> None:
        self.lines.append("sag {")
        owners = dict.fromkeys([actor.name for actor in self.found.actors])
        for actor in self.found.actors:
            self._row("actor", actor.name, actor.place, "actor")
        for goal in self.found.goals:
            if not goal.depender:
                self.rows.append(Row(Fate.LEFT_OUT, f"goal {goal.name}", goal.place, "no actor has it"))
            owners |= {name: None for name in (goal.depender, *goal.dependees) if name}
        for name in owners:
            self.lines.append(f"  actor {self.name(name)} {{")
            for goal in self.found.goals:
                if goal.depender and goal.depender == name:
                    others = [self.name(other) for other in goal.dependees if other != name]
                    depends = f" depends on {', '.join(others)}" if others else ""
                    text = f"    goal {self.name(goal.name)}{depends}{_quoted(goal.text)}"
                    now = f"goal of {self.name(name)}"
                    self._line(f"goal.{name}.{goal.name}", text, "goal", goal.name, goal.place, now)
            self.lines.append("  }")
        self.lines.append("}")

    def _suc(self) -> None:
        self.lines.append("suc {")
        for role in self.found.roles:
            self._role(role)
        for item in self.found.usecases:
            roles = f" by {', '.join(map(self.name, item.roles))}" if item.roles else ""
            parts = f" includes {', '.join(map(self.name, item.includes))}" if item.includes else ""
            text = f"  usecase {self.name(item.name)}{roles}{parts}{_quoted(item.text)}"
            self._line(f"usecase.{item.name}", text, "use case", item.name, item.place, "usecase")
        self.lines.append("}")

    def _role(self, role: ForeignRole) -> None:
        kind = f" : {role.type}" if role.type else ""
        self.lines.append(f"  role {self.name(role.name)}{kind}")
        self._row("role", role.name, role.place, f"role{kind}" if kind else "role; its type is not known")

    # ---- protocols ---------------------------------------------------------------------------

    def _charted(self, protocol: ForeignProtocol) -> None:
        """A protocol whose statechart says all but the rules and outcomes."""
        for member in protocol.participants:
            now = f"participant of {self.name(protocol.name)}; the formulas of its statechart count"
            self.rows.append(Row(Fate.CHANGED, f"participant {member.name}", member.place, now))

    def _aip(self, protocol: ForeignProtocol) -> None:
        """A protocol. If the compiler refuses what no line of its own says, all of it is a comment."""
        name = self.name(protocol.name)
        key = f"aip.{name}"
        before, self.lines, keys, self.keys = self.lines, [], self.keys, {}
        rows = len(self.rows)
        self._whole_aip(protocol, name)
        lines, own = self.lines, self.keys
        self.lines, self.keys = before, keys
        problem = self.documents.problems.get(key)
        if problem is None:
            self.keys |= {len(before) + number: own.get(number, key) for number in range(len(lines))}
            self.lines += lines
            return
        self.lines += [f"// {line}" for line in lines]
        self.rows[rows:] = [row for row in self.rows[rows:] if row.fate is Fate.HOLE]
        self.rows.append(Row(Fate.HOLE, f"protocol {protocol.name}", protocol.place, f"{problem}; a comment"))
        for member in protocol.participants:
            now = f"a comment, as all of {name}"
            self.rows.append(Row(Fate.HOLE, f"participant {member.name}", member.place, now))

    def _whole_aip(self, protocol: ForeignProtocol, name: str) -> None:
        self.lines.append(f"aip {name} {{")
        self._row("protocol", protocol.name, protocol.place, f"aip {name}")
        outcomes: dict[str, Span] = {}
        for member in protocol.participants:
            own = self.name(member.name)
            self.lines.append(f"  participant {own} {{")
            if member.rule:
                self.lines.append(f"    engage{_quoted(member.rule)}")
            self._row("participant", member.name, member.place, f"participant of {name}")
            for number, formula in enumerate(member.liveness):
                left = "process" if number == 0 else self.name(formula.name)
                self._formula(f"{name}.{own}.{number}", left, formula, member.name, member.place)
            if not member.liveness:
                why = "it has no liveness; write `process = …`"
                self.rows.append(Row(Fate.HOLE, f"process of {member.name}", member.place, why))
            self.lines.append("  }")
            if member.outcomes:
                outcomes.setdefault(member.outcomes, member.place)
        for text, place in outcomes.items():
            self.lines.append(f"  outcome{_quoted(text)}")
            self.rows.append(Row(Fate.KEPT, f"outcome {text}", place, f"outcome of {name}"))
        self.lines.append("}")

    def _formula(self, key: str, left: str, formula: ForeignFormula, owner: str, place: Span) -> None:
        text = formula_text(formula.text, self.name)
        what = f"formula {formula.name or left} of {owner}"
        if text is None:
            self.lines.append(f"    // {left} = {formula.text}")
            self.rows.append(Row(Fate.HOLE, what, place, "its text is not a formula; it is a comment"))
        else:
            problem = self.documents.problems.get(key)
            if problem is None:
                self.keys[len(self.lines)] = key
            self.lines.append(f"    {'// ' if problem else ''}{left} = {text}")
            fate = Fate.HOLE if problem or "?" in text else Fate.KEPT
            missing = "an operator is still to be chosen" if fate is Fate.HOLE else f"formula {left}"
            self.rows.append(Row(fate, what, place, f"{problem}; a comment" if problem else missing))

    # ---- roles -------------------------------------------------------------------------------

    def _beside(self, name: str, role: ForeignSrmRole) -> None:
        """What a role has besides its chart."""
        before, self.lines, keys, self.keys = self.lines, [], self.keys, {}
        self._row("role", role.name, role.place, f"srm {name}")
        for formula in role.liveness:
            what = f"formula {formula.name} of {role.name}"
            self.rows.append(Row(Fate.CHANGED, what, role.place, "the formulas of its statechart count"))
        self._capabilities(name, role)
        self._activities(name, role.activities)
        self.inside[name] = tuple(self.lines), self.keys
        self.lines, self.keys = before, keys

    def _capabilities(self, name: str, role: ForeignSrmRole) -> None:
        for item in role.capabilities:
            uses = f" = {', '.join(map(self.name, item.activities))}" if item.activities else ""
            text = f"  capability {self.name(item.name)}{_quoted(item.text)}{uses}"
            self._line(f"{name}.c.{item.name}", text, "capability", item.name, item.place, f"srm {name}")

    def _srm(self, name: str, role: ForeignSrmRole) -> None:
        formulas = [(self.name(formula.name) if formula.name else name, formula) for formula in role.liveness]
        parts = self._parts(formulas)
        written = [item for item in formulas if item[0] not in parts and item[1].text]
        head = f"role {role.name}"
        if not written or f"{name}.0" in self.documents.problems:
            self.lines += [f"// srm {name}: its liveness is still to be written", ""]
            self.rows.append(Row(Fate.HOLE, head, role.place, "it has no formula: write its `srm`"))
            for _, formula in formulas:
                self.lines.append(f"// {formula.name} = {formula.text}")
            return
        self.lines.append(f"srm {name} {{")
        self._row("role", role.name, role.place, f"srm {name}")
        for participant, protocol in parts.items():
            self.lines.append(f"  plays {protocol}.{participant}")
            if participant in dict(formulas):
                now = f"the process of {protocol}.{participant}, which it plays"
                self.rows.append(Row(Fate.CHANGED, f"formula {participant} of {role.name}", role.place, now))
            else:
                now = "its formulas name the participant"
                self.rows.append(Row(Fate.ADDED, f"plays {protocol}.{participant}", role.place, now))
        self._capabilities(name, role)
        self.lines.append("  liveness {")
        for number, (left, formula) in enumerate(written):
            self._formula(f"{name}.{number}", left, formula, role.name, role.place)
        self.lines.append("  }")
        self._activities(name, role.activities)
        if not self.has_modules:
            self.lines += [f"  {line}" for line in self.documents.modules]
            self.has_modules = True
        self.lines.append("}")

    def _parts(self, formulas: Sequence[tuple[str, ForeignFormula]]) -> dict[str, str]:
        """The participants that a role plays: its formulas name them, with the protocol's own process."""
        places: dict[str, list[tuple[str, str]]] = {}
        for protocol in self.found.protocols:
            if f"aip.{self.name(protocol.name)}" in self.documents.problems:
                continue
            for member in protocol.participants:
                process = formula_text(member.liveness[0].text, self.name) if member.liveness else None
                if process:
                    places.setdefault(self.name(member.name), []).append((self.name(protocol.name), process))
        found: dict[str, str] = {}
        own = {left: formula_text(formula.text, self.name) for left, formula in formulas[1:]}
        used = {word for _, formula in formulas for word in _TOKEN.findall(formula.text)}
        for name, known in places.items():
            if len(known) == 1 and name in used and own.get(name, known[0][1]) == known[0][1]:
                found[name] = known[0][0]
        return found

    def _activities(self, role: str, activities: Iterable[ForeignActivity]) -> None:
        uses: dict[str, ForeignActivity] = {}
        self.lines.append("  activities {")
        for item in activities:
            functionality, clause = item.functionality, ""
            if functionality is not None:
                title = functionality.description or f"functionality_{functionality.place.line}"
                own = self.documents.functionalities.of(" ".join(title.split()[:5]), "functionality")
                uses.setdefault(own, item)
                clause = f" uses {own}"
            text = f"    {self.name(item.name)}{clause}"
            self._line(f"{role}.a.{item.name}", text, "activity", item.name, item.place, f"srm {role}")
        self.lines.append("  }")
        for own, item in uses.items():
            assert item.functionality is not None
            if item.functionality.description:
                self.lines.append(f"  // {item.functionality.description}")
            self.lines.append(f"  functionality {own} {{")
            self.lines += [f"    {word}{_quoted(text)}" for word, text in item.functionality.entries]
            self.lines.append("  }")
            what = f"functionality {item.functionality.description}".rstrip()
            self.rows.append(Row(Fate.KEPT, what, item.functionality.place, f"functionality {own}"))


def formula_text(text: str, name: Callable[[str], str]) -> str | None:
    """A formula of the ASEME IDE in the language, None if it is none. `name` gives each name its own."""
    parts: list[str] = []
    for word in _TOKEN.findall(text):
        if word.isascii() and (word[0].isalpha() or word[0] == "_"):
            parts.append(name(word))
        elif word.startswith("?"):
            parts.append("?")
        elif word in _SIGNS or word.isdigit():
            parts.append(word)
        else:
            return None
    return " ".join(parts) or None


def _merged(protocols: Iterable[ForeignProtocol]) -> Iterable[ForeignProtocol]:
    """Each protocol once."""
    return {protocol.name: protocol for protocol in protocols}.values()


def _quoted(text: str) -> str:
    if not text:
        return ""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f' "{escaped}"'


__all__ = ["DocumentText", "Documents", "formula_text"]
