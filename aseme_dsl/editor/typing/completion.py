"""Completion: what may be written where the cursor stands, the likeliest first.

The grammar says what may come next (grammar/parsing/expected.py); names.py, values.py and the slots of
expressions say which names that means in this system.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import assert_never

from aseme_dsl.amola.liveness import Formula, canonical
from aseme_dsl.amola.messages import AGENT
from aseme_dsl.amola.operators import INFIX
from aseme_dsl.compiler.chart.aip_to_eac import PROCESS
from aseme_dsl.compiler.formula.staying import ABANDON
from aseme_dsl.compiler.formula.terms import Terms, ways
from aseme_dsl.compiler.names.scope import Party
from aseme_dsl.compiler.read.builtins import ROUND_QUESTIONS, STATE_QUESTIONS
from aseme_dsl.editor.files.known import Known, used_names
from aseme_dsl.editor.files.place import Place, place_at
from aseme_dsl.editor.typing.around import Around, around
from aseme_dsl.editor.typing.ask import Ask
from aseme_dsl.editor.typing.items import Item, ItemKind
from aseme_dsl.editor.typing.names import PLACES, activities, formula_names, performatives
from aseme_dsl.editor.typing.slots import (
    Slot,
    SlotKind,
    formula_is_open,
    transition_slot,
    value_slot,
)
from aseme_dsl.editor.typing.snippets import USUAL, WHOLE, skeleton
from aseme_dsl.editor.typing.statements import stated
from aseme_dsl.editor.typing.values import (
    actions,
    constants,
    members,
    members_to_fill,
    outcomes,
    topics,
    values,
)
from aseme_dsl.grammar.parsing.expected import Expected
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source

MOST = 200
"""How many items are offered at most. An editor takes long to read more, and no author reads so many."""

_ALIAS = re.compile(r'\bimport\s*"[^"\n]*"\s*as\s+([A-Za-z_]\w*)')
_LATER = 10
"""By how much items are put behind those that continue the line."""


def complete(source: Source, offset: int, known: Known) -> tuple[Item, ...]:
    """The items for a cursor before the character at `offset`. No text raises anything."""
    return offered(source, offset, known)[0]


def offered(source: Source, offset: int, known: Known) -> tuple[tuple[Item, ...], bool]:
    """The items, and whether these are all: of too many, those that go with what is typed are the first."""
    place = place_at(source.text, offset)
    if place.inside == "comment" or not place.expected:
        return (), True
    block = around(place, known)
    found: dict[str, Item] = {}
    for expected in _relevant(place):
        if place.inside == "text" and expected.terminal != "Text":
            continue
        later = _LATER if _begins_here(place, expected) and _goes_on(place) else 0
        for item in _items(Ask(place, expected, known, block, source.path)):
            item = _placed(item, place, later)
            known_item = found.get(item.label)
            if known_item is None or item.rank < known_item.rank:
                found[item.label] = item
    aliases = dict.fromkeys(_ALIAS.findall(source.text))
    named = (_behind_alias(item, place, aliases) for item in found.values()) if aliases else found.values()
    ordered = sorted((item for item in named if item is not None), key=lambda item: item.rank)
    if len(ordered) <= MOST:
        return tuple(ordered), True
    going = [item for item in ordered if _goes_with(source.text[item.start : offset], item.label)]
    return tuple(going[:MOST]), False


def _behind_alias(item: Item, place: Place, aliases: Iterable[str]) -> Item | None:
    """The item as it is written in this file: `alice.Ball` in the place of `alice_Ball`. None if what has
    been typed is an alias that it does not stand behind."""
    alias = next((name for name in aliases if item.label.startswith(f"{name}_")), None)
    typed = place.path[-1] if place.path and place.path[-1] in aliases else None
    if typed is not None and alias != typed:
        return None if item.label not in aliases else item
    if alias is None or item.is_snippet or item.insert != item.label:
        return item
    rest = item.label.removeprefix(f"{alias}_")
    return replace(
        item, label=rest if typed else f"{alias}.{rest}", insert=rest if typed else f"{alias}.{rest}"
    )


def _goes_with(typed: str, label: str) -> bool:
    """Whether the letters typed stand in a label in this order, which is how editors choose."""
    letters = iter(label.lower())
    return all(letter in letters for letter in typed.lower())


def _relevant(place: Place) -> Iterable[Expected]:
    """What is expected, without what could only follow if the expression ended in the middle."""
    flat = [item for item in place.expected if item.terminal in _FLAT]
    for item in flat:
        if _is_open(place, item):
            return [item]
    return place.expected


def _begins_here(place: Place, expected: Expected) -> bool:
    """Whether what is expected begins an entry of the innermost block, or a declaration."""
    entry = place.entry_of(expected)
    return entry is None or place.begin_of(entry) >= place.first + len(place.read.rstrip())


def _goes_on(place: Place) -> bool:
    """Whether an entry has been begun on the cursor's line."""
    line = place.read[place.read.rfind("\n") + 1 :].strip()
    return bool(line) and line[-1] not in "{}"


