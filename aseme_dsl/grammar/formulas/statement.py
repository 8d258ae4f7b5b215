"""From the tokens of a scenario or property to its statements.

Statements are separated by the words with which they begin, not by lines. Behind a mistake, reading continues
at the next line that begins with a word: one mistake gives one message.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

from aseme_dsl.diagnostics import Diagnostic, closest
from aseme_dsl.diagnostics.problems.scenarios import statements as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.expression import BINDING, operation, read_path, read_text, value
from aseme_dsl.grammar.formulas.reader import DEEPEST, Reader, is_word
from aseme_dsl.grammar.formulas.words import Malformed
from aseme_dsl.grammar.text import statements as nodes
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.network_words import NetworkWordsError, read_network
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.runtime.message.acl import PERFORMATIVES
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.source import Source, Span

_COMPARISON = 3
"""How tightly comparisons bind: what binds less joins conditions."""
_NUMBERS = {"one": 1, "two": 2, "three": 3}
_AND = ("and", "&&")
_OR = ("or", "||")
_NETWORK = ("delay", "loss", "reorder")
_ANY = ("any", "some", "every")
SIMULATED = ("real", "takes", "ends", "fails", "writes", "sends", "sets")
"""What may stand behind `activity A`."""
_HEARD = ("sent", "received", "message", "untaken")
_VERBS = ("receives", "raises", "loses", "ends", "does", "gets", "misses", "computes")
"""What an agent may do at a moment."""
DONE = ("sets", "writes", "sends", "prepares", "takes")
"""What may stand behind `robot1 ends A`."""

_Made = TypeVar("_Made")


def read_statements(
    source: Source, words: Sequence[tree.Name], in_property: bool = False
) -> tuple[tuple[nodes.Statement, ...], tuple[Diagnostic, ...]]:
    """The statements that the words spell, and what is wrong with the others (E102, E103, E108, E117)."""
    made, _, found = _read(source, [token(word.text, word.span.start) for word in words], in_property)
    return made, found


def statement_starts(source: Source, words: Sequence[Token], in_property: bool) -> frozenset[int] | None:
    """Where statements begin; None if something is wrong."""
    _, starts, found = _read(source, words, in_property)
    return None if found else starts


def _read(
    source: Source, words: Sequence[Token], in_property: bool
) -> tuple[tuple[nodes.Statement, ...], frozenset[int], tuple[Diagnostic, ...]]:
    reader = Reader(source, list(words))
    made: list[nodes.Statement] = []
    found: list[Diagnostic] = []
    starts: list[int] = []
    while reader.index < len(reader.tokens):
        begin = reader.index
        starts.append(reader.tokens[begin].start)
        reader.depth = 0
        try:
            made.append(_statement(reader, in_property))
        except Malformed as problem:
            found.append(problem.diagnostic)
            reader.index = _next_line(reader, begin, problem.diagnostic.span)
    return tuple(made), frozenset(starts), tuple(found)


def _next_line(reader: Reader, begin: int, wrong: Span | None) -> int:
    """Where the next statement may begin: at the first line with a word, in no brace, from the mistake on.

    `wrong` is where the mistake stands, which is often the word that has just been taken. A line that is
    indented deeper than the statement with the mistake continues it.
    """
    depth = 0
    text = reader.source.text
    width = _indentation(text, reader.tokens[begin])
    for index in range(begin, len(reader.tokens)):
        word = reader.tokens[index]
        new = index > begin and "\n" in text[reader.tokens[index - 1].end : word.start]
        is_wrong = index == reader.index - 1 and wrong is not None and word.start == wrong.start
        is_statement = new and depth <= 0 and is_word(word) and (index >= reader.index or is_wrong)
        if is_statement and (word in _STARTS or _indentation(text, word) <= width):
            return index
        depth += (word == "{") - (word == "}")
    return len(reader.tokens)


def _indentation(text: str, word: Token) -> int:
    """The column of the first word on the line of `word`."""
    line = text[text.rfind("\n", 0, word.start) + 1 : word.start]
    return len(line) - len(line.lstrip())


# ---- pieces -----------------------------------------------------------------------------------------


def _ahead(reader: Reader, steps: int = 1) -> str:
    place = reader.index + steps
    return reader.tokens[place] if place < len(reader.tokens) else ""


def _wrong(reader: Reader, *wanted: Wanted | str) -> Malformed:
    """Something else stands here than what is wanted; a word on the next line is another statement."""
    previous = reader.tokens[reader.index - 1] if reader.index else None
    found = reader.tokens[reader.index] if reader.index < len(reader.tokens) else None
    is_other = found is None or (is_word(found) and _is_on_next_line(reader, previous, found))
    if previous is not None and is_other:
        problem = problems.UnexpectedInStatement(wanted, previous, None)
        return Malformed(Diagnostic(problem, reader.span(previous)))
    assert found is not None  # there is a first word
    near = closest(found, [word for word in wanted if isinstance(word, str)]) if is_word(found) else None
    problem = problems.UnexpectedInStatement(wanted, previous, found, near)
    return Malformed(Diagnostic(problem, reader.span(found), fix=near))


def _is_on_next_line(reader: Reader, previous: Token | None, found: Token) -> bool:
    return previous is not None and "\n" in reader.source.text[previous.end : found.start]


def _need(reader: Reader, *words: str) -> Token:
    if reader.next not in words:
        raise _wrong(reader, *words)
    return reader.take()


def _close(reader: Reader, sign: str, opener: Token) -> None:
    """The sign that closes what `opener` opens."""
    if reader.next != sign:
        diagnostic = _wrong(reader, sign).diagnostic
        raise Malformed(replace(diagnostic, related=(reader.still_open(opener),)))
    reader.take()


_ALIASED = (Wanted.ROLE, Wanted.STATE, Wanted.ACTIVITY)
"""What may stand behind an alias."""


def _name(reader: Reader, wanted: Wanted) -> tree.Name:
    if not is_word(reader.next) or reader.next.count(".") > (wanted in _ALIASED):
        raise _wrong(reader, wanted)
    taken = reader.take()
    return tree.Name(str(taken), reader.span(taken))


def _path(reader: Reader, wanted: Wanted) -> tree.Path:
    if not is_word(reader.next):
        raise _wrong(reader, wanted)
    return read_path(reader.source, reader.take())


def _duration(reader: Reader) -> tree.Duration:
    at = reader.index
    if reader.next[:1].isdigit():
        found = value(reader)
        if isinstance(found, tree.Duration):
            return found
        if isinstance(found, tree.Number) and found.value == 0:
            return tree.Duration(0, found.span)
    reader.index = at
    if is_word(reader.next) and re.search(rf"\bgiven\s+{re.escape(reader.next)}\b", reader.source.text):
        before = reader.tokens[at - 1] if at else None
        word = reader.tokens[at]
        raise reader.error(problems.InputAsTime((Wanted.DURATION,), before, word), word)
    raise _wrong(reader, Wanted.DURATION)


def _times(reader: Reader) -> nodes.Lasts:
    """`2s`, `1s..3s` or `normal(2s, 300ms)`."""
    if reader.next == "normal":
        reader.take()
        opener = _need(reader, "(")
        mean = _duration(reader)
        _need(reader, ",")
        deviation = _duration(reader)
        _close(reader, ")", opener)
        return nodes.Lasts(mean, deviation, is_normal=True)
    least = _duration(reader)
    if reader.next != "..":
        return nodes.Lasts(least, least)
    reader.take()
    return nodes.Lasts(least, _duration(reader))


def _count(reader: Reader) -> int:
    text = reader.next
    if text in _NUMBERS or text.isdecimal():
        reader.take()
        return _NUMBERS[text] if text in _NUMBERS else int(text[:9])
    raise _wrong(reader, Wanted.COUNT)


def _several(reader: Reader, one: Callable[[Reader], _Made], sign: str = ",") -> tuple[_Made, ...]:
    found = [one(reader)]
    while reader.next == sign:
        reader.take()
        found.append(one(reader))
    return tuple(found)


def _agent(reader: Reader) -> tree.Name:
    """An agent, or `any`, `some`, `every` and a role."""
    if reader.next in _ANY and is_word(_ahead(reader)):
        reader.take()
        return _name(reader, Wanted.ROLE)
    return _name(reader, Wanted.AGENT_NAME)


def _which(reader: Reader) -> str:
    """The word before a role, which `_agent` passes over."""
    return str(reader.next) if reader.next in _ANY and is_word(_ahead(reader)) else ""


def _place(reader: Reader) -> tree.Place:
    name = _name(reader, Wanted.STATE)
    at = None
    if reader.next == "@":
        reader.take()
        at = _name(reader, Wanted.PARTICIPANT)
    return tree.Place(name, at, name.span if at is None else name.span.to(at.span))


def _places(reader: Reader) -> tuple[tree.Place, ...]:
    if reader.next != "(":
        return (_place(reader),)
    opener = reader.take()
    found = _several(reader, _place, "or")
    _close(reader, ")", opener)
    return found


def _fill(reader: Reader) -> tree.Fill:
    target = _path(reader, Wanted.MEMBER)
    _need(reader, "=")
    given = operation(reader)
    return tree.Fill(target, given, target.span.to(given.span))


def _message(reader: Reader) -> nodes.Filled:
    """`vision.state.Ball { visible = true }`"""
    begin = reader.tokens[min(reader.index, len(reader.tokens) - 1)].start
    performative = None
    if is_word(reader.next) and "." not in reader.next and is_word(_ahead(reader)):
        performative = _name(reader, Wanted.PERFORMATIVE)
    what = _path(reader, Wanted.MESSAGE)
    opener = _need(reader, "{")
    fills = []
    while reader.next not in ("}", ""):
        fills.append(_fill(reader))
        if reader.next in (",", ";"):
            reader.take()
    _close(reader, "}", opener)
    return nodes.Filled(performative, what, tuple(fills), reader.since(begin))


def _share(reader: Reader) -> nodes.Share | None:
    """`in 95% of 200 seeds` behind an expectation."""
    if reader.next != "in" or not _ahead(reader)[:1].isdigit():
        return None
    begin = reader.take().start
    percent = value(reader)
    if isinstance(percent, tree.Duration):
        reader.index -= 2  # `in 3s`, as `within 3s` says
        raise _wrong(reader, "within")
    _need(reader, "%")
    _need(reader, "of")
    seeds = value(reader)
    _need(reader, "seeds")
    return nodes.Share(percent, seeds, reader.since(begin))


# ---- conditions -------------------------------------------------------------------------------------


def _condition(reader: Reader) -> nodes.Condition:
    """Conditions between `and` and `or`; `and` binds more tightly."""
    alternatives: list[nodes.Condition] = []
    parts = [_negated(reader)]
    while reader.next in _AND or reader.next in _OR:
        if reader.take() in _OR:
            alternatives.append(_joined("and", parts))
            parts = []
        parts.append(_negated(reader))
    return _joined("or", [*alternatives, _joined("and", parts)])


def _joined(operator: str, parts: Sequence[nodes.Condition]) -> nodes.Condition:
    if len(parts) == 1:
        return parts[0]
    return nodes.Joined(operator, tuple(parts), parts[0].span.to(parts[-1].span))


def _negated(reader: Reader) -> nodes.Condition:
    signs = []
    while reader.next in ("!", "not"):
        signs.append(reader.take())
    part = _atom(reader)
    return nodes.Joined("not", (part,), reader.since(signs[0].start)) if len(signs) % 2 else part


def _atom(reader: Reader) -> nodes.Condition:
    if reader.index == len(reader.tokens):
        raise _wrong(reader, Wanted.CONDITION_OR_STATE)
    first = reader.tokens[reader.index]
    if first in _RULES and first not in _ANY and _ahead(reader) not in ("in", "has", "@"):
        raise _wrong(reader, Wanted.CONDITION_OR_STATE)
    if first == "(":
        return _grouped(reader)
    if first == "[":
        reader.take()
        inner = operation(reader)
        reader.need("]", first)
        return nodes.Holds(None, inner, reader.since(first.start))
    if first == "outcome" and _ahead(reader)[:1] == '"':
        reader.take()
        text = read_text(reader.source, reader.take())
        return nodes.Ended(text, reader.since(first.start))
    if first == "fault":
        reader.take()
        return nodes.Fault(reader.since(first.start))
    if first in _HEARD and is_word(_ahead(reader)):
        return _heard(reader)
    is_name = is_word(first) and "." not in first
    if first in _ANY or (is_name and _ahead(reader) in ("in", "has") and not _is_other_in(reader)):
        return _of_agent(reader)
    if is_name and _ahead(reader) not in ("(", "[") and BINDING.get(_ahead(reader), 0) < _COMPARISON:
        if first in ("true", "false"):
            return nodes.Holds(None, value(reader), reader.since(first.start))
        place = _place(reader)
        return nodes.InState(None, (place,), place.span)
    expression = operation(reader, _COMPARISON)
    return nodes.Holds(None, expression, expression.span)


def _is_other_in(reader: Reader) -> bool:
    """Whether the `in` behind a name begins `in 95% of 200 seeds`, or `in order X, Y`."""
    behind = _ahead(reader, 2)
    return _ahead(reader) == "in" and (
        behind[:1].isdigit() or (behind == "order" and _ahead(reader, 4) in (",", "@"))
    )


def _grouped(reader: Reader) -> nodes.Condition:
    """What stands in parentheses: conditions, or the beginning of an expression as `(a + b) < 3`."""
    begin, opener, depth = reader.index, reader.take(), reader.depth
    reader.depth += 1
    if reader.depth > DEEPEST + 1:
        raise reader.too_deep(opener)
    try:
        inner = _condition(reader)
        _close(reader, ")", opener)
        reader.depth = depth
        if BINDING.get(reader.next, 0) < _COMPARISON:
            return inner
        farthest, problem = begin, None
    except Malformed as raised:
        farthest, problem = reader.index, raised
    reader.index, reader.depth = begin, depth
    try:
        expression = operation(reader, _COMPARISON)
    except Malformed:
        if problem is None or reader.index > farthest:
            raise
        reader.index = farthest
        raise problem from None
    return nodes.Holds(None, expression, expression.span)


def _of_agent(reader: Reader) -> nodes.Condition:
    which = _which(reader)
    agent = _agent(reader)
    if _need(reader, "in", "has") == "in":
        places = _places(reader)
        return nodes.InState(agent, places, reader.since(agent.span.start), which)
    opener = _need(reader, "[")
    inner = operation(reader)
    reader.need("]", opener)
    return nodes.Holds(agent, inner, reader.since(agent.span.start), which)


def _heard(reader: Reader) -> nodes.Heard:
    verb = _name(reader, Wanted.MESSAGE)
    performative = None
    following = _ahead(reader)
    if "." not in reader.next and is_word(following) and "." not in following:
        # A type of message begins with a capital letter by custom, a performative never does.
        begins = _ahead(reader, 2) in (":", ",", "has", "fails")  # the next statement
        is_unknown = reader.next[0].islower() and following[0].isupper() and not begins
        if reader.next in PERFORMATIVES or is_unknown:
            performative = _name(reader, Wanted.PERFORMATIVE)
    what = _path(reader, Wanted.MESSAGE)
    called = None
    if is_word(reader.next) and (
        _ahead(reader) == "[" or (_ahead(reader) == "by" and is_word(_ahead(reader, 2)))
    ):
        called = _name(reader, Wanted.MESSAGE_NAME)
    agent, which = None, ""
    if reader.next == "by" and is_word(_ahead(reader)):
        reader.take()
        which = _which(reader)
        agent = _agent(reader)
    condition = None
    if reader.next == "[":
        opener = reader.take()
        condition = operation(reader)
        reader.need("]", opener)
    span = reader.since(verb.span.start)
    return nodes.Heard(verb, performative, what, called, agent, condition, span, which)


# ---- statements -------------------------------------------------------------------------------------


def _statement(reader: Reader, in_property: bool) -> nodes.Statement:
    first = reader.tokens[reader.index]
    following = _ahead(reader)
    is_name = following in (":", "in", "has", "@") and _ahead(reader, 2) != "order"
    if first in _RULES and not is_name:
        return _RULES[first](reader)
    if first == "in" or (first == "at" and following == "most"):
        return _order(reader) if first == "in" else _at_most(reader)
    if first in _SCENARIO and following not in (":", "has", "@"):
        if in_property:
            raise Malformed(Diagnostic(problems.OnlyInScenario(str(first)), reader.span(first)))
        return _SCENARIO[first](reader)
    if is_word(first) and "." not in first and following in (":", ",", "["):
        return _takes_part(reader)
    if is_word(first) and following == "fails":
        agent = _name(reader, Wanted.AGENT_NAME)
        reader.take()
        _need(reader, "by")
        return nodes.Fails(agent, _duration(reader), reader.since(first.start))
    if is_word(first) and following in _VERBS:
        raise Malformed(Diagnostic(problems.WithoutMoment(following), reader.span(first)))
    if not is_word(first) and first not in ("(", "[", "!"):
        raise _wrong(reader, Wanted.STATEMENT)
    return _between(reader)


def _between(reader: Reader) -> nodes.Rule:
    """`X before Y`, `X until Y`."""
    begin = reader.tokens[reader.index]
    near = closest(begin, [*_RULES, *_SCENARIO]) if is_word(begin) else None
    start = reader.index
    first = _condition(reader)
    if reader.next not in ("before", "until"):
        if near is not None or (isinstance(first, nodes.InState) and first.agent is None):
            reader.index = start
            problem = problems.NoStatement(str(begin), near)
            raise Malformed(Diagnostic(problem, reader.span(begin), fix=near))
        if isinstance(first, nodes.InState | nodes.Holds):
            raise Malformed(Diagnostic(problems.WithoutMoment(""), first.span))
        raise _wrong(reader, "before", "until")
    word = reader.take()
    second = _condition(reader)
    share = _share(reader)
    return nodes.Rule(str(word), (first, second), None, share, reader.since(begin.start))


def _takes_part(reader: Reader) -> nodes.TakesPart:
    begin = reader.tokens[reader.index].start
    agents = _several(reader, _new_agent)
    _need(reader, ":")
    return nodes.TakesPart(agents, _name(reader, Wanted.ROLE), reader.since(begin))


def _new_agent(reader: Reader) -> tuple[tree.Name, tuple[int, int] | None]:
    name = _name(reader, Wanted.AGENT_NAME)
    if reader.next != "[":
        return name, None
    opener = reader.take()
    least = _count(reader)
    _need(reader, "..")
    most = _count(reader)
    _close(reader, "]", opener)
    if most < least or most - least >= 10_000:
        raise reader.error(problems.UnsuitableRange(str(least), str(most)), opener)
    return name, (least, most)


def _simulated(reader: Reader) -> nodes.Simulated:
    begin = reader.take().start
    activity = _name(reader, Wanted.ACTIVITY)
    is_real = False
    takes: nodes.Lasts | None = None
    fails: tree.Duration | None = None
    ends: tuple[tree.Name, ...] = ()
    writes: list[tuple[nodes.Filled, nodes.Lasts | None]] = []
    sends: list[nodes.Filled] = []
    sets: list[tuple[tree.Name, tree.Expression]] = []
    word = str(_need(reader, *SIMULATED))
    while True:
        match word:
            case "real":
                is_real = True
            case "takes":
                takes = _times(reader)
            case "ends":
                ends += _several(reader, lambda inner: _name(inner, Wanted.OUTCOME))
            case "fails":
                _need(reader, "at")
                fails = _duration(reader)
            case "writes":
                message, pace = _message(reader), None
                # `every X leads to Y` may be the next statement.
                if reader.next == "every" and (_ahead(reader)[:1].isdigit() or _ahead(reader) == "normal"):
                    reader.take()
                    pace = _times(reader)
                writes.append((message, pace))
            case "sends":
                sends.append(_message(reader))
            case "sets":
                name = _name(reader, Wanted.NAME)
                _need(reader, "=")
                sets.append((name, operation(reader)))
        if reader.next not in SIMULATED:
            break
        word = str(reader.take())
    return nodes.Simulated(
        activity, is_real, takes, ends, fails, tuple(writes), tuple(sends), tuple(sets), reader.since(begin)
    )


def _input(reader: Reader) -> nodes.Input:
    begin = reader.take().start
    path = _path(reader, Wanted.NAME)
    _need(reader, "in")
    least = operation(reader, _COMPARISON + 1)
    _need(reader, "..")
    most = operation(reader, _COMPARISON + 1)
    return nodes.Input(tree.Name(path.text, path.span), least, most, reader.since(begin))


def _table(reader: Reader) -> nodes.Table:
    begin = reader.take().start
    opener = _need(reader, "(")
    columns = _several(reader, lambda inner: _name(inner, Wanted.NAME))
    _close(reader, ")", opener)
    brace = _need(reader, "{")
    rows = []
    while reader.next not in ("}", ""):
        opener = _need(reader, "(")
        cells = _several(reader, operation)
        reader.need(")", opener)
        rows.append((cells, reader.since(opener.start)))
        if reader.next in (",", ";"):
            reader.take()
    _close(reader, "}", brace)
    return nodes.Table(columns, tuple(rows), reader.since(begin))


def _network(reader: Reader) -> Network:
    """`delay 0..300ms loss 20% reorder`"""
    begin = reader.index
    first = _need(reader, *_NETWORK)
    reader.index = begin
    while reader.next in _NETWORK:
        word = reader.take()
        if word == "reorder":
            continue
        while reader.next[:1].isdigit() or reader.next in ("..", "%"):
            reader.take()
    span = reader.since(first.start)
    words = ""  # what is read, where it stands, without the comments between
    for word in reader.tokens[begin : reader.index]:
        words = words.ljust(word.start - first.start) + word
    try:
        return read_network(words)
    except NetworkWordsError as wrong:
        place = Span(reader.source, span.start + wrong.start, span.start + wrong.end)
        raise Malformed(Diagnostic(wrong.problem, place)) from None


def _setup(reader: Reader) -> nodes.Setup:
    word = reader.take()
    network: Network | None = None
    duration: tree.Duration | None = None
    points: int | None = None
    world = ""
    match word:
        case "network":
            network = _network(reader)
        case "for":
            duration = _duration(reader)
        case "points":
            points = _count(reader)
        case "stepwise":
            if reader.next == "until":
                reader.take()
                duration = _duration(reader)
        case _:  # world, with or without the function that makes it
            if is_word(reader.next) and _ahead(reader) == ":" and is_word(_ahead(reader, 2)):
                colon = reader.tokens[reader.index + 1]
                if "\n" not in reader.source.text[word.end : colon.start]:
                    world = "".join(reader.tokens[reader.index : reader.index + 3])
                    reader.index += 3
    return nodes.Setup(str(word), reader.since(word.start), network, duration, points, world)


def _crash(reader: Reader) -> nodes.Timed:
    word = reader.take()
    agent = _agent(reader)
    _need(reader, "at")
    moment = _duration(reader)
    span = reader.since(word.start)
    return nodes.Timed("at", (moment,), None, nodes.Hit(str(word), (agent,), span), None, span)


def _at(reader: Reader) -> nodes.Timed:
    """`at T …`, `by T …`"""
    word = reader.take()
    moment = _duration(reader)
    if word == "by":
        begin = reader.index
        condition = _condition(reader)
        event: nodes.Event = nodes.Reached(condition, _from(reader, begin))
    else:
        event = _event(reader)
    share = _share(reader)
    return nodes.Timed(str(word), (moment,), None, event, share, reader.since(word.start))


def _from(reader: Reader, index: int) -> Span:
    return reader.since(reader.tokens[index].start)


def _after(reader: Reader) -> nodes.Timed:
    """`after D in S : …`, `after D X : …`"""
    word = reader.take()
    amount = _duration(reader)
    condition: nodes.Condition
    if reader.next == "in":
        reader.take()
        begin = reader.tokens[min(reader.index, len(reader.tokens) - 1)].start
        places = _places(reader)
        condition = nodes.InState(None, places, reader.since(begin))
    else:
        condition = _condition(reader)
    if reader.next == ":":
        reader.take()
    event = _event(reader)
    share = _share(reader)
    return nodes.Timed("after", (amount,), condition, event, share, reader.since(word.start))


def _within(reader: Reader) -> nodes.Timed:
    """`within D of X E`"""
    word = reader.take()
    amount = _duration(reader)
    _need(reader, "of")
    first = _condition(reader)
    if reader.next == ":":
        reader.take()
    begin = reader.index
    event = nodes.Reached(_condition(reader), _from(reader, begin))
    share = _share(reader)
    return nodes.Timed("within", (amount,), first, event, share, reader.since(word.start))


def _during(reader: Reader) -> nodes.Timed:
    """`from 3s for 2s robot2 loses radio`, `from 3s to 8s partition { a } | { b }`"""
    word = reader.take()
    first = _duration(reader)
    is_length = _need(reader, "for", "to") == "for"
    last = _duration(reader)
    if is_length:
        last = replace(last, nanoseconds=first.nanoseconds + last.nanoseconds)
    is_partition = reader.next == "partition"
    event = _partition(reader) if is_partition else _event(reader)
    if not isinstance(event, nodes.Hit):
        wanted = ("partition", "loses")
        problem = problems.UnexpectedInStatement(wanted, last.span.text, event.span.text.split()[0])
        raise Malformed(Diagnostic(problem, event.span))
    return nodes.Timed("from", (first, last), None, event, None, reader.since(word.start))


def _partition(reader: Reader) -> nodes.Hit:
    word = reader.take()
    groups: list[tuple[tree.Name, ...]] = []
    while not groups or reader.next == "|":
        if groups:
            reader.take()
        opener = _need(reader, "{")
        agents: list[tree.Name] = []
        while reader.next not in ("}", ""):
            agents.append(_agent(reader))
            if reader.next == ",":
                reader.take()
        _close(reader, "}", opener)
        groups.append(tuple(agents))
    if len(groups) < 2:
        raise _wrong(reader, "|")
    everybody = tuple(agent for group in groups for agent in group)
    return nodes.Hit("partition", everybody, reader.since(word.start), tuple(groups))


def _event(reader: Reader) -> nodes.Event:
    """A stimulus, or an expectation."""
    begin = reader.index
    is_agent = is_word(reader.next) and "." not in reader.next and reader.next != "not"
    verb = _ahead(reader, 2 if reader.next in _ANY else 1)
    if is_agent and verb in (*_VERBS, "fails"):
        agent = _agent(reader)
        reader.take()
        match verb:
            case "receives":
                message = _message(reader)
                sender = None
                if reader.next == "from" and is_word(_ahead(reader)):
                    reader.take()
                    sender = _agent(reader)
                return nodes.Receives(agent, message, sender, reader.since(agent.span.start))
            case "raises":
                event = _name(reader, Wanted.EVENT)
                return nodes.Raises(agent, event, reader.since(agent.span.start))
            case "ends" | "does" | "fails":
                return _does(reader, agent, verb)
            case "gets" | "misses":
                return _gets(reader, agent, verb == "misses")
            case "computes":
                function = _name(reader, Wanted.NAME)
                _need(reader, "=")
                return nodes.Computes(agent, function, operation(reader), reader.since(agent.span.start))
            case _:
                _need(reader, "radio")
                return nodes.Hit("loses", (agent,), reader.since(agent.span.start))
    if is_agent and is_word(verb) and verb not in ("in", "has"):
        near = closest(verb, (*_VERBS, "in", "has"))
        if near is not None:
            reader.index += 1
            raise _wrong(reader, "receives", "raises", "loses", "in", "has")
    return nodes.Reached(_condition(reader), _from(reader, begin))


def _does(reader: Reader, agent: tree.Name, verb: str) -> nodes.Does:
    """`Grasp with slipped sets n = 3 writes … sends … prepares … takes …`"""
    activity = _name(reader, Wanted.ACTIVITY)
    outcome = None
    if verb == "ends" and reader.next == "with":
        reader.take()
        outcome = _name(reader, Wanted.OUTCOME)
    sets: list[tuple[tree.Name, tree.Expression]] = []
    filled: dict[str, list[nodes.Filled]] = {"writes": [], "prepares": []}
    sends: list[tuple[nodes.Filled, tree.Name]] = []
    takes: list[tuple[tree.Name | None, tree.Path]] = []
    while reader.next in DONE:
        match str(reader.take()):
            case "sets":
                name = _name(reader, Wanted.NAME)
                _need(reader, "=")
                sets.append((name, operation(reader)))
            case "takes":
                is_signal = is_word(reader.next) and "." in reader.next
                performative = None if is_signal else _name(reader, Wanted.PERFORMATIVE)
                takes.append((performative, _path(reader, Wanted.MESSAGE)))
            case "sends":
                sent = _message(reader)
                _need(reader, "to")
                sends.append((sent, _name(reader, Wanted.PARTICIPANT)))
            case word:
                filled[word].append(_message(reader))
    return nodes.Does(
        agent,
        activity,
        verb,
        outcome,
        tuple(sets),
        tuple(filled["writes"]),
        tuple(sends),
        tuple(filled["prepares"]),
        tuple(takes),
        reader.since(agent.span.start),
    )


def _gets(reader: Reader, agent: tree.Name, is_lost: bool) -> nodes.Gets:
    """`request Tool from robot1`, `vision.data.Ball from robot1`, `lost from robot1`"""
    performative = None
    what = None
    if is_word(reader.next) and "." not in reader.next:
        performative = _name(reader, Wanted.PERFORMATIVE)
    if performative is None or reader.next != "from":
        what = _path(reader, Wanted.MESSAGE)
    _need(reader, "from")
    sender = _agent(reader)
    return nodes.Gets(agent, performative, what, sender, is_lost, reader.since(agent.span.start))


def _always(reader: Reader) -> nodes.Statement:
    """`always C`, `never C`, `never two of player in center`."""
    word = reader.take()
    if word == "never" and _ahead(reader) == "of":
        count = _count(reader)
        reader.take()
        role = _name(reader, Wanted.ROLE)
        _need(reader, "in")
        places = _places(reader)
        return nodes.Several("never", count, role, places, _share(reader), reader.since(word.start))
    condition = _condition(reader)
    return nodes.Rule(str(word), (condition,), None, _share(reader), reader.since(word.start))


def _no(reader: Reader) -> nodes.Rule:
    """`no X before T`, `no Y within D after X`."""
    word = reader.take()
    first = _condition(reader)
    if _need(reader, "before", "within") == "before":
        limit = _duration(reader)
        return nodes.Rule("no before", (first,), limit, _share(reader), reader.since(word.start))
    limit = _duration(reader)
    _need(reader, "after")
    second = _condition(reader)
    return nodes.Rule("no within", (first, second), limit, _share(reader), reader.since(word.start))


def _order(reader: Reader) -> nodes.Rule:
    """`in order X, Y`"""
    word = reader.take()
    _need(reader, "order")
    first = _condition(reader)
    _need(reader, ",")
    others = _several(reader, _condition)
    return nodes.Rule("in order", (first, *others), None, _share(reader), reader.since(word.start))


def _eventually(reader: Reader) -> nodes.Rule:
    word = reader.take()
    condition = _condition(reader)
    limit = _limit(reader)
    return nodes.Rule("eventually", (condition,), limit, _share(reader), reader.since(word.start))


def _limit(reader: Reader) -> tree.Duration | None:
    """`within D` behind a rule; with an `of` behind it, the next statement begins here."""
    if reader.next != "within" or _ahead(reader, 2) == "of":
        return None
    reader.take()
    return _duration(reader)


def _leads(reader: Reader) -> nodes.Rule:
    word = reader.take()
    first = _condition(reader)
    _need(reader, "leads")
    _need(reader, "to")
    second = _condition(reader)
    limit = _limit(reader)
    return nodes.Rule("leads to", (first, second), limit, _share(reader), reader.since(word.start))


def _at_most(reader: Reader) -> nodes.Several:
    """`at most N X`, `at most N of ROLE in X`."""
    begin = reader.take().start
    reader.take()
    count = _count(reader)
    role = None
    if reader.next == "of":
        reader.take()
        role = _name(reader, Wanted.ROLE)
        _need(reader, "in")
    elif _ahead(reader) == "in" and _ahead(reader, 2) != "order":
        found = reader.tokens[reader.index]
        problem = problems.OfMissing(str(reader.tokens[reader.index - 1]), str(found))
        raise Malformed(Diagnostic(problem, reader.span(found), fix=f"of {found}"))
    places = _places(reader)
    return nodes.Several("at most", count, role, places, _share(reader), reader.since(begin))


def _assume(reader: Reader) -> nodes.Statement:
    word = reader.take()
    if reader.next == "network":
        reader.take()
        network = _network(reader)
        return nodes.Setup("assume", reader.since(word.start), network)
    if reader.next == "fair":
        reader.take()
        return nodes.Setup("assume", reader.since(word.start))
    if reader.next == "at":
        reader.take()
        _need(reader, "most")
        count = _count(reader)
        _need(reader, "of")
        role = _name(reader, Wanted.ROLE)
        _need(reader, "crash")
        return nodes.Several("assume", count, role, (), None, reader.since(word.start))
    if reader.next in _ANY or _ahead(reader) == "has":
        if reader.next in _ANY and reader.next != "every":
            raise _wrong(reader, "every", Wanted.AGENT_NAME)
        condition = _of_agent(reader)
        if not isinstance(condition, nodes.Holds):
            raise Malformed(Diagnostic(problems.OnlyHas(), condition.span))
        return nodes.AssumedSo(condition, reader.since(word.start))
    if not is_word(reader.next) or "." in reader.next:
        raise _wrong(reader, "network", "fair", "at most", Wanted.ACTIVITY, Wanted.AGENT_NAME)
    activity = _name(reader, Wanted.ACTIVITY)
    writes = None
    times: tuple[nodes.Lasts, ...] = ()
    match _need(reader, "writes", "takes", "may"):
        case "writes":
            writes = _path(reader, Wanted.MESSAGE)
            _need(reader, "every")
            times = (_times(reader),)
        case "takes":
            times = (_times(reader),)
        case _:
            _need(reader, "fail")
    return nodes.Assumed(activity, writes, times, reader.since(word.start))


_RULES: dict[str, Callable[[Reader], nodes.Statement]] = {
    "always": _always,
    "never": _always,
    "no": _no,
    "eventually": _eventually,
    "every": _leads,
    "assume": _assume,
}
"""What scenarios and properties have."""

_SCENARIO: dict[str, Callable[[Reader], nodes.Statement]] = {
    "network": _setup,
    "activity": _simulated,
    "given": _input,
    "table": _table,
    "world": _setup,
    "for": _setup,
    "points": _setup,
    "stepwise": _setup,
    "at": _at,
    "by": _at,
    "after": _after,
    "within": _within,
    "from": _during,
    "crash": _crash,
    "restart": _crash,
}
"""What scenarios alone have."""

RULES, OF_SCENARIO = (*_RULES, "at most", "in order"), tuple(_SCENARIO)
"""The words with which statements begin: of both, and of scenarios alone."""

_STARTS = frozenset((*_RULES, *_SCENARIO)) - {"by", "within"}
"""The words that begin a statement, and do not continue one."""


__all__ = ["OF_SCENARIO", "RULES", "SIMULATED", "read_statements", "statement_starts"]
