"""Carrying over: a running chart continues as a chart of another version of its plan.

States are the same in both versions if they have the same type and the same name under the same named states:
`KickBall` in `action` in `decision` of `player`. What an activity is given does not count, nor does what a
formula says around them (`(A | B)` that has become `(A | B | C)`), nor do their labels. Where a name stands
there several times, the first is the first, if both versions have it as often.

All states that are active must be in the new version, and be active together there. Blackboards, histories,
timers, variables and waiting agent messages follow by name and type; a variable in which the team now sets
something else has that. Activities continue if the new version says the same of them, else they are cancelled
and started anew. A concurrent part that is new begins at its start.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import replace
from random import Random

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.bounds import admits
from aseme_dsl.runtime.chart.chart import INACTIVE, Chart
from aseme_dsl.runtime.chart.history import History
from aseme_dsl.runtime.chart.inputs import Cancel, Effect, Sample
from aseme_dsl.runtime.chart.plan import ActivityInfo, Plan, State, Transition, is_in
from aseme_dsl.runtime.message.convert import Messages, arrived, converted, like, mailed, same_shape

_NAME = re.compile(r"[A-Za-z_]\w*")


class CannotCarry(Exception):
    """A running chart has no place in the new version."""

    def __init__(self, reasons: Iterable[str]) -> None:
        self.reasons = tuple(reasons)
        super().__init__("; ".join(self.reasons))


@dataclass(frozen=True, slots=True)
class Carried:
    """A chart of the new version that stands where the old one stood; nothing has happened yet.

    `labels` gives the new label of each state that both versions have, active or not. `effects` are to be
    carried out when the chart is put in place.
    """

    chart: Chart
    labels: Mapping[str, str]
    entered: tuple[str, ...] = ()
    """The regions that are new and begin at their start."""
    restarted: tuple[str, ...] = ()
    """The states whose activity starts anew."""
    lost: tuple[str, ...] = ()
    """Channels and variables whose values could not be taken over."""
    effects: tuple[Effect, ...] = ()


# ---- which states are the same -------------------------------------------------------------------


class _Tree:
    """A plan's states with what they are known by."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.children: dict[str | None, list[State]] = defaultdict(list)
        for state in plan.states:
            self.children[state.parent].append(state)
        self.title: dict[str, str] = {}
        self.full: dict[str, tuple[str, ...]] = {}
        self.named: dict[str, tuple[str, ...]] = {}
        for state in plan.states:  # parents come before children
            title = state.name
            if title == state.label:  # it has none: what is in it
                title = " . ".join(c.name for c in self.children[state.label] if c.name != c.label)
            self.title[state.label] = title
            around = state.parent
            if around is None:
                self.full[state.label] = (title,)
                self.named[state.label] = ()
                continue
            self.full[state.label] = (*self.full[around], title)
            outer = self.title[around]
            is_named = _NAME.fullmatch(outer) is not None
            self.named[state.label] = (*self.named[around], outer) if is_named else self.named[around]

    def groups(self, kind: str) -> dict[object, list[str]]:
        """The labels by key, in document order: by the exact place, the full path, the path of names."""
        found: dict[object, list[str]] = defaultdict(list)
        for state in self.plan.states:
            key = self.key(state, kind)
            if key is not None:
                found[key].append(state.label)
        return found

    def key(self, state: State, kind: str) -> object:
        what = (state.type, state.activity, state.branch)
        match kind:
            case "exact":
                return (state.label, what, self.full[state.label])
            case "full":
                return (what, self.full[state.label])
        if kind == "activity":  # with any arguments
            return (what, self.named[state.label]) if state.type == "BASIC" else None
        if state.type in ("START", "END", "CONDITION") or not self.title[state.label]:
            return None
        return (what, self.named[state.label], self.title[state.label])