def _placed(item: Item, place: Place, later: int) -> Item:
    start = place.start if item.start < 0 else item.start
    return replace(item, start=start, end=place.end, insert=item.insert or item.label, rank=item.rank + later)


def _items(ask: Ask) -> Iterator[Item]:
    flat = _FLAT.get(ask.expected.terminal)
    if flat is not None:
        yield from flat(ask)
        return
    words = [word for word in ask.expected.words if word[:1].isalpha()]
    provider = PLACES.get(ask.expected.place)
    if words:
        yield from (_word(ask, word) for word in words)
    elif provider is not None and not ask.expected.words:
        yield from provider(ask)


def _word(ask: Ask, word: str) -> Item:
    """A word of the language; with what must follow it, if nothing stands behind the cursor yet."""
    if ask.place.rest_of_line.strip() not in ("", "}"):
        return Item(word, ItemKind.WORD, rank=4)
    whole = WHOLE.get(word) if len(ask.expected.steps) == 2 and ask.place.block < 0 else None
    text = whole or USUAL.get(word) or skeleton(word, ask.expected)
    indent = _indentation(ask.place)
    return Item(
        word,
        ItemKind.SNIPPET if whole else ItemKind.WORD,
        insert=text.replace("\n", "\n" + indent),
        is_snippet=text != word,
        rank=4,
    )


def _indentation(place: Place) -> str:
    line = place.text[place.text.rfind("\n", 0, place.start) + 1 : place.start]
    return line[: len(line) - len(line.lstrip())]


# ---- terms and formulas ----------------------------------------------------------------------------


def _terms(ask: Ask) -> Iterator[Item]:
    """The terms of the formula that have this way; those without a line come first."""
    way_tokens = ask.tokens("Way")
    control = ask.name("Control")
    terms = ask.around.terms(control) if control is not None else None
    if terms is None or not way_tokens:
        return
    verb = str(way_tokens[0])
    start = way_tokens[1].start if len(way_tokens) > 1 else -1
    assert control is not None
    said = ask.around.said(control, terms)
    written = ask.place.rest_of_line.strip()
    owner = ask.around.owner(control)
    if verb == "on" and owner is not None and owner[2] == control:
        insert = ABANDON if written else f"{ABANDON} : "
        detail = f"when {control} is left before its END"
        yield Item(ABANDON, ItemKind.WORD, detail, "", insert, rank=5, start=start, goes_on=not written)
    for term in terms.parents:
        way = ways(terms, term).get(verb)
        if way is None:
            continue
        name = spelled(terms, term)
        rank = 6 if way in said else 2
        insert = name if written else f"{name} : "
        detail = "has a line already" if way in said else f"of {control}"
        yield Item(name, ItemKind.TERM, detail, "", insert, rank=rank, start=start, goes_on=not written)
    for other, term in ask.around.terms_inside(control, terms):
        if verb in ways(other, term):
            name = spelled(other, term)
            insert = name if written else f"{name} : "
            detail = f"of {other.formula}"
            yield Item(name, ItemKind.TERM, detail, "", insert, rank=7, start=start, goes_on=not written)


def spelled(terms: Terms, term: Formula) -> str:
    """How a control line names a term, in full: `KickBall#2` where it stands several times."""
    text = canonical(term)
    places = terms.places[text]
    name = f"({text})" if term.operator in INFIX else text
    return name if len(places) == 1 else f"{name}#{places.index(term) + 1}"


def _formula(ask: Ask) -> Iterator[Item]:
    tokens = _behind(ask.place, ask.expected, "=")
    if tokens is None:
        return
    slot = slot_of(ask)
    if slot is not None and slot.calls:
        yield from _arguments(ask, slot)
    elif formula_is_open(tokens):
        yield from formula_names(ask)


