"""Terms: what a control line means by `enter PassBall`, found in the formula's own text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import assert_never

from aseme_dsl.amola.liveness import Formula, canonical, names, rewritten, term_key, ungrouped
from aseme_dsl.amola.operators import INFIX, Operator, Template
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.formulas import QUOTED, VERBS, Formulas, cut
from aseme_dsl.compiler.formula.resuming import RESUME
from aseme_dsl.compiler.formula.staying import STAYING
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import NoOccurrence, NoTerm
from aseme_dsl.diagnostics.problems.control import (
    NoLeaveButNext,
    NoStartButOfFirst,
    NoStayInRoot,
    NoStayInWhole,
    NoWay,
    NoWayButOfBody,
    NoWayIntoFormula,
    TermAmbiguous,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

Played = Mapping[tuple[str, str], Formulas]


@dataclass(frozen=True, slots=True)
class Terms:
    """The terms of one formula: each operand and operator of its text, without parentheses.

    `parents` gives the operator around each (None for the whole), `keys` the spelling of each, `places` those
    of one spelling in order.
    `title` is what the formula is called in `control`: a participant's name for its process. `played` are the
    formulas of the participants that the owner plays, by `protocol` and `participant`.
    """

    formulas: Formulas
    formula: str
    title: str
    whole: Formula
    parents: Mapping[Formula, Formula | None]
    keys: Mapping[Formula, str]
    places: Mapping[str, tuple[Formula, ...]]
    played: Played
    bare: Mapping[str, tuple[Formula, ...]] = field(default_factory=dict)
    """The places of each term with arguments, by its spelling without them."""


def terms_of(formulas: Formulas, formula: str, control: str, played: Played | None = None) -> Terms:
    """The terms of the formula called `formula`; `control` is the name that its control block has."""
    whole = ungrouped(formulas.named[formula].formula)
    parents: dict[Formula, Formula | None] = {}
    keys: dict[Formula, str] = {}
    places: dict[str, list[Formula]] = {}
    bare: dict[str, list[Formula]] = {}
    has_arguments = any(node.arguments for node in names(whole))
    stack: list[tuple[Formula, Formula | None]] = [(whole, None)]
    while stack:
        term, parent = stack.pop()
        parents[term] = parent
        keys[term] = canonical(term)
        places.setdefault(keys[term], []).append(term)
        if has_arguments and (short := canonical(_without_arguments(term))) != keys[term]:
            bare.setdefault(short, []).append(term)
        operands = term.operands
        if term.operator.row.template is Template.CUT:
            operands = (operands[0], *formulas.interrupts(term))
        stack += [(ungrouped(operand), term) for operand in reversed(operands)]
    found = {key: tuple(terms) for key, terms in places.items()}
    bare_places = {name: tuple(terms) for name, terms in bare.items()}
    return Terms(formulas, formula, control, whole, parents, keys, found, played or {}, bare_places)


def _without_arguments(term: Formula) -> Formula:
    return rewritten(term, lambda node: replace(node, arguments=()) if node.arguments else node)


def way(terms: Terms, verb: tree.Name, written: tree.Term) -> tuple[Way | None, Diagnostic | None]:
    """The way that a control line names, or what is wrong with the name (E400, E401, E402)."""
    key = term_key(written.formula)
    if key in (terms.title, terms.formula) and verb.text in ("start", "finish") and key not in terms.places:
        term: Formula | None = terms.whole
    else:
        term, problem = _find(terms, key, written)
        if problem is not None:
            return None, problem
    assert term is not None
    found = ways(terms, term).get(verb.text)
    if found is None:
        return None, _no_such_way(terms, term, verb, written)
    return found, None


def home(terms: Terms, verb: tree.Name, written: tree.Term) -> str | None:
    """The one other formula of the owner that has the term of a line, where the text of this one has none."""
    key = term_key(written.formula)
    is_whole = key in (terms.title, terms.formula) and verb.text in ("start", "finish")
    if is_whole or key in terms.places or key in terms.bare:
        return None
    others = _elsewhere(terms, key)
    return others[0] if len(others) == 1 else None


def ways(terms: Terms, term: Formula) -> dict[str, Way]:
    """The verbs that a term has, each with the edge that it means. The order is that of the template."""
    found: dict[str, Way] = {}
    parent = terms.parents[term]
    template = term.operator.row.template
    if parent is not None:
        row = parent.operator.row
        match row.template:
            case Template.CHAIN:
                found["enter"] = ("enter", term)
                if ungrouped(parent.operands[-1]) is term:
                    found["leave"] = ("leave", term)
            case Template.BRANCHES | Template.REGIONS | Template.CUT:
                found = {"enter": ("enter", term), "leave": ("leave", term)}
            case Template.UNDECIDED:
                found = {verb: (verb, term) for verb in VERBS}  # the operator decides which of them
            case Template.BODY:
                found["enter"] = ("enter", term) if row.skips else _into_loop(terms, parent)
                has = {"repeat": row.repeats, "skip": row.skips, "leave": row.leaves}
                found |= {verb: (verb, term) for verb, there in has.items() if there}
            case Template.ACTIVITY | Template.INSIDE:
                raise AssertionError("a name has no operands, and terms are without parentheses")
            case _:
                assert_never(row.template)
    elif term.operator is Operator.NAME:
        if terms.formulas.formula(term.name) is None:
            found = {"enter": ("enter", term), "leave": ("leave", term)}
    elif template is Template.BODY:
        found["enter"] = ("start", term)
    elif term.operator is Operator.HOLE:
        found = {verb: (verb, term) for verb in VERBS}
    again = found.get("repeat") or found.get("enter")
    if again is not None and again[0] != "start":
        found[RESUME] = again
    if parent is not None or "leave" in found:  # there is a state of it
        found |= {verb: (verb, term) for verb in STAYING}
    if template in (Template.BODY, Template.BRANCHES):
        found["start"] = ("start", term)
    elif template is Template.REGIONS:
        found["start"] = ("start", term)
        found["finish"] = ("finish", term)
    return found


def spelling(terms: Terms, term: Formula) -> str:
    """How a control line names the term: `KickBall#2` where it stands several times."""
    places = terms.places[terms.keys[term]]
    return _named(term) if len(places) == 1 else f"{_named(term)}#{places.index(term) + 1}"


def _named(term: Formula) -> str:
    """A term in a message: in parentheses where operators stand between its parts, cut where it is long."""
    spelled = canonical(term, QUOTED)
    return cut(f"({spelled})" if term.operator in INFIX else spelled)


def _is_plain_loop(operator: Operator) -> bool:
    """Whether its START leads to its body."""
    return operator.row.template is Template.BODY and not operator.row.skips


def _into_loop(terms: Terms, loop: Formula) -> Way:
    """The entry transition of the state of a loop; where the loop is the whole formula, into its body."""
    parent = terms.parents[loop]
    while parent is not None and _is_plain_loop(parent.operator):
        loop, parent = parent, terms.parents[parent]
    return ("start", loop) if parent is None else ("enter", loop)


def _find(terms: Terms, key: str, written: tree.Term) -> tuple[Formula | None, Diagnostic | None]:
    places = terms.places.get(key) or terms.bare.get(key, ())
    if not places:
        return None, _unknown(terms, key, written)
    name = _named(places[0]) if key in terms.places else key
    if written.occurrence is None:
        if len(places) == 1:
            return places[0], None
        related = tuple(
            Related(place.span, f"write `{name}#{number}` for this one")
            for number, place in enumerate(places, 1)
        )
        return None, Diagnostic(TermAmbiguous(name, terms.title, len(places)), written.span, related)
    if 1 <= written.occurrence <= len(places):
        return places[written.occurrence - 1], None
    numbered = tuple(spelling(terms, place) for place in places)
    return None, Diagnostic(
        NoOccurrence(f"{name}#{written.occurrence}", None, numbered, terms.title),
        written.span,
        tuple(Related(place.span, f"`{name}#{n}`") for n, place in enumerate(places, 1)),
    )


def _unknown(terms: Terms, key: str, written: tree.Term) -> Diagnostic:
    named = terms.formulas.named
    place = Related(named[terms.formula].formula.span, f"the text of `{terms.title}`")
    related: tuple[Related, ...] = (place,)
    elsewhere = _elsewhere(terms, key)
    short = [place for place in terms.places if len(place) <= QUOTED] if len(key) <= QUOTED else []
    near = closest(key, short)
    inside = next((owner for owner, other in terms.played.items() if _has_term(other, key)), None)
    problem = NoTerm(
        _named(ungrouped(written.formula)),
        None if near is None else _named(terms.places[near][0]),
        tuple(_named(places[0]) for places in terms.places.values()),
        terms.title,
    )
    if elsewhere:
        problem = problem.but(formulas=elsewhere)
    elif inside is not None:
        protocol, participant = inside
        problem = problem.but(protocol=protocol, participant=participant)
        process = terms.played[inside].named[terms.played[inside].root]
        related = (*related, Related(process.span, f"the process of {protocol}.{participant}"))
    fix = None
    if not elsewhere and inside is None and written.occurrence is None and "\n" not in written.span.text:
        fix = surely(key, short)
        if fix is not None and written.formula.operator is Operator.GROUP:
            fix = f"({fix})"  # keep the parentheses of the source
    return Diagnostic(problem, written.span, related, fix)


def _elsewhere(terms: Terms, key: str) -> tuple[str, ...]:
    """The other formulas of the owner in which a term of this spelling stands."""
    return tuple(
        name
        for name, item in terms.formulas.named.items()
        if name != terms.formula and any(_spelt(node, key) for node in _terms(item.formula))
    )


def _has_term(formulas: Formulas, key: str) -> bool:
    return any(_spelt(node, key) for item in formulas.named.values() for node in _terms(item.formula))


def _terms(formula: Formula) -> Iterator[Formula]:
    stack = [ungrouped(formula)]
    while stack:
        term = stack.pop()
        yield term
        stack += [ungrouped(operand) for operand in reversed(term.operands)]


def _spelt(term: Formula, key: str) -> bool:
    return canonical(term) == key or canonical(_without_arguments(term)) == key


def _no_such_way(terms: Terms, term: Formula, verb: tree.Name, written: tree.Term) -> Diagnostic:
    related = (Related(term.span, f"`{_named(term)}` in `{terms.title}`"),)
    return Diagnostic(_no_way(terms, term, verb.text), verb.span.to(written.span), related)


def _no_way(terms: Terms, term: Formula, verb: str) -> NoWay:
    text, title = _named(term), terms.title
    has = tuple(name for name in ways(terms, term) if name not in (*STAYING, RESUME))
    parent = terms.parents[term]
    template = term.operator.row.template
    if verb in STAYING:
        if terms.formula == terms.formulas.root:
            parts = tuple(_named(ungrouped(operand)) for operand in term.operands)
            return NoStayInRoot(verb, text, title, has, parts)
        return NoStayInWhole(verb, text, title, has)
    if verb in ("start", "finish") and terms.formulas.formula(term.name) and term.operator is Operator.NAME:
        return NoWayIntoFormula(verb, text, title, has)
    if verb in ("skip", "repeat", "leave") and _inner_has(terms, term, verb):
        return NoWayButOfBody(verb, text, title, has, _named(ungrouped(term.operands[0])))
    if verb == "start" and template in (Template.CHAIN, Template.CUT):
        return NoStartButOfFirst(verb, text, title, has, _named(ungrouped(term.operands[0])))
    if verb == "leave" and parent is not None and parent.operator.row.template is Template.CHAIN:
        index = next(i for i, operand in enumerate(parent.operands) if ungrouped(operand) is term)
        return NoLeaveButNext(verb, text, title, has, _named(ungrouped(parent.operands[index + 1])))
    return NoWay(verb, text, title, has)


def _inner_has(terms: Terms, term: Formula, verb: str) -> bool:
    return len(term.operands) == 1 and verb in ways(terms, ungrouped(term.operands[0]))


__all__ = ["Terms", "spelling", "terms_of", "way", "ways"]
