"""Statements: what may be written in scenarios and properties, which the grammar knows as words only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.editor.files.known import Known
from aseme_dsl.editor.typing.ask import Ask
from aseme_dsl.editor.typing.items import Item, ItemKind
from aseme_dsl.editor.typing.slots import path_before, value_slot
from aseme_dsl.editor.typing.values import agents, members, members_to_fill, topics, values
from aseme_dsl.grammar.formulas.statement import OF_SCENARIO, RULES, SIMULATED
from aseme_dsl.grammar.text.token import Token

_VERBS = (
    "in",
    "has",
    "receives",
    "raises",
    "loses radio",
    "fails by",
    "ends",
    "does",
    "gets",
    "misses",
    "computes",
)
"""What may stand behind an agent."""


def stated(ask: Ask) -> Iterator[Item]:
    """What a statement may name at the cursor."""
    known = ask.known
    path, _ = path_before(ask.said)
    words = ask.tokens("Scenario") or ask.tokens("Property")
    opened = next((place for place, word in enumerate(words) if word == "{"), -1)
    words = words[opened + 1 :]
    roles = _agents(words, known)
    if path:
        yield from members(known.top, known, path)
        return
    last = words[-1] if words else Token()
    before = words[-2] if len(words) > 1 else ""
    begins = not words or "\n" in ask.place.text[last.end : ask.place.start]
    subject = _asked_for_state(words)
    ending = _ending(words)
    filled = _filled(words, known)
    if filled is not None and last != "=":
        yield from members_to_fill(known, filled)
    elif filled is not None or last == "[":
        message = known.symbols.message(filled or "")
        member = message.field(before) if message is not None else None
        wanted = member.type if member is not None else None
        yield from values(known.top, known, value_slot([last]), ask.place.text, wanted)
    elif begins:
        yield from _words((*RULES, *(OF_SCENARIO if ask.tokens("Scenario") else ())))
        yield from _anything(known, roles)
    elif subject is not None and subject != "order":
        yield from _states(known, roles.get(subject, subject))
    elif last == "@":
        yield from _participants(known)
    elif last in ("receives", "sent", "received", "message", "writes", "sends"):
        yield from topics(known.top, known, rank=0)
        for message in known.symbols.messages if last != "receives" else ():
            said = known.documentation(message.span)
            yield Item(message.name, ItemKind.MESSAGE, "message", said, rank=1)
    elif last == "raises":
        yield from (Item(name, ItemKind.EVENT, "event", rank=0) for name in known.events if name != "error")
    elif last == "loses":
        yield from _words(("radio",))
    elif last == ":" and _lists_agents(words, ask.place.text):
        yield from (Item(item.name.text, ItemKind.ROLE, "role", rank=0) for item in known.blocks.srms)
    elif last == "activity" or (last == "assume" and known.activities):
        yield from (Item(name, ItemKind.ACTIVITY, "activity", rank=0) for name in known.activities)
        yield from _words(("network", "fair", "at most") if last == "assume" else ())
    elif before == "activity":
        yield from _words([f"{word} at" if word == "fails" else word for word in SIMULATED])
    elif ending is not None:
        found = known.symbols.activities.get(ending)
        for name in found.ends if found is not None else ():
            yield Item(name, ItemKind.CONSTANT, "outcome", rank=0)
    elif last == "outcome":
        for protocol in known.blocks.aips:
            for outcome in protocol.outcomes:
                yield Item(f'"{outcome.text.text}"', ItemKind.CONSTANT, f"outcome of {protocol.name}", rank=0)
    elif last in roles or before in ("some", "every", "any"):
        yield from _words(_VERBS)
    elif last in ("some", "any"):
        yield from (Item(item.name.text, ItemKind.ROLE, "role", rank=0) for item in known.blocks.srms)
    else:
        yield from _anything(known, roles)


def _words(words: Sequence[str]) -> Iterator[Item]:
    for word in words:
        yield Item(word, ItemKind.WORD, insert=f"{word} ", rank=1, goes_on=True)


def _agents(words: Sequence[Token], known: Known) -> dict[str, str]:
    """The agents that take part, with their roles: those before a colon, else those of the team."""
    names = {item.name.text for item in known.blocks.srms}
    found: dict[str, str] = {}
    for index, word in enumerate(words):
        place = index - 1
        if word != ":" or index + 1 == len(words) or words[index + 1] not in names:
            continue
        while place >= 0 and (words[place] in (",", "]") or words[place][0].isalpha()):
            if words[place] == "]":  # spare[1..3]
                place = next((at for at in range(place, -1, -1) if words[at] == "["), 0) - 1
            elif words[place] != ",":
                found[words[place]] = words[index + 1]
                if place and words[place - 1] != ",":
                    break
                place -= 1
            else:
                place -= 1
    team = {agent.name: agent.role for item in known.symbols.teams for agent in item.agents}
    return found or team


def _lists_agents(words: Sequence[Token], text: str) -> bool:
    """Whether the colon at the end is that of `robot1, robot2 : player`, and not of `after 1s in A :`."""
    if len(words) < 3:
        return len(words) == 2
    return words[-3] == "," or "\n" in text[words[-3].end : words[-2].start]


def _asked_for_state(words: Sequence[Token]) -> str | None:
    """The word before the `in` behind which a state is to be written."""
    place = len(words) - 1
    if place >= 0 and words[place] in ("(", "or"):
        while place >= 0 and words[place] != "(":
            if words[place] != "or" and not words[place][0].isalpha():
                return None
            place -= 1
        place -= 1
    return str(words[place - 1]) if place > 0 and words[place] == "in" else None


def _filled(words: Sequence[Token], known: Known) -> str | None:
    """The message between whose braces the cursor stands."""
    depth = 0
    for place in range(len(words) - 1, 0, -1):
        depth += (words[place] == "}") - (words[place] == "{")
        if depth < 0:
            name = words[place - 1].rpartition(".")[2]
            return name if known.symbols.message(name) is not None else None
    return None


def _ending(words: Sequence[Token]) -> str | None:
    """The activity of which an outcome is to be written: behind `activity A ends slipped,`."""
    place = len(words) - 1
    if place < 0 or words[place] not in ("ends", ","):
        return None
    while place > 0 and words[place] != "ends":
        if words[place] != "," and words[place - 1] not in ("ends", ","):
            return None
        place -= 1
    named = next((at for at in range(place - 1, -1, -1) if words[at] == "activity"), None)
    return str(words[named + 1]) if named is not None and named + 1 < place else None


def _states(known: Known, role: str) -> Iterator[Item]:
    """The states of a role; of all roles, if it is none."""
    charts: Mapping[str, object] = known.program.inspection.iacs
    for name in (role,) if role in charts else charts:
        chart = known.program.inspection.iacs[name]
        found = dict.fromkeys(node.activity or node.name for node in chart.states) if chart else {}
        for state in (name, *found):
            if state.isidentifier():
                kind = ItemKind.ACTIVITY if state in known.activities else ItemKind.STATE
                yield Item(state, kind, f"state of {name}", rank=0)


def _participants(known: Known) -> Iterator[Item]:
    for protocol in known.blocks.aips:
        for item in protocol.participants:
            yield Item(item.name.text, ItemKind.PARTICIPANT, f"participant of {protocol.name}", rank=0)
    for role in known.blocks.srms:
        for part in role.plays:
            if part.alias is not None:
                yield Item(part.alias.text, ItemKind.PARTICIPANT, f"part of {role.name}", rank=0)


def _anything(known: Known, roles: Mapping[str, str]) -> Iterator[Item]:
    """Agents and roles, their states, participants, and what is on topics."""
    yield from agents(known.top)
    for name, role in roles.items():
        yield Item(name, ItemKind.AGENT, f"agent: {role}", rank=2)
    for name in known.role_names:
        yield Item(name, ItemKind.ROLE, "role", rank=3)
    for name in known.activities:
        yield Item(name, ItemKind.ACTIVITY, "activity", rank=2)
    for declared in known.blocks.srms:
        for formula in declared.formulas:
            yield Item(formula.name.text, ItemKind.FORMULA, f"formula of {declared.name}", rank=2)
    for protocol in known.protocols:
        yield Item(protocol, ItemKind.PROTOCOL, "protocol", rank=4)
    yield from topics(known.top, known, rank=5)


__all__ = ["stated"]
