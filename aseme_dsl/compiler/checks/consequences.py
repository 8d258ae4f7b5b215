"""Consequences: of the diagnostics of all phases, those that only follow from others are left out.

One cause gives one message. A phase knows only its own part; here all are seen together. What is said twice
is not wrong, but it hides what has to be fixed first.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache

from aseme_dsl.compiler.read.library import declared_by
from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related, Severity, in_order
from aseme_dsl.diagnostics.problems.absences import (
    Absent,
    NoActivityInFormulas,
    NoActivityOfRole,
    NoActivityToBind,
    NoFormulaOfProtocol,
    NoFormulaOfRole,
    NoFunctionality,
    NoMessage,
    NoOccurrence,
    NoParticipant,
    NoParticipantOfClause,
    NoPartner,
    NoPlaceOfClause,
    NoProtocol,
    NoPublisher,
    NoTerm,
    NotListed,
    NoTopic,
    NoType,
)
from aseme_dsl.diagnostics.problems.activities import AlmostNamedLike, NamedLikeParticipant, ParametersInChart
from aseme_dsl.diagnostics.problems.control import (
    ChoiceUndecided,
    ControlOfProtocol,
    CycleNeverRests,
    LoopNeverLeft,
    LoopNeverRepeats,
    NeverCompletes,
)
from aseme_dsl.diagnostics.problems.expressions.absences import NoBeginning, NoMessageOfTopic, NotCarried
from aseme_dsl.diagnostics.problems.expressions.arguments import (
    GivenWithoutParameters,
    RootWithParameters,
    WrongNumberGiven,
)
from aseme_dsl.diagnostics.problems.expressions.conditions import (
    BranchBehindOpenOne,
    BranchesOverlap,
    ChoiceWaitsForMessage,
    ConditionAlwaysHolds,
    ConditionNeverHolds,
    ConditionsUndecided,
    NoBranchHolds,
)
from aseme_dsl.diagnostics.problems.formulas import FormulaMisspelt, FormulaNotUsed, LoopMayBeEmpty
from aseme_dsl.diagnostics.problems.missing import ControlMissing, ParticipantNotUsed, RoleIncomplete
from aseme_dsl.diagnostics.problems.names import NoConstants
from aseme_dsl.diagnostics.problems.python.code import NoCodeOfParticipant
from aseme_dsl.diagnostics.problems.python.code_words import NeverSaid
from aseme_dsl.diagnostics.problems.syntax.characters import BlankBeforeUnit
from aseme_dsl.diagnostics.problems.syntax.entries import Unexpected, UnexpectedInFile, Wanted
from aseme_dsl.diagnostics.problems.talk import SentByAnyActivity
from aseme_dsl.diagnostics.problems.use import DeclarationNotUsed, TimerNotStarted, VariablesNeverSet
from aseme_dsl.source import Source, Span

_STRUCTURE = frozenset("E100 E101 E102 E104 E110 E111 E112".split())
"""The codes after which words may not be what they seem."""
_SLIPPED = (frozenset(["E200", "E202"]), frozenset(["E201", "E202"]), frozenset(["E100", "E204"]))
"""Codes of errors that together on one line mean that its words are not in their places."""
_DECLARES = re.compile(r"\s*(?:var|sends|receives|topic|state|data|signal|message|enum)\b")
"""How a line begins that declares several names."""
_SHOWN = 3
"""How many other places of one cause are shown."""

_Line = tuple[Source, int]
_WORD = re.compile(r"[A-Za-z_]\w*")


def without_consequences(found: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics in the order of their places, each cause once."""
    ordered = list(in_order(found))
    broken = _broken(ordered)
    ordered = _folded(_without_rest_of_line(ordered, broken))
    kept = _without_followers(_without_what_was_not_read(ordered, broken))
    return tuple(map(_blamed_on_its_declaration, kept))


