"""Words: what people call the states, transitions and messages of a run."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Mapping, Sequence

from aseme_dsl.play.evaluate import Told
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.records import Record, Taken, targets_of
from aseme_dsl.source import without_column

_LONGEST = 60
"""A longer content of a message is cut off (characters)."""
LONG = 100
"""Longer conditions and actions are cut off (characters)."""


@dataclass(frozen=True, slots=True)
class Said:
    """A message as its sender has sent it: on a channel, or (`performative`) to other agents."""

    what: str
    kind: str
    performative: str | None
    sender: str
    content: Told
    moment: int


def content_of(message: Mapping[str, object], durations: Collection[str] = ()) -> str:
    """` { n = 1 }`: the fields of a message that say something; nothing if none does."""
    said = fields_of(message, durations)
    return f" {{ {said} }}" if said else ""


def fields_of(message: Mapping[str, object], durations: Collection[str] = ()) -> str:
    """`n = 1, text = pie`: the fields of a message that say something; `durations` are some of them."""

    def text(name: str, value: object) -> str:
        if name in durations and isinstance(value, int):
            return shown(value)
        return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)

    said = (
        f"{name} = {text(name, value)}" for name, value in message.items() if value not in ("", None, [], {})
    )
    return cut(", ".join(said), _LONGEST)


def cut(text: str, longest: int = LONG) -> str:
    """A text in one line, that is cut off where it is too long."""
    line = " ".join(text.split())
    return line if len(line) <= longest else f"{line[: longest - 1]}…"


def few(texts: Sequence[str], most: int = 4) -> str:
    """`a, b and 3 others`."""
    if len(texts) <= 1:
        return "".join(texts)
    shown = texts if len(texts) <= most else texts[: most - 1]
    others = len(texts) - len(shown)
    if others:
        return f"{', '.join(shown)} and {others} others"
    return f"{', '.join(shown[:-1])} and {shown[-1]}"


def name_of(plan: Plan, label: str) -> str:
    """What people call a state, told apart from others, without its label if that can be."""
    from aseme_dsl.play.asking.names import named  # only who reads a story asks for it

    name = named(plan, label)
    plain = name.removesuffix(f" ({label})")
    around = plan.by_label[label].parent
    if plain == name or around is None or plan.by_label[around].name == around:
        return name
    return f"{plain} in {cut(plan.by_label[around].name, 40)}"


def leaf_names(plan: Plan, labels: Iterable[str]) -> list[str]:
    """What people call the innermost active states; regions that have not begun stand only alone."""
    states = (plan.by_label[label] for label in labels if label in plan.by_label)
    found = {plan.called(state): state.type for state in states if state.type != "AND"}
    busy = [name for name, kind in found.items() if kind != "START"]
    return busy or list(found)


def way(plan: Plan, taken: Taken) -> str:
    """What people call a transition that is taken."""
    left, entered = plan.by_label[taken["source"]], plan.called_all(targets_of(taken))
    return f"enters {entered}" if left.type == "START" else f"{plan.called(left)} -> {entered}"


def sending(said: Said, receivers: Iterable[str], durations: Collection[str]) -> Happened:
    """What people call the sending of a message."""
    to = tuple(name for name in receivers if name != said.sender)
    sent = f"{said.what}{content_of(said.content, durations)}"
    text = f"sends {sent} to {few(to)}" if to else f"sends {sent}, which no other agent reads"
    return Happened(said.moment, said.sender, text, sent=sent, to=to)


def went_wrong(record: Record) -> str:
    """What people call a message that did not arrive, or that its receiver cannot take."""
    what = f"{record.get('performative', '')} {record.get('message', '')}".strip()
    match record["kind"]:
        case "lost":
            what = str(record.get("channel") or "an agent message")
            return f"{what} to {record['peer']} is lost: {record['reason']}"
        case "unexpected":
            return f"does not expect {what} from {record['sender']}: {record['reason']}"
        case "unsent":
            return f"{what} is not sent: {record['reason']}"
        case "expired":
            return f"{record['channel']} has expired: nothing has taken it"
        case _:
            return f"{record['channel']} is not published: {record['reason']}"


def failing(plan: Plan, reason: str) -> str:
    """Why an agent has failed: the place of the activity, and that no transition has taken its failure."""
    found = re.search(r" of state ([\d.]+) failed: ", reason)
    if found is None or found[1] not in plan.by_label:
        return reason
    at = without_column(plan.by_label[found[1]].at)
    text = f"{reason[: found.start()]} ({at}) failed: {reason[found.end() :]}"
    return f"{text}; no `error` transition leads out of there"


def ending(record: Record) -> str:
    """What people call the end of an activity."""
    how = record.get("outcome") or record.get("reason")
    return (
        f"{record['activity']} {'returns' if record['what'] == 'end' else 'fails'}{f': {how}' if how else ''}"
    )


__all__ = [
    "LONG",
    "Said",
    "content_of",
    "cut",
    "ending",
    "failing",
    "few",
    "fields_of",
    "leaf_names",
    "name_of",
    "sending",
    "way",
    "went_wrong",
]