def _arguments(ask: Ask, slot: Slot) -> Iterator[Item]:
    """What an activity or a formula is given: parameters of the formula that uses it, or values."""
    found = parameters_of(ask, slot.calls[-1].function)
    index = slot.calls[-1].argument
    wanted = ask.known.symbols.type_named(found[index][1]) if len(found) > index else None
    if slot.kind is SlotKind.MEMBER:
        yield from members(ask.scope, ask.known, slot.path)
    elif slot.kind is SlotKind.VALUE:
        for name in _own_parameters(ask):
            yield Item(name, ItemKind.VARIABLE, "parameter of the formula", rank=0)
        yield from values(ask.scope, ask.known, slot, ask.place.text, wanted)


def parameters_of(ask: Ask, name: str) -> list[tuple[str, str]]:
    """The parameters of an activity or a formula with their types, which formulas may leave out."""
    activity = ask.known.symbols.activities.get(name)
    if activity is not None:
        return [(item.name, str(item.type)) for item in activity.parameters]
    declaration = ask.around.declaration
    part = ask.around.participant(ask.name("Participant") or "")
    formulas = declaration.formulas if isinstance(declaration, tree.Srm) else part.formulas if part else ()
    formula = next((item for item in formulas if item.name.text == name), None)
    found = formula.parameters if formula is not None else ()
    return [(item.name.text, item.type.text if item.type is not None else "") for item in found]


def _own_parameters(ask: Ask) -> list[str]:
    """The parameters in the head of the formula that is being typed."""
    head = [str(item) for item in ask.said]
    head = head[: head.index("=")] if "=" in head else []
    return [name for before, name in pairwise(head) if before in ("(", ",")]


# ---- expressions -----------------------------------------------------------------------------------


def _expression(ask: Ask) -> Iterator[Item]:
    """An expression of a transition, a `let` or a `var`."""
    slot = slot_of(ask)
    if slot is None:
        return
    enum = ask.known.symbols.enum(str(ask.said[3])) if ask.expected.place[0] == "Var" else None
    if enum is not None and slot.kind is SlotKind.VALUE:
        yield from constants(enum, ask.known, f"{enum.name}.", rank=0)
        return
    if ask.expected.place[0] in ("Var", "Setting"):
        slot = replace(slot, decides=True)  # the same whenever it is asked for
    yield from _in_slot(ask, slot)


def _binding(ask: Ask) -> Iterator[Item]:
    """What stands for an activity of the participant that is played, or the value of an input."""
    tokens = [str(item) for item in ask.tokens("Part")]
    protocol = ask.known.protocols.get(tokens[0]) if tokens else None
    parts = protocol.participants if protocol is not None else ()
    part = next((item for item in parts if item.name.text in tokens[2:3]), None)
    supplied: set[str] = set()
    if part is not None:
        supplied = {item.name.text for item in part.inputs} | {item.name.text for item in part.results}
    said = [str(item) for item in ask.tokens("Binding")]
    if not supplied.isdisjoint(said[:1]):
        yield from _expression(ask)
    elif said[1:] == ["="]:
        role = ask.around.declaration
        for item in role.formulas[1:] if isinstance(role, tree.Srm) else ():
            yield Item(item.name.text, ItemKind.FORMULA, "formula of the role", rank=2)
        yield from activities(ask)


def _busy(ask: Ask) -> Iterator[Item]:
    """What is answered to an invitation: a word, or a message of the participant with its members."""
    tokens = [str(item) for item in ask.tokens("Part")]
    protocol = ask.known.protocols.get(tokens[0]) if tokens else None
    parts = protocol.participants if protocol is not None else ()
    part = next((item for item in parts if item.name.text in tokens[2:3]), None)
    sends = part.sends if part is not None else ()
    said = tokens[tokens.index("busy") + 1 :] if "busy" in tokens else []
    if not said:
        yield Item("queue", ItemKind.WORD, "the invitation waits", rank=1)
        yield Item("refuse", ItemKind.WORD, "the protocol's refusal", rank=1)
        others = dict.fromkeys(item.performative.text for item in sends)
        yield from performatives(name for name in others if name != "refuse")
    elif len(said) == 1:
        for item in sends:
            if item.performative.text == said[0]:
                yield Item(item.message.text, ItemKind.MESSAGE, said[0], rank=2)
    elif "{" in said and said[-1] in ("{", ","):
        yield from members_to_fill(ask.known, said[1])