def without_told(found: Iterable[Diagnostic], of_code: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics without those that follow from problems in the Python code.

    - W202 (a participant that is not played) follows from E543 for the activity of that name without code.
    - N755 (any activity may send a message) follows from W556 (no activity sends it).
    """
    of_code = tuple(of_code)
    unsent = {item.span for item in of_code if isinstance(item.problem, NeverSaid)}
    told = {
        NamedLikeParticipant(problem.participant, problem.protocols, problem.role)
        for item in of_code
        if isinstance(problem := item.problem, NoCodeOfParticipant)
    }

    def is_told(item: Diagnostic) -> bool:
        match item.problem:
            case NamedLikeParticipant():
                return item.problem in told
            case SentByAnyActivity():
                return item.span in unsent
        return False

    return tuple(item for item in found if not is_told(item))


def _absence(item: Diagnostic) -> Absent | None:
    """The absence that a diagnostic tells: of a name that is there, only not what is wanted, it is none."""
    problem = item.problem
    return problem if isinstance(problem, Absent) and not problem.is_elsewhere else None


def _line(span: Span) -> _Line:
    return span.source, span.line


def _broken(found: Iterable[Diagnostic]) -> dict[_Line, int]:
    """Of each line whose structure is wrong the place from which on nothing is certain."""
    errors: dict[_Line, list[tuple[Span, Problem]]] = {}
    activities: Counter[_Line] = Counter()
    for item in found:
        if item.span is not None and item.severity is Severity.ERROR:
            activities[_line(item.span)] += isinstance(item.problem, NoActivityInFormulas | NoActivityOfRole)
            errors.setdefault(_line(item.span), []).append((item.span, item.problem))
    broken = {}
    for line, there in errors.items():
        codes = {problem.code for _, problem in there}
        wrong = next((span for span, problem in there if _is_of_structure(problem)), None)
        before = [span for span, _ in there if wrong is not None and span.end <= wrong.start]
        twice = activities[line] > 1  # a clause's word is taken for an activity
        is_empty = any(isinstance(problem, NoConstants) for _, problem in there)  # they may be behind it
        if twice or is_empty or any(pair <= codes for pair in _SLIPPED):
            broken[line] = there[0][0].start
        elif wrong is not None and before and not line[0].text[before[-1].end : wrong.start].strip():
            broken[line] = before[-1].start
        elif wrong is not None:
            broken[line] = wrong.start
    return broken


def _is_of_structure(problem: Problem) -> bool:
    """Whether words may not be what they seem; a duration with a blank ends an entry inside of it."""
    return problem.code in _STRUCTURE or isinstance(problem, BlankBeforeUnit)


def _without_rest_of_line(found: Iterable[Diagnostic], broken: dict[_Line, int]) -> list[Diagnostic]:
    """Without errors behind the place where the structure of a line is wrong, up to the first of the next."""

    def is_behind(item: Diagnostic) -> bool:
        span = item.span
        if span is None or item.severity is not Severity.ERROR:
            return False
        source, line = _line(span)
        begins = not source.line(line)[: span.column - 1].strip()
        if item.code in _STRUCTURE and begins and (source, line - 1) in broken:
            return True
        return span.start > broken.get((source, line), span.start)

    return [item for item in found if not is_behind(item)]


def _folded(found: list[Diagnostic]) -> list[Diagnostic]:
    """The absence of one name said once, with its other places."""
    places: dict[object, list[Diagnostic]] = {}
    for item in found:
        absence = _absence(item)
        places.setdefault(id(item) if absence is None else absence.cause, []).append(item)
    return [same[0] if len(same) == 1 else _merged(same) for same in places.values()]


def _merged(same: list[Diagnostic]) -> Diagnostic:
    first = same[0]
    edits = tuple(edit for item in same for edit in item.changes)
    return replace(first, related=(*first.related, *_also(same[1:])), edits=edits)


def _also(others: list[Diagnostic]) -> Iterator[Related]:
    more = len(others) - _SHOWN
    for number, item in enumerate(others[:_SHOWN], 1):
        further = f", and at {more} more places" if more > 0 and number == _SHOWN else ""
        if item.span is not None:
            yield Related(item.span, "also here" + further)


def _without_what_was_not_read(found: list[Diagnostic], broken: dict[_Line, int]) -> list[Diagnostic]:
    """Without the absence of names that may stand where something is wrong."""
    ended = {_line(item.span) for item in found if item.span is not None and _goes_on(item)}
    unread: set[str] = set()
    unused: set[str] = set()
    for item in found:
        if isinstance(item.problem, FormulaNotUsed) and item.span is not None:
            unread.update(_WORD.findall(_around(item.span.source, item.span.start, False)))
            unused.add(item.span.text)
    without_name = tuple(kind for item in found for kind in _made_absent(item.problem))
    for line, place in broken.items():
        unread.update(_WORD.findall(_around(line[0], place, line in ended)))
    unread |= {name for word in tuple(unread) for name in declared_by(word)}
    unsure = _unsure(found)
    formulas_read = not any(item.code == "E101" or _is_for_formula(item.problem) for item in found)
    misread = {line[0] for line in broken}
    nothing = [item.span for item in found if isinstance(item.problem, NoMessage) and item.span is not None]
    said: set[str] = set()
    kept = []
    for item in found:
        absence = _absence(item)
        if absence is not None and item.span is not None:
            words = set(_WORD.findall(item.span.text))
            line = _line(item.span)
            of_type = isinstance(absence, NoType)
            if (
                (words & unread and line not in broken)
                or any(words & names for other, names in unsure.items() if other != line and not of_type)
                or (isinstance(absence, NoFormulaOfRole | NoFormulaOfProtocol) and item.fix in unused)
                or (isinstance(absence, NoActivityInFormulas | NoActivityOfRole) and not formulas_read)
                or isinstance(absence, without_name)
                or (words <= said and isinstance(absence, _OF_A_PROCESS))
                or (isinstance(absence, NoPublisher) and _stands_elsewhere(item, misread))
                or (isinstance(absence, NotCarried) and _in_a_topic(nothing, item))
            ):
                continue
            said |= words
        kept.append(item)
    return kept


def _stands_elsewhere(item: Diagnostic, misread: set[Source]) -> bool:
    """Whether a name that nothing declares stands in a file of which not all was understood."""
    assert item.span is not None
    places = Counter(place.source for place in _places(item) if place.text == item.span.text)
    name = item.span.text
    return any(_words(source.text).get(name, (0, 0))[0] > places[source] for source in misread)


def _in_a_topic(nothing: list[Span], item: Diagnostic) -> bool:
    """Whether the topic that `item` is about names a message that there is not."""
    topic = item.related[0].span if item.related else None
    return topic is not None and any(
        topic.source is span.source
        and topic.end <= span.start
        and "}" not in span.source.text[topic.end : span.start]
        for span in nothing
    )


_WAY = re.compile(r"\s*(?:enter|skip|repeat|leave|start|finish)\b")
"""A line that says when a transition is taken, at its begin."""


def _line_of(span: Span) -> str:
    """The line on which a place begins."""
    return span.source.text[span.source.text.rfind("\n", 0, span.start) + 1 :].partition("\n")[0]


def _goes_on(item: Diagnostic) -> bool:
    """Whether what is wrong at the end of a line may be what stands on the next."""
    span = item.span
    if span is None or item.code not in ("E100", "E101"):
        return False
    rest = span.source.line(span.line)[span.column - 1 + span.end - span.start :]
    is_at_end = isinstance(item.problem, Unexpected) and item.problem.found is None
    return is_at_end or not rest.strip()


def _made_absent(problem: Problem) -> tuple[type[Absent], ...]:
    """What is missing where a declaration has lost its name."""
    if not isinstance(problem, UnexpectedInFile) or problem.wanted != (Wanted.NAME,):
        return ()
    return _DECLARED_BY.get(problem.after or "", ())


def _is_for_formula(problem: Problem) -> bool:
    """Whether there is no formula where one has to be."""
    return isinstance(problem, UnexpectedInFile) and problem.wanted[:1] in (
        (Wanted.FORMULA,),
        (Wanted.FORMULA_ENTRY,),
    )


_DECLARED_BY: Mapping[str, tuple[type[Absent], ...]] = {
    "message": (NoMessage, NoMessageOfTopic, NoType, NotCarried, NotListed),
    "enum": (NoType, NoBeginning),
    "topic": (NoTopic, NoBeginning),
    "state": (NotCarried, NoMessageOfTopic),
    "data": (NotCarried, NoMessageOfTopic),
    "signal": (NotCarried, NoMessageOfTopic),
    "aip": (NoProtocol,),
    "participant": (NoParticipant, NoPartner, NoParticipantOfClause, NoFormulaOfProtocol),
}
"""What is missing if that is not declared which a word declares."""
_OF_A_PROCESS = (
    NoProtocol,
    NoParticipant,
    NoPartner,
    NoActivityToBind,
    NoParticipantOfClause,
    NoPlaceOfClause,
    NoTerm,
    NoOccurrence,
    NoFormulaOfRole,
    NoFormulaOfProtocol,
)
"""Absences in what a formula or a protocol has: a name misspelt there is missing in control and clauses."""


def _unsure(found: list[Diagnostic]) -> dict[_Line, set[str]]:
    """What lines may have been meant to declare that name something that is not there."""
    unsure: dict[_Line, set[str]] = {}
    for item in found:
        absence = _absence(item)
        if absence is None or item.span is None:
            continue
        line = item.span.source.line(item.span.line)
        if _DECLARES.match(line) or isinstance(absence, NoType):
            names = set(_WORD.findall(line)) - {item.span.text}
            unsure.setdefault(_line(item.span), set()).update(names, {item.fix} if item.fix else set())
    return unsure


def _around(source: Source, place: int, ended: bool) -> str:
    """The entry in which something is wrong: by its indentation, as nothing else is certain there."""
    lines = source.text.splitlines()
    first = here = min(source.position(place)[0], len(lines)) - 1
    while first > 0 and _indentation(lines[first]) > _indentation(lines[first - 1]):
        if lines[first - 1].rstrip().endswith("{"):
            break
        first -= 1
    last = here + 1
    if ended:
        while last < len(lines) and not lines[last].strip():
            last += 1
        last += 1
    while last < len(lines) and _indentation(lines[last]) > _indentation(lines[first]):
        last += 1
    return "\n".join(lines[first:last])


def _indentation(line: str) -> int:
    return len(line) - len(line.lstrip())


def _without_followers(found: list[Diagnostic]) -> list[Diagnostic]:
    """The diagnostics without those that follow from another one.

    | cause | what follows |
    | --- | --- |
    | E108: a malformed number | errors of its type |
    | E101, E102: a formula that cannot be read | E310: the next one is taken for the role's own |
    | E205: a misspelt protocol or participant after `plays` | N702: that protocol is not played |
    | E302: an unused formula, misspelt where it is used | W200: that name; E302 then names it |
    | E303: a loop that may be empty | W403: a cycle without a wait; E405: an option without a condition |
    | E403: a misspelt name after `control`; E408: control of a protocol in a role | N704: no control |
    | an error in an event of a line | W402: without the event, the line waits for what never completes |
    | E523: arguments that an activity does not have | W200: the activity that may be meant |
    | N437: all branches read variables that are never set | W411: a gap between the branches |
    | W200: a misspelt activity | N702: the participant that is meant is unused |
    | W230: a misspelt functionality | N727: the functionality that is meant is unused |
    | W420: a loop with a constant condition | N712, W412: a condition that always or never holds |
    | W501: a timer that is never started | conditions that overlap, leave a gap or never hold |
    """
    unstarted = [place for item in _of(found, TimerNotStarted) for place in _places(item)]
    almost = {place.span for item in _of(found, NoFunctionality) for place in item.related}
    unplayed = {item.fix for item in _of(found, NoProtocol, NoParticipant, NoPartner)}
    fixed = [place for item in _of(found, LoopNeverRepeats, LoopNeverLeft) for place in _places(item)]
    unused = {item.span for item in _of(found, FormulaNotUsed)}
    controls = {item.fix for item in _of(found, NoFormulaOfRole, NoFormulaOfProtocol)}
    controls |= {item.problem.name for item in found if isinstance(item.problem, ControlOfProtocol)}
    close = {item.related[0].span: item.span for item in _of(found, AlmostNamedLike) if item.related}
    given = [item.span for item in _of(found, *_GIVEN) if item.span is not None]
    loops = [item.span for item in _of(found, LoopMayBeEmpty) if item.span is not None]
    misspelt = {place.span for item in _of(found, AlmostNamedLike) for place in item.related}
    unread = [item.span for item in found if item.code in ("E101", "E102") and item.span is not None]
    wrong = [item.span for item in found if item.severity is Severity.ERROR and item.span is not None]
    numbers = [item.span for item in found if item.code == "E108" and item.span is not None]
    unset = [place for item in _of(found, VariablesNeverSet) for place in _places(item)]
    never_set = {place.text for place in unset}

    def follows(item: Diagnostic) -> bool:
        span, problem = item.span, item.problem
        if span is None:
            return False
        if isinstance(problem, ParticipantNotUsed | RoleIncomplete):
            return span in misspelt or any(place.span.text in unplayed for place in item.related)
        if isinstance(problem, RootWithParameters):
            return any(_is_before_in_block(place, span) for place in unread)
        if isinstance(problem, ControlMissing):
            return problem.formula in controls
        if isinstance(problem, NeverCompletes):
            return any(_is_in(place, span) for place in wrong) or any(
                place.source is span.source and _WAY.match(_line_of(place)) for place in unread
            )
        if isinstance(problem, AlmostNamedLike):
            return any(span.start == place.start and span.source is place.source for place in given) or (
                bool(item.related) and item.related[0].span in unused
            )
        if isinstance(problem, _OF_CONDITIONS) and any(
            _is_in(timer, place) for timer in unstarted for place in _places(item)
        ):
            return True
        if isinstance(problem, NoBranchHolds) and any(
            _is_in(place, asked) for place in unset for asked in _places(item)
        ):
            return all(never_set.intersection(_WORD.findall(asked.text)) for asked in _places(item))
        if isinstance(problem, DeclarationNotUsed):
            return span in almost
        if isinstance(problem, ConditionAlwaysHolds | ConditionNeverHolds | BranchBehindOpenOne):
            return any(_is_in(span, line) or _is_in(line, span) for line in fixed)
        if isinstance(problem, ChoiceUndecided | CycleNeverRests):
            return any(_is_in(span, loop) for loop in loops)
        return item.code in _ABOUT_TYPES and any(_is_in(number, span) for number in numbers)

    def explained(item: Diagnostic) -> Diagnostic:
        span, problem = item.span, item.problem
        place = None if span is None else close.get(span)
        if place is None or span is None or not isinstance(problem, FormulaNotUsed):
            return item
        if _occurrences(span) > 1 and _occurrences(place) == 1:
            other = FormulaMisspelt(place.text, span.text)
            return Diagnostic(other, place, (Related(span, "the formula"),), span.text)
        related = (Related(place, f"`{place.text}` has no formula"),)
        return replace(item, problem=problem.but(close=place.text), related=related, fix=place.text)

    return [explained(item) for item in found if not follows(item)]


def _of(found: Iterable[Diagnostic], *kinds: type[Problem]) -> list[Diagnostic]:
    return [item for item in found if isinstance(item.problem, kinds)]


def _occurrences(span: Span) -> int:
    """How often the word at a place stands in its file: a typing error is made once."""
    return _words(span.source.text).get(span.text, (0, 0))[0]


@lru_cache(maxsize=4)
def _words(text: str) -> dict[str, tuple[int, int]]:
    """Of each word outside of comments how often it stands in a text, and where the last time."""
    found: dict[str, tuple[int, int]] = {}
    for word in _WORD.finditer(_COMMENT.sub(lambda comment: " " * len(comment[0]), text)):
        found[word[0]] = (found.get(word[0], (0, 0))[0] + 1, word.start())
    return found


def _blamed_on_its_declaration(item: Diagnostic) -> Diagnostic:
    """Where several uses agree and nothing uses the close name, its declaration is the misspelt one."""
    span, absence = item.span, _absence(item)
    if span is None or absence is None or not item.changes:
        return item
    used, declared = span.text, {edit.text for edit in item.changes}
    if len(declared) != 1 or any(edit.span.text != used for edit in item.changes):
        return item
    (name,) = declared
    text = span.source.text
    number, last = _words(text).get(name, (0, 0))
    if number != 1 or not _is_declared_at(text, last, name) or _occurrences(span) < 2:
        return item
    place = Span(span.source, last, last + len(name))
    related = (*item.related, Related(place, f"`{name}` is declared here"))
    problem = absence.but(unused=name)
    return replace(item, problem=problem, related=related, fix=None, edits=(Edit(place, used),))


def _is_declared_at(text: str, place: int, name: str) -> bool:
    """Whether the word there is the name of something declared, or a formula."""
    before = _DECLARED_AFTER.search(text[max(0, place - 40) : place])
    return before is not None or _ASSIGNED.match(text, place + len(name)) is not None


_ASSIGNED = re.compile(r"\s*=(?![=>])")
_DECLARED_AFTER = re.compile(
    r"\b(?:enum|message|topic|let|function|sag|suc|role|aip|participant|srm|statechart|scenario|property)\s+\Z"
)
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def _places(item: Diagnostic) -> list[Span]:
    places = [place.span for place in item.related]
    return places if item.span is None else [item.span, *places]


_GIVEN = (GivenWithoutParameters, ParametersInChart, WrongNumberGiven)
_OF_CONDITIONS = (
    BranchesOverlap,
    NoBranchHolds,
    ConditionNeverHolds,
    BranchBehindOpenOne,
    ConditionsUndecided,
    ConditionAlwaysHolds,
    ChoiceWaitsForMessage,
)
_ABOUT_TYPES = ("E500", "E504", "E505", "E506", "E509", "E514", "E515", "W500")


def _is_before_in_block(first: Span, second: Span) -> bool:
    text = first.source.text
    return (
        first.source is second.source
        and first.end <= second.start
        and "}" not in text[first.end : second.start]
    )


def _is_in(inner: Span, outer: Span) -> bool:
    return inner.source is outer.source and outer.start <= inner.start and inner.end <= outer.end


__all__ = ["without_consequences", "without_told"]