def same_states(old: Plan, new: Plan) -> dict[str, str]:
    """For the label of each state of the old plan that the new one has, its label there."""
    before, after = _Tree(old), _Tree(new)
    found: dict[str, str] = {old.states[0].label: new.states[0].label}
    taken = {new.states[0].label}

    def match(one: str, other: str) -> None:
        if one not in found and other not in taken:
            found[one] = other
            taken.add(other)

    for kind in ("exact", "full", "names", "activity"):
        there = after.groups(kind)
        for key, labels in before.groups(kind).items():
            others = there.get(key, [])
            if len(labels) == len(others):
                for one, other in zip(labels, others, strict=True):
                    match(one, other)
    for state in reversed(old.states):  # a composite whose formula has changed is around what was in it
        if state.type in ("OR", "AND") and state.label not in found:
            inside = [found[c.label] for c in before.children[state.label] if c.label in found]
            around = {after.plan.by_label[label].parent or "" for label in inside}
            composite = after.plan.by_label.get(around.pop()) if len(around) == 1 else None
            if composite is not None and composite.type == state.type:
                match(state.label, composite.label)
    for state in old.states:
        if state.type in ("START", "END", "CONDITION") and state.label not in found:
            home = found.get(state.parent or "")
            others = [c.label for c in after.children[home] if c.type == state.type] if home else []
            if len(others) == 1:
                match(state.label, others[0])
    return found


# ---- the running chart ---------------------------------------------------------------------------


def carry(
    old: Chart, kind: type[Chart], before: Messages, messages: Messages, now: int, labels: Mapping[str, str]
) -> Carried:
    """The chart `old`, which is between two steps, as one of the class `kind`; nothing is changed.

    `before` and `messages` are the message classes of the old and of the new version; `labels` is what
    `same_states` found.

    Raises:
        CannotCarry: a state that is active is not in the new version, or they are not active together there.
    """
    return _Carrying(old, kind(old.agent), before, messages, now, labels).carried()