def _in_slot(ask: Ask, slot: Slot) -> Iterator[Item]:
    scope = ask.scope
    party = scope.parties.get(scope.participant) if scope.participant is not None else None
    match slot.kind:
        case SlotKind.EVENT:
            yield from _events(ask, party, scope.parties, slot.first)
        case SlotKind.CONDITION:
            yield Item("[…]", ItemKind.WORD, "a condition", "", "[${1:condition}]", is_snippet=True, rank=1)
        case SlotKind.SENT_PERFORMATIVE:
            yield from performatives(item.performative for item in (party.sends if party is not None else ()))
        case SlotKind.RECEIVED_MESSAGE | SlotKind.SENT_MESSAGE:
            performative = slot.said[-1]
            exchanged = () if party is None else party.receives
            if slot.kind is SlotKind.SENT_MESSAGE and party is not None:
                exchanged = party.sends
            fitting = {item.message for item in exchanged if item.performative == performative}
            for message in ask.known.symbols.messages:
                if message.name in fitting or not fitting:
                    said = ask.known.documentation(message.span)
                    yield Item(message.name, ItemKind.MESSAGE, performative, said, rank=2)
        case SlotKind.FROM | SlotKind.TO:
            yield Item(slot.kind.value, ItemKind.WORD, "", "", f"{slot.kind.value} ", rank=2, goes_on=True)
        case SlotKind.SENDER | SlotKind.RECEIVER:
            yield from _parties(scope.parties, slot)
            if slot.kind is SlotKind.SENDER and slot.said[:1] != ("lost",):
                agents = (name for name, (_, kind) in scope.variables.items() if kind == AGENT)
                yield from (Item(name, ItemKind.VARIABLE, "agent", rank=3) for name in agents)
        case SlotKind.FILL:
            yield from members_to_fill(ask.known, slot.said[0], slot.path)
        case SlotKind.ACTION:
            yield from actions(scope, ask.known)
            if party is not None:
                yield from _sends(party, scope.parties)
        case SlotKind.ACTION_MEMBER:
            path = slot.path[1:] if slot.path[0] == "write_messages" else slot.path
            if path:
                yield from members(scope, ask.known, path)
            else:
                yield from topics(scope, ask.known, 2)
        case SlotKind.MEMBER:
            yield from members(scope, ask.known, slot.path)
        case SlotKind.VALUE:
            if slot.calls and slot.calls[-1].function in ("expired", "start_timer"):
                if slot.calls[-1].argument == 0:
                    for name in ask.around.timers:
                        yield Item(name, ItemKind.TIMER, "timer", rank=0)
                return
            if slot.calls and slot.calls[-1].function in STATE_QUESTIONS:
                yield from _states(ask, party)
                return
            if slot.calls and slot.calls[-1].function in ROUND_QUESTIONS:
                for other in scope.parties:
                    yield Item(other, ItemKind.PARTICIPANT, "participant", rank=int(party is None))
                return
            named = tuple(outcomes(scope, slot))
            yield from named or values(scope, ask.known, slot, ask.place.text)
        case SlotKind.WEIGHT:
            if ask.tokens("Way")[:1] == ["enter"]:
                yield _WEIGHT
        case SlotKind.COMPLETE:
            pass
        case _:
            assert_never(slot.kind)


def _states(ask: Ask, party: Party | None) -> Iterator[Item]:
    """The formulas and activities of the role or participant, which name its states."""
    declaration = ask.around.declaration
    part = ask.around.participant(party.name) if party is not None else None
    formulas = declaration.formulas if isinstance(declaration, tree.Srm) else part.formulas if part else ()
    for formula in formulas:
        if formula.name.text != PROCESS:
            yield Item(formula.name.text, ItemKind.FORMULA, "formula", rank=0)
    for name in used_names(formulas):
        yield Item(name, ItemKind.ACTIVITY, "activity", rank=1)


_WEIGHT = Item("weight", ItemKind.WORD, "weight 3", "", "weight ${1:1}", is_snippet=True, rank=4)


