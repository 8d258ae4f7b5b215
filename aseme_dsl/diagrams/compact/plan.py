"""Plan: what a drawing leaves out because something else stands for it, found before anything is placed."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.statechart import OriginKind, State, Statechart, transition_text
from aseme_dsl.diagrams.compact.blocks import Activity, Block, Closed, Group, Parallel, Part, inside
from aseme_dsl.diagrams.compact.elements import Link
from aseme_dsl.diagrams.compact.endings import Endings
from aseme_dsl.diagrams.compact.words import Words
from aseme_dsl.records import dataclass

_TABLE = 3
"""More exits than this stand as a table in the state."""


@dataclass(frozen=True, slots=True)
class Links:
    """The links of a part by how they are drawn.

    `again` and `onward` wait until the part is complete; `back` and `events` interrupt it. `lost` lead to
    what is never reached, and are drawn all the same; `never` are not drawn as lines.
    """

    again: Link
    back: Link
    onward: Link
    events: Link
    lost: Link
    never: Link


class Plan:
    """Answers questions about the blocks of one chart."""

    def __init__(self, chart: Statechart, words: Words, endings: Endings) -> None:
        self._chart = chart
        self._words = words
        self._endings = endings
        staying: dict[str, list[int]] = {}
        for place, item in enumerate(chart.transitions):
            if not item.changes_state:
                staying.setdefault(item.source, []).append(place)
        self._staying = {label: tuple(found) for label, found in staying.items()}

    def staying(self, label: str) -> Link:
        """The transitions that belong to a state and do not leave it."""
        return self._staying.get(label, ())

    def live(self, link: Link) -> Link:
        return tuple(place for place in link if place not in self._endings.never)

    def never(self, link: Link) -> Link:
        return tuple(place for place in link if place in self._endings.never)

    def events(self, block: Block, link: Link) -> Link:
        """Those that interrupt what is inside a composite."""
        if isinstance(block, Activity):
            return ()
        items = self._chart.transitions
        return tuple(
            place for place in link if items[place].expression.events or items[place].expression.when
        )

    def links(self, part: Part, dotted: bool) -> Links:
        """The links of a part; if it is `dotted`, something stands behind it that is never reached."""
        again, onward = self.live(part.again), self.live(part.onward)
        back, events = self.events(part.block, again), self.events(part.block, onward)
        lost = self.never(part.onward)
        return Links(
            tuple(item for item in again if item not in back),
            back,
            tuple(item for item in onward if item not in events),
            events,
            lost if dotted else (),
            (*self.never(part.again), *(() if dotted else lost)),
        )

    def is_endless(self, label: str) -> bool:
        return not self._endings.completes(label)

    def goes_on(self, part: Part) -> bool:
        """Whether something follows a part."""
        return bool(self.live(part.onward)) or any(self.goes_on(cut.part) for cut in part.cuts)

    def only(self, group: Group) -> Part | None:
        """The one part of a group that is nothing else."""
        if group.choice is not None or len(group.branches[0].parts) != 1:
            return None
        part = group.branches[0].parts[0]
        return None if part.cuts or group.reactive else part

    def is_around_regions(self, region: Group) -> bool:
        """Whether a region is nothing but the line to an AND and from it."""
        part = self.only(region)
        while part is not None and isinstance(part.block, Group):
            part = self.only(part.block)
        return part is not None and isinstance(part.block, Parallel)

    def merges(self, group: Group, bordered: bool) -> Part | None:
        """The one part of a framed group that has its frame.

        Where lines leave the frame of the group (it is `bordered`), none may leave that of the part.
        """
        part = self.only(group)
        if part is None or part.again or self._has_text(group.branches[0].enter):
            return None
        block = part.block
        if bordered and self.events(block, part.onward):
            return None
        if isinstance(block, Parallel):
            return part
        if isinstance(block, Group):
            inner, outer = self._chart.node(block.label), self._chart.node(group.label)
            same = inner.name == outer.name and not self._chart.is_branch(outer)
            free = not self.is_named(inner) and not self._chart.is_branch(inner)
            return part if (same or free) and not self.staying(block.label) else None
        return None

    def alone(self, group: Group) -> Part | None:
        """The one activity of a named group, whose node has the name as well."""
        part = self.only(group)
        plain = part is not None and not part.again and isinstance(part.block, Activity)
        if part is None or not plain or self.staying(group.label):
            return None
        if self._chart.is_branch(self._chart.node(group.label)):
            return None
        return None if self._has_text(group.branches[0].enter, part.onward) else part

    def title(self, region: Group | Closed) -> str | None:
        """The formula that fills a region: it has no frame of its own, as the region has its name."""
        part = self.only(region) if isinstance(region, Group) else None
        while part is not None and isinstance(part.block, Group):
            label = part.block.label
            events = self.events(part.block, (*part.onward, *part.again))
            if events or self.staying(label) or self._chart.is_branch(self._chart.node(label)):
                return None
            if self.is_named(self._chart.node(label)):
                return label
            part = self.only(part.block)
        return None

    def pill(self, region: Group | Closed) -> str | None:
        """The activity that a region repeats for ever, without a word at its transitions."""
        part = self.only(region) if isinstance(region, Group) else None
        inner = self.only(part.block) if part is not None and isinstance(part.block, Group) else None
        if part is None or inner is None or not isinstance(region, Group):
            return None
        block = inner.block
        if not isinstance(block, Activity) or not inner.again or inner.onward or part.again:
            return None
        group = part.block
        assert isinstance(group, Group)
        quiet = not any(map(self.staying, (region.label, group.label, block.label)))
        links = (region.branches[0].enter, part.onward, group.branches[0].enter, inner.again)
        return block.label if quiet and not self.live(part.onward) and not self._has_text(*links) else None

    def runs(self, block: Parallel) -> Iterator[tuple[Group | Closed, ...]]:
        """The regions in document order: pills side by side, equal ones together, else each alone."""
        run: list[Group | Closed] = []
        for region in block.regions:
            if run and self._together(run[0], region):
                run.append(region)
            else:
                if run:
                    yield tuple(run)
                run = [region]
        yield tuple(run)

    def _together(self, first: Group | Closed, region: Group | Closed) -> bool:
        pills = self.pill(first), self.pill(region)
        if pills[0] is None and pills[1] is None:
            return equal(self._chart, first.label, region.label)
        return None not in pills

    def is_framed(self, label: str) -> bool:
        """Whether an OR has a border in any case."""
        state = self._chart.node(label)
        return self.is_named(state) or bool(self.staying(label)) or self._chart.is_branch(state)

    def is_named(self, state: State) -> bool:
        """Whether an OR is a formula with a name."""
        return state.name != state.label and state.name.partition("(")[0].replace(".", "_").isidentifier()

    def heading(self, label: str) -> tuple[str, str]:
        """The title of a frame, and what else is said of it."""
        state = self._chart.node(label)
        name = state.name if self.is_named(state) else ""
        origin = state.origin
        if origin.kind is OriginKind.PROTOCOL and self._chart.is_branch(state):
            more = f"{origin.owner} · {origin.name}" if origin.name else origin.owner
            return name or more, more if name else ""
        return name, ""

    def called(self, label: str) -> str:
        """What the drawing of a state is called: its formula, or its label."""
        if label == self._chart.root.label:
            return self._chart.name
        return self.heading(label)[0] or f"part {label}"

    def tabled(self, link: Link) -> bool:
        """Whether the texts of a link stand as a table in its source."""
        return len(link) > _TABLE

    def _has_text(self, *links: Link) -> bool:
        return any(len(link) > 1 or self._words.has_text(place) for link in links for place in link)


def transitions_in(chart: Statechart, label: str) -> Link:
    """The transitions inside a state, those that do not leave it among them."""
    states = set(inside(chart, label))
    items = enumerate(chart.transitions)
    return tuple(
        place
        for place, item in items
        if item.source in states and (item.source != label or not item.changes_state)
    )


def equal(chart: Statechart, one: str, other: str) -> bool:
    """Whether two composites differ in nothing but their labels."""
    first, second = inside(chart, one), inside(chart, other)
    if len(first) != len(second):
        return False
    same = dict(zip(first, second, strict=True))
    for mine, its in same.items():
        a, b = chart.node(mine), chart.node(its)
        names = (a.name == b.name) or (a.name == mine and b.name == its)
        if a.type is not b.type or a.activity != b.activity or a.origin != b.origin or not names:
            return False
        if mine != one and same.get(a.parent or "") != b.parent:
            return False
    mine_, its_ = transitions_in(chart, one), transitions_in(chart, other)
    return len(mine_) == len(its_) and all(
        _alike(chart, same, here, there) for here, there in zip(mine_, its_, strict=True)
    )


def _alike(chart: Statechart, same: dict[str, str], here: int, there: int) -> bool:
    a, b = chart.transitions[here], chart.transitions[there]
    ends = same.get(a.source) == b.source and same.get(a.target) == b.target
    kinds = (a.kind, a.first, a.resume, a.reactive) == (b.kind, b.first, b.resume, b.reactive)
    return ends and kinds and transition_text(a) == transition_text(b)