class _Carrying:
    def __init__(
        self,
        old: Chart,
        new: Chart,
        before: Messages,
        messages: Messages,
        now: int,
        labels: Mapping[str, str],
    ) -> None:
        self.old = old
        self.new = new
        self.before = before
        self.messages = messages
        self.now = now
        self.labels = labels
        self.lost: list[str] = []
        self.reasons: list[str] = []
        self.leaves: dict[str, str] = {}
        """The new label of each active leaf but ANDs, with the old one."""
        self.running: dict[str, int] = {}
        """The old tokens of the activities that run, by new label."""
        self.active: set[str] = set()
        self.parents = {state.label: state.parent for state in new.PLAN.states}
        self.regions = {label: number for number, label in enumerate(new.REGIONS)}
        self.old_regions = {label: number for number, label in enumerate(old.REGIONS)}
        self.old_parents = {state.label: state.parent for state in old.PLAN.states}

    def carried(self) -> Carried:
        old, new = self.old, self.new
        new.now, new.started, new.tokens = old.now, old.started, old.tokens
        new.seed, new.raised = old.seed, old.raised
        if old.chance is not None:  # a copy: the old chart continues if some other agent cannot
            new.chance = Random()
            new.chance.setstate(old.chance.getstate())
        if not old.started:
            self._variables()
            self._board(0, [old.boards()[0]], primary=True)
            return Carried(new, self.labels, lost=tuple(dict.fromkeys(self.lost)))
        self._find_leaves()
        entered = self._check()
        if self.reasons:
            raise CannotCarry(self.reasons)
        self._set_leaves(entered)
        self._set_boards(entered)
        self._variables()
        self._times()
        self._counts()
        self._outcomes()
        self._marks()
        self._memories()
        self._mail()
        self._suspended()
        for number in entered:
            getattr(new, f"_enter_{number}")(self.now)
        restarted = self._restart()
        effects = tuple(new.effects)
        new.effects.clear()
        return Carried(
            new,
            self.labels,
            tuple(new.REGIONS[number] for number in entered),
            restarted,
            tuple(dict.fromkeys(self.lost)),
            effects,
        )

    # ---- where it stands ---------------------------------------------------------------------

    def _find_leaves(self) -> None:
        old = self.old
        for number, leaves in enumerate(old.LEAVES):
            place: int = getattr(old, f"r{number}")
            if place == INACTIVE:
                continue
            state = old.PLAN.by_label[leaves[place]]
            if state.type == "AND":
                continue  # it is active because its regions are
            label = self.labels.get(state.label)
            if label is None:
                self.reasons.append(f"is {_where(old.PLAN, state)}, which the new model does not have")
                continue
            self.leaves[label] = state.label
            if state.type == "BASIC" and old.RUNNING[state.label][2] == place:
                self.running[label] = getattr(old, f"k{number}")

    def _check(self) -> list[int]:
        """Find out which states are active in the new version; gives the regions that are new there."""
        new = self.new
        inside: dict[str, set[str]] = defaultdict(set)
        for leaf in self.leaves:
            label: str | None = leaf
            while label is not None:
                self.active.add(label)
                parent = self.parents[label]
                if parent is not None:
                    inside[parent].add(label)
                label = parent
        entered: list[int] = []
        for state in new.PLAN.states:
            if state.label not in self.active:
                continue
            if state.type == "OR" and len(inside[state.label]) > 1:
                names = " and ".join(sorted(new.PLAN.by_label[item].name for item in inside[state.label]))
                self.reasons.append(f"is in {names} at once, which the new model does not allow")
            elif state.type == "AND":
                entered += [
                    self.regions[child.label]
                    for child in new.PLAN.children(state.label)
                    if child.label not in self.active
                ]
        return entered

    def _set_leaves(self, entered: list[int]) -> None:
        new = self.new
        for label, number in self.regions.items():
            if label not in self.active or number in entered:
                continue
            places = new.LEAVES[number]
            leaf = next(item for item in places if item in self.active)
            place = places.index(leaf)
            if new.PLAN.by_label[leaf].type == "BASIC":
                if leaf in self.running:
                    setattr(new, f"k{number}", self.running[leaf])
                else:
                    place += 1
            setattr(new, f"r{number}", place)

    # ---- what it knows -----------------------------------------------------------------------

    def _set_boards(self, entered: list[int]) -> None:
        boards = self.old.boards()
        claimed: set[int] = set()
        for label, number in reversed(self.regions.items()):  # what is inside first
            if label not in self.active or number in entered:
                continue
            chain = self._old_regions_of(number)
            primary = chain[0] not in claimed
            claimed.add(chain[0])
            if number:
                kind = type(getattr(self.new, f"b{number}"))
                setattr(self.new, f"b{number}", kind())
            self._board(number, [boards[item] for item in chain], primary)

    def _old_regions_of(self, number: int) -> list[int]:
        """The old region that a new one continues, and those around it."""
        label = self.new.REGIONS[number]
        inside = [leaf for leaf in self.leaves if (leaf + ".").startswith(label + ".")]
        leaf = next((leaf for leaf in inside if leaf in self.new.LEAVES[number]), inside[0])
        mine = _around(leaf, self.parents, self.regions)
        theirs = _around(self.leaves[leaf], self.old_parents, self.old_regions)
        place = mine.index(number)
        if place == len(mine) - 1 and place > 0:
            return theirs[-1:]
        return theirs[place:] or theirs[-1:]

    def _board(self, number: int, chain: list[Board | None], primary: bool) -> None:
        board: Board = getattr(self.new, f"b{number}")
        boards = [item for item in chain if item is not None]
        for channel in sorted(board.CHANNELS):
            source = next((item for item in boards if channel in item.CHANNELS), None)
            if source is None:
                continue
            comm = channel.split(".", 2)[1]
            if comm == "state":
                states = {
                    sender: found
                    for sender, item in source._states.get(channel, {}).items()
                    if (found := self._item(item)) is not None
                }
                if states:
                    board._states[channel] = states
            elif comm == "data":
                data = self._items(source.history(channel))
                if data:
                    board._data[channel] = History(data)
            elif primary and source is boards[0] and channel in source._signals:
                board._signals[channel] = self._items(source._signals[channel])
            board._refresh(channel)
        if primary:
            first = boards[0]
            board.timers.update(first.timers)
            board.ahead |= first.ahead
            self._drafts(first, board)

    def _drafts(self, first: Board, board: Board) -> None:
        """What has been filled in of messages that are not published yet."""
        for (channel, host), members in first.drafts.items():
            name = channel.rpartition(".")[2]
            if same_shape(self.before.get(name), self.messages.get(name)):
                board.drafts[channel, host] = {
                    path: converted(value, self.messages) for path, value in members.items()
                }
            else:
                self.lost.append(channel)

    def _items(self, items: Iterable[Sample]) -> list[Sample]:
        return [found for item in items if (found := self._item(item)) is not None]

    def _item(self, item: Sample) -> Sample | None:
        try:
            return arrived(item, self.messages)
        except LookupError:
            self.lost.append(item.channel)
            return None

    def _variables(self) -> None:
        new = self.new
        known = {
            (variable.name.partition("@")[0], variable.type, self._scope(variable.scope)): variable.name
            for variable in self.old.PLAN.variables
        }
        newly_set = _newly_set(self.old, new)
        kept: set[str] = set()
        for variable in new.PLAN.variables:
            name = known.get((variable.name.partition("@")[0], variable.type, variable.scope))
            if name is None:
                continue
            if variable.name in newly_set:  # it has the value already
                kept.add(name)
                continue
            try:
                value = like(self.old.variable(name), new.variable(variable.name), self.messages)
            except LookupError:
                continue
            if not admits(variable, value):
                continue
            new.set_variable(variable.name, value)
            kept.add(name)
        self.lost += [v.name for v in self.old.PLAN.variables if v.name not in kept]

    def _scope(self, scope: str | None) -> str | None:
        return None if scope is None else self.labels.get(scope, "gone")

    def _times(self) -> None:
        """When states were entered; of a new state, or where it was not counted before, it is now."""
        before = {label: other for other, label in self.labels.items()}
        for label, slot in self.new.TIMES.items():
            old = self.old.TIMES.get(before.get(label, ""))
            setattr(self.new, slot, self.now if old is None else getattr(self.old, old))

    def _counts(self) -> None:
        """How often states were entered; one that was not counted before, once if it is active."""
        before = {label: other for other, label in self.labels.items()}
        leaves = self.new.configuration()
        for label, slot in self.new.COUNTS.items():
            old = self.old.COUNTS.get(before.get(label, ""))
            if old is not None:
                setattr(self.new, slot, getattr(self.old, old))
            elif any(is_in(leaf, label) for leaf in leaves):
                setattr(self.new, slot, 1)

    def _outcomes(self) -> None:
        """How activities have ended, as far as they may still end so."""
        infos = {info.name: info for info in self.new.PLAN.activities}
        for label, outcome in self.old.outcomes.items():
            new = self.labels.get(label)
            info = infos.get(self.new.PLAN.by_label[new].activity or "") if new is not None else None
            if new is not None and info is not None and info.ends:
                known = outcome if outcome in info.ends else None
                if known != outcome:
                    self.lost.append(f"outcome of {info.name}")
                self.new.outcomes[new] = known

    def _marks(self) -> None:
        """What the `on` transitions of both versions remember: one that was taken for what is there is not
        taken for it again."""
        known = {
            self._key(self.old.PLAN.transitions[number], self.labels): number for number in self.old.MARKS
        }
        same = {label: label for label in self.parents}
        for number, (slot, past) in self.new.MARKS.items():
            before = known.get(self._key(self.new.PLAN.transitions[number], same))
            if before is None:
                continue
            old_slot, old_past = self.old.MARKS[before]
            if slot and old_slot and getattr(self.old, old_slot) is not None:
                setattr(self.new, slot, getattr(self.new, f"_seen_{number}")())
            if past and old_past:
                setattr(self.new, past, getattr(self.old, old_past))

    def _memories(self) -> None:
        """Where states were left that may be resumed, if all that is remembered is there in both versions."""
        for label, slot in self.old.KEPT.items():
            kept: dict[int, int] | None = getattr(self.old, slot)
            new = self.new.KEPT.get(self.labels.get(label, ""))
            if kept is None:
                continue
            carried: dict[int, int] = {}
            for number, place in kept.items():
                if place == INACTIVE:
                    continue
                leaves = self.old.LEAVES[number]
                leaf = self.labels.get(leaves[place])
                home = next((n for n, there in enumerate(self.new.LEAVES) if leaf in there), None)
                if leaf is None or home is None:
                    new = None
                    break
                carried[home] = self.new.LEAVES[home].index(leaf) + place - leaves.index(leaves[place])
            if new is None:
                self.lost.append(f"where {self.old.PLAN.by_label[label].name} was left")
            else:
                setattr(self.new, new, carried)

    def _suspended(self) -> None:
        """The participants that are suspended, as far as it is known where they continue; others are left."""
        new = self.new
        for branch, kept in self.old.suspended.items():
            label = self.labels.get(branch, "")
            memories = [slot for state, slot in new.KEPT.items() if f"{label}.".startswith(f"{state}.")]
            if label in new.mail and any(getattr(new, slot) is not None for slot in memories):
                new.suspended[label] = kept
                for number, region in enumerate(self.old.REGIONS):
                    home = self.regions.get(self.labels.get(region, ""))
                    if f"{region}.".startswith(f"{branch}.") and home is not None:
                        getattr(new, f"b{home}").timers.update(getattr(self.old, f"b{number}").timers)
            elif label in new.mail:
                new.part(label)

    @staticmethod
    def _key(transition: Transition, labels: Mapping[str, str]) -> tuple[str | None, str]:
        return labels.get(transition.source), transition.text

    def _mail(self) -> None:
        self.new.rounds = self.old.rounds.carried(self.labels)
        for branch, waiting in self.old.mail.items():
            label = self.labels.get(branch)
            if label in self.new.mail:
                for item in waiting:
                    try:
                        self.new.mail[label] += (mailed(replace(item, branch=label), self.messages),)
                    except LookupError:
                        self.lost.append(item.message)

    # ---- what it does ------------------------------------------------------------------------

    def _restart(self) -> tuple[str, ...]:
        """Cancel and start anew what the new version says something else of."""
        before = {info.name: info for info in self.old.PLAN.activities}
        after = {info.name: info for info in self.new.PLAN.activities}
        restarted: list[str] = []
        for label, token in self.running.items():
            activity = self.new.PLAN.by_label[label].activity or ""
            info = after.get(activity)
            old = next(name for name, new in self.labels.items() if new == label)
            same = self.old.PLAN.by_label[old].arguments == self.new.PLAN.by_label[label].arguments
            if same and self._goes_on(before.get(activity), info):
                continue
            restarted.append(label)
            self.new.effects.append(Cancel(label, activity, token))
            owner = self.new.RUNNING[label][1]
            setattr(self.new, owner, self.new.begin_again(label, activity))
        return tuple(restarted)

    def _goes_on(self, before: ActivityInfo | None, info: ActivityInfo | None) -> bool:
        """Whether a running activity may continue; a changed deadline does not restart it."""
        if before is None or info is None:
            return before is info
        return replace(before, within=info.within) == info and self._same_messages(info)

    def _same_messages(self, info: ActivityInfo | None) -> bool:
        channels = (*info.reads, *info.writes) if info is not None else ()
        names = {channel.rpartition(".")[2] for channel in channels}
        return all(same_shape(self.before.get(name), self.messages.get(name)) for name in names)


