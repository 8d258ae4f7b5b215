"""Words: what is written at the transitions and in the states of a chart, and what a page explains below."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from functools import lru_cache

from aseme_dsl.amola.expression import (
    Assign,
    Member,
    Named,
    Publish,
    Received,
    Value,
    action_text,
    duration_text,
    event_text,
    value_text,
    values_of,
)
from aseme_dsl.amola.messages import Channel
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, Transition, TransitionKind
from aseme_dsl.diagrams.compact.elements import SIZES, Link, Look
from aseme_dsl.diagrams.look.labels import room_for, wrapped
from aseme_dsl.records import dataclass

_CONSTANT = re.compile(r"\b[A-Z]\w*[a-z]\w*\.([A-Z][A-Z0-9_]+)\b")
_CHANNEL = re.compile(r"\b(\w+)\.(state|signal|data)\.(\w+)")
_QUOTED = re.compile(r'("(?:[^"\\]|\\.)*")')

_LONGEST = 96
"""A longer text is cut, and stands in full below the drawing."""

_LONG_PARAGRAPH = 84
"""The same for a paragraph in a state."""

_MOST = 4
"""Of more actions, the others stand below the drawing."""

_CHARACTER = 5.6
"""How wide a character is in the middle, in px: for the number of characters of a line."""

ICONS = "⚡↯✕↻◷✉➤Ⓗ∞"
"""Signs that are drawn; each takes the room of `ICON`."""

ICON = 16.0

INDENT = ICON
"""How far the further rows of a transition are indented where several stand one below the other, in px."""

Row = tuple[str, Look]
Rows = tuple[tuple[Row, ...], tuple[Row, ...]]


_NUMBER = "\ue000\ue000"
_NOTE = f"… ({_NUMBER})"
"""What a cut text ends with before its number is known."""

_ONE_FIGURE = re.compile(r"… \(\d\)$")

BOLD = (Look.NAME, Look.TITLE, Look.FIELD)


def width(text: str, look: Look) -> float:
    """How wide a text is, with a little room for other fonts."""
    sign = text[:1] in ICONS and text != ""
    plain = text[1:].lstrip() if sign else text
    if _ONE_FIGURE.search(plain):
        plain += "0"
    return room_for(plain, SIZES[look], bold=look in BOLD) + (ICON if sign else 0)


def outside_quotes(text: str, changed: Callable[[str], str]) -> str:
    """The text, changed but for what stands in quotes."""
    parts = _QUOTED.split(text)
    return "".join(part if number % 2 else changed(part) for number, part in enumerate(parts))


@dataclass(frozen=True, slots=True)
class Said:
    """What is said of a transition: its head (event and guard), its actions, and whether that is long.

    `acts` are the actions as they stand in a paragraph.
    """

    head: str
    actions: tuple[str, ...]
    acts: tuple[str, ...]
    long: bool


class Words:
    """The texts of a chart. A long text gets a number when it is asked for first: its place in `notes`."""

    def __init__(
        self, chart: Statechart, activities: Iterable[Activity] = (), notes: Sequence[int] = ()
    ) -> None:
        self._chart = chart
        self._activities = {item.name: item for item in activities}
        self.channels = self._channels()
        self.notes = list(notes)
        self._ranks = self._ranked()
        self._said = tuple(self._saying(place, item) for place, item in enumerate(chart.transitions))
        self._rows: dict[tuple[int, bool, float], Rows] = {}
        self._used: set[int] = set()

    def anew(self) -> Words:
        """The same texts, without the numbers given so far."""
        other = copy(self)
        other.notes, other._rows, other._used = [], {}, set()
        return other

    def has_text(self, place: int) -> bool:
        said = self._said[place]
        return bool(said.head or said.actions)

    def is_for_errors(self, place: int) -> bool:
        return self._chart.transitions[place].expression.is_for_errors

    def exit(self, place: int, wide: float, cuts: bool) -> tuple[Row, ...]:
        """A transition that leads out of a state, as rows of a table in that state."""
        return self._paragraph(place, f"{self._mark(place, cuts) or '→'} ", self._look(place, cuts), wide)

    def one_of_many(self, place: int, wide: float, cuts: bool) -> tuple[Row, ...]:
        """A transition at a line that stands for several."""
        mark = self._mark(place, cuts)
        return self._paragraph(place, f"{mark} " if mark else "", self._look(place, cuts), wide)

    def inside(self, place: int, wide: float) -> tuple[Row, ...]:
        """A transition that belongs to a state, as rows in that state."""
        return self._paragraph(place, "", Look.SMALL, wide)

    def _paragraph(self, place: int, before: str, look: Look, wide: float) -> tuple[Row, ...]:
        """A transition as one paragraph; a long one is cut."""
        self._used.add(place)
        said = self.text(place) or "done"
        said = f"{before}{_without_sign(said)}" if before else said
        if len(said) > _LONG_PARAGRAPH:
            said = f"{said[: _LONG_PARAGRAPH - 10].rpartition(' ')[0]} {_NOTE}"
        return tuple((line, look) for line in self._broken(said, place, max(12, int(wide / _CHARACTER))))

    def _broken(self, text: str, place: int, characters: int) -> tuple[str, ...]:
        """A text in lines, with the number of the transition if it is cut.

        Each number takes the room of two figures, so that others may come before it.
        """
        lines = balanced(text, characters)
        if _NUMBER not in text:
            return lines
        if place not in self.notes:
            self.notes.append(place)
        return tuple(line.replace(_NUMBER, str(self.notes.index(place) + 1)) for line in lines)

    def _look(self, place: int, cuts: bool) -> Look:
        return Look.ERROR if self.is_for_errors(place) else Look.CUT if cuts else Look.LABEL

    def _mark(self, place: int, cuts: bool) -> str:
        first = self._chart.transitions[place].first
        return "✕" if self.is_for_errors(place) else ("⚡" if first else "↯") if cuts else ""

    def rows(self, place: int, wide: float, cuts: bool = False) -> Rows:
        """What stands above the line of a transition, and below (its actions), in lines about so wide."""
        self._used.add(place)
        key = (place, cuts, wide)
        if key not in self._rows:
            self._rows[key] = self._written(place, cuts, max(12, int(wide / _CHARACTER)))
        return self._rows[key]

    def text(self, place: int) -> str:
        """All of a transition in one line, however long."""
        acts = "; ".join(self._said[place].acts)
        return f"{self._said[place].head}{' / ' if acts else ''}{acts}".strip()

    def about(self, label: str) -> str:
        """What is known of the activity of a state: its period, its duration and its deadline."""
        state = self._chart.node(label)
        known = self._activities.get(state.activity or "")
        if known is None:
            return ""
        return " · ".join(
            filter(
                None,
                (
                    f"every {duration_text(known.every)}" if known.every else "",
                    f"takes {duration_text(known.takes)}" if known.takes else "",
                    f"≤ {duration_text(known.within)}" if known.within else "",
                    f"ends {' | '.join(known.ends)}" if known.ends else "",
                ),
            )
        )

    def short(self, text: str) -> str:
        """The text with `and` and `or` for signs, and constants and channels without what is around them."""
        return outside_quotes(text, self._shorter)

    def lets(self) -> dict[str, str]:
        """What each name of a `let` stands for that has been written, in the order of the chart.

        In instances of a formula it may stand for one thing after the other.
        """
        found: dict[str, dict[str, None]] = {}
        for value in self._written_values():
            if isinstance(value, Named) and value_text(value.expression) != value.name:
                found.setdefault(value.name, {})[self.short(value_text(value.expression))] = None
        order = " (one after the other in the drawing)"
        return {name: "; ".join(said) + order * (len(said) > 1) for name, said in found.items()}

    def short_channels(self) -> dict[str, str]:
        """Each channel by the short name that has been written for it."""
        items = self._chart.transitions
        found = (str(channel) for place in sorted(self._used) for channel in _channels_of(items[place]))
        names = {self.channels[full]: full for full in found}
        return {name: full for name, full in names.items() if name != full}

    def _written_values(self) -> Iterator[Value]:
        for place in sorted(self._used):
            yield from values_of(self._chart.transitions[place].expression)

    def _shorter(self, text: str) -> str:
        text = text.replace("&&", "and").replace("||", "or").replace("write_messages.", "publish ")
        text = _CHANNEL.sub(lambda match: self.channels.get(match[0], match[0]), text)
        return _CONSTANT.sub(r"\1", text)

    def _channels(self) -> dict[str, str]:
        """The short name of each channel: its message, unless that is on two topics."""
        used: dict[str, Channel] = {}
        for item in self._chart.transitions:
            used |= {str(channel): channel for channel in _channels_of(item)}
        found: dict[str, str] = {}
        for text, channel in used.items():
            names = (channel.message, f"{channel.topic}.{channel.message}")
            found[text] = next((name for name in names if _users(used.values(), name) == 1), text)
        return found

    def _ranked(self) -> Mapping[int, int]:
        """The number of each transition of a state whose order matters, and is not seen from its place.

        That is so where a state is repeated and left, and both wait for something of their own.
        """
        chart = self._chart
        places = {id(item): place for place, item in enumerate(chart.transitions)}
        found: dict[int, int] = {}
        for state in chart.states:
            edges = [
                item for item in chart.outgoing_edges(state.label) if not item.reactive and not item.first
            ]
            again = [item for item in edges if item.target == state.label]
            onward = [item for item in edges if item.target != state.label]
            if any(map(_waits, again)) and any(map(_waits, onward)):
                found |= {places[id(item)]: rank for rank, item in enumerate(filter(_waits, edges), 1)}
        return found

    def _saying(self, place: int, item: Transition) -> Said:
        raw = self._acts(item)
        head, actions = self._head(item), tuple(map(self._action, raw))
        if place in self._ranks:
            sign = head[:2] if head[:1] in ICONS else ""
            head = f"{sign}{self._ranks[place]}: {head.removeprefix(sign)}"
        long = len(head) > _LONGEST or len(actions) > _MOST or any(len(text) > _LONGEST for text in actions)
        return Said(head, actions, tuple(map(self.short, raw)), long)

    def _acts(self, item: Transition) -> tuple[str, ...]:
        return tuple(action_text(action) for action in item.expression.actions)

    def _head(self, item: Transition) -> str:
        expression = item.expression
        verb = {
            TransitionKind.ON: "on",
            TransitionKind.EXIT: "on exit",
            TransitionKind.ABANDON: "on abandon",
            TransitionKind.EXTERNAL: "Ⓗ" if item.resume else "",
        }[item.kind]
        events = []
        for event in expression.events:
            text = event_text(event)
            if isinstance(event, Received):
                text = f"{text.removesuffix(f' from {event.participant}')} ← {event.participant}"
            events.append(text)
        head = "else" if expression.otherwise else " or ".join(events)
        if expression.every is not None:
            head = " or ".join(filter(None, (head, f"every {duration_text(expression.every)}")))
        if expression.condition is not None:
            guard = self.short(value_text(expression.condition))
            guard = f"when {guard}" if expression.when else f"[{guard}]"
            head = (" or " if expression.when else " ").join(filter(None, (head, guard)))
        if expression.weight is not None:
            head = f"{head} weight {expression.weight}".strip()
        sign = ""
        if not verb and any(isinstance(event, Received) for event in expression.events):
            sign = "✉ "
        elif not verb and ("after(" in head or "expired(" in head):
            sign = "◷ "
        return f"{verb} {sign}{head}".strip()

    def _action(self, text: str) -> str:
        if text.startswith("send ") and " to " in text:
            what, _, to = text.removeprefix("send ").rpartition(" to ")
            return f"➤ {self.short(what)} → {to}"
        return f"/ {self.short(text)}"

    def _written(self, place: int, cuts: bool, characters: int) -> Rows:
        said = self._said[place]
        look, mark = self._look(place, cuts), self._mark(place, cuts)
        note = _NOTE if said.long else ""
        head = said.head
        if mark:
            head = f"{mark} {_without_sign(head)}"
        above = (
            tuple((line, look) for line in self._broken(_cut(head, note), place, characters)) if head else ()
        )
        actions = [_cut(text, note) for text in said.actions[:_MOST]]
        if len(said.actions) > _MOST:
            actions[-1] = f"/ {note}"
        below = tuple(
            (line, Look.ACTION) for text in actions for line in self._broken(text, place, characters)
        )
        return above, below


def _channels_of(item: Transition) -> Iterator[Channel]:
    """The channels that a transition reads, sets or publishes."""
    for value in values_of(item.expression):
        if isinstance(value, Member):
            yield value.channel
    for action in item.expression.actions:
        if isinstance(action, Publish):
            yield action.channel
        elif isinstance(action, Assign) and isinstance(action.target, Member):
            yield action.target.channel


def _users(channels: Iterable[Channel], name: str) -> int:
    """How many channels may be meant by a short name."""
    return sum(name in (item.message, f"{item.topic}.{item.message}") for item in channels)


@lru_cache(10_000)
def balanced(text: str, characters: int) -> tuple[str, ...]:
    """The text in as few lines as fit, each as short as that allows without breaking words."""
    lines = wrapped(text, characters)
    longest = max(map(len, text.split()), default=0)
    while len(lines) > 1 and max(map(len, lines)) > longest:
        shorter = wrapped(text, max(map(len, lines)) - 1)
        if len(shorter) > len(lines) or max(map(len, shorter)) >= max(map(len, lines)):
            break
        lines = shorter
    return lines


def _without_sign(text: str) -> str:
    """The text behind another sign: what is resumed says so in a word."""
    if text[:1] == "Ⓗ":
        return f"resume{text[1:]}"
    return text[1:].lstrip() if text[:1] in ICONS else text


def _waits(item: Transition) -> bool:
    """Whether a transition waits for something else than that its source is complete and no other is open."""
    expression = item.expression
    return bool(expression.events) or expression.when or expression.condition is not None


def _cut(text: str, note: str) -> str:
    if len(text) <= _LONGEST:
        return text
    return f"{text[: _LONGEST - 12].rpartition(' ')[0]} {note}"


def indented(rows: Sequence[tuple[Row, int]]) -> Iterator[tuple[Row, int, float]]:
    """The rows of several transitions, and how far each is indented: all but the first of a transition."""
    before = None
    for row, place in rows:
        yield row, place, INDENT if place == before else 0.0
        before = place


def link_rows(
    words: Words, link: Link, wide: float, cuts: bool
) -> tuple[list[tuple[Row, int]], list[tuple[Row, int]]]:
    """The rows above and below the line of a link, each with its transition.

    Of several transitions, each has a paragraph of its own above the line.
    """
    if len(link) > 1:
        return [(row, place) for place in link for row in words.one_of_many(place, max(wide, 230), cuts)], []
    if not link:
        return [], []
    upper, lower = words.rows(link[0], wide, cuts)
    return [(row, link[0]) for row in upper], [(row, link[0]) for row in lower]