def _events(ask: Ask, party: Party | None, parties: Mapping[str, Party], first: bool) -> Iterator[Item]:
    """What a transition may wait for."""
    yield Item(
        "when", ItemKind.WORD, "as soon as it holds", "", "when [${1:condition}]", is_snippet=True, rank=3
    )
    yield Item("after", ItemKind.WORD, "after(5s)", "", "after(${1:5s})", is_snippet=True, rank=3)
    yield Item("error", ItemKind.EVENT, "an activity inside has failed", rank=4)
    if first:
        yield Item("else", ItemKind.WORD, "no other branch is open", rank=3)
        yield _WEIGHT
        yield Item("[…]", ItemKind.WORD, "a condition", "", "[${1:condition}]", is_snippet=True, rank=1)
    if first and (ask.tokens("Way") or ask.tokens("StandingWay"))[:1] == ["on"]:
        yield Item(
            "ignores", ItemKind.WORD, "drops signals in this state", "", "ignores ", goes_on=True, rank=4
        )
    if party is not None:
        yield Item("lost", ItemKind.WORD, "an agent is lost", "", "lost ", rank=4, goes_on=True)
    for name in ask.known.events:
        if name != "error":
            yield Item(name, ItemKind.EVENT, "event", rank=2)
    if party is None:
        return
    for message in party.receives:
        for other in parties.values():
            if (message.performative, message.message) in {(m.performative, m.message) for m in other.sends}:
                text = f"{message.performative} {message.message} from {other.name}"
                yield Item(text, ItemKind.EVENT, "received message", rank=1)
    yield from performatives(item.performative for item in party.receives)


def _sends(party: Party, parties: Mapping[str, Party]) -> Iterator[Item]:
    yield Item("send", ItemKind.WORD, "an agent message", "", "send ", rank=3, goes_on=True)
    for message in party.sends:
        for other in parties.values():
            taken = {(item.performative, item.message) for item in other.receives}
            if (message.performative, message.message) in taken:
                text = f"send {message.performative} {message.message} to {other.name}"
                yield Item(text, ItemKind.EVENT, "sent message", rank=0)


def _parties(parties: Mapping[str, Party], slot: Slot) -> Iterator[Item]:
    """Participants; first those that send, or receive, the message."""
    performative, message = ("", "")
    if slot.said[:1] != ("lost",):
        performative, message = slot.said[0:2] if slot.kind is SlotKind.SENDER else slot.said[1:3]
    for party in parties.values():
        exchanged = party.sends if slot.kind is SlotKind.SENDER else party.receives
        fits = any((item.performative, item.message) == (performative, message) for item in exchanged)
        yield Item(party.name, ItemKind.PARTICIPANT, "participant", rank=1 if fits else 5)


def _is_open(place: Place, expected: Expected) -> bool:
    """Whether an expression or a formula stops where it cannot end."""
    if expected.terminal == "TermToken":
        return True
    if expected.terminal in ("FormulaToken", "ProcessToken"):
        tokens = _behind(place, expected, "=")
        return tokens is not None and (formula_is_open(tokens) or bool(value_slot(tokens).calls))
    slot = _slot(place, expected)
    if slot is None or slot.kind in (SlotKind.COMPLETE, SlotKind.WEIGHT):
        return False
    # `enter A :` may end there; on the next line, another entry is likelier.
    return (
        slot.kind is not SlotKind.EVENT
        or not slot.first
        or "\n" not in place.read[len(place.read.rstrip()) :]
    )


def slot_of(ask: Ask) -> Slot | None:
    """What may come next in the expression that the cursor is in; None outside of expressions."""
    return _slot(ask.place, ask.expected)


def _slot(place: Place, expected: Expected) -> Slot | None:
    if expected.terminal in ("FormulaToken", "ProcessToken"):
        tokens = _behind(place, expected, "=")
        return value_slot(tokens) if tokens is not None else None
    if expected.terminal not in ("ControlToken", "ExpressionToken", "SettingToken", "BindingToken"):
        return None
    is_transition = expected.terminal == "ControlToken"
    tokens = _behind(place, expected, ":" if is_transition else "=")
    if tokens is None:
        return None
    return transition_slot(tokens) if is_transition else value_slot(tokens)


def _behind(place: Place, expected: Expected, sign: str) -> list[Token] | None:
    """The tokens of the innermost rule behind the sign that ends its head; None before it."""
    tokens = place.tokens(expected.steps[-1])
    index = next((index for index, item in enumerate(tokens) if item == sign), None)
    return None if index is None else tokens[index + 1 :]


_FLAT: Mapping[str, Callable[[Ask], Iterator[Item]]] = {
    "TermToken": _terms,
    "FormulaToken": _formula,
    "ProcessToken": _formula,
    "ExpressionToken": _expression,
    "ControlToken": _expression,
    "SettingToken": _expression,
    "BindingToken": _binding,
    "BusyToken": _busy,
    "Word": stated,
}
"""What is offered inside of what is a list of tokens for the grammar."""

__all__ = [
    "Around",
    "complete",
    "parameters_of",
    "slot_of",
    "spelled",
]