def _around(label: str, parents: Mapping[str, str | None], regions: Mapping[str, int]) -> list[int]:
    """The regions around a state, innermost first."""
    found: list[int] = []
    item: str | None = label
    while item is not None:
        if item in regions:
            found.append(regions[item])
        item = parents[item]
    return found


def _where(plan: Plan, state: State) -> str:
    """Where an agent is, for people."""
    place = f" ({state.at})" if state.at else ""
    if state.name != state.label:
        return f"in `{state.name}`{place}"
    around = state
    while around.parent is not None and around.name == around.label:
        around = plan.by_label[around.parent]
    what = {"START": "at the beginning of", "END": "at the end of"}.get(state.type, "in")
    return f"{what} `{around.name}`{place}"


def _newly_set(old: Chart, new: Chart) -> set[str]:
    """The variables in which the new version sets something in the agent that the old one does not."""
    before = {name: value for agent, name, value in old.PLAN.settings if agent == old.agent}
    after = {name: value for agent, name, value in new.PLAN.settings if agent == new.agent}
    return {name for name, value in after.items() if name not in before or before[name] != value}


def variables_of(old: Chart, new: Chart, messages: Messages) -> None:
    """Give a chart of another plan the role variables that both plans have by name and type."""
    known = {(v.name, v.type) for v in old.PLAN.variables if v.scope is None}
    for variable in new.PLAN.variables:
        if variable.scope is None and (variable.name, variable.type) in known:
            try:
                value = like(old.variable(variable.name), new.variable(variable.name), messages)
            except LookupError:
                continue
            if admits(variable, value):
                new.set_variable(variable.name, value)


def knowledge_of(old: Chart, new: Chart, messages: Messages) -> None:
    """Give a chart of another plan the states and histories of the agent's own blackboard."""
    theirs, mine = old.boards()[0], new.boards()[0]
    assert theirs is not None and mine is not None
    for channel in sorted(mine.CHANNELS & theirs.CHANNELS):
        try:
            if channel in theirs._states:
                mine._states[channel] = {
                    sender: arrived(item, messages) for sender, item in theirs._states[channel].items()
                }
            if channel in theirs._data:
                mine._data[channel] = History(arrived(item, messages) for item in theirs._data[channel])
        except LookupError:
            continue
        mine._refresh(channel)
