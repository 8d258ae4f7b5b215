"""ChartState: the data of a running statechart, and what the generated classes say of theirs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from random import Random
from typing import TYPE_CHECKING, ClassVar

from aseme_dsl.runtime.chart.board import QUEUE, Board
from aseme_dsl.runtime.chart.inputs import AgentMessage, Outcome, Sample
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.chart.rounds import Rounds

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

COMMON = ("now", "started", "finished", "failure", "tokens", "breach", "drains", "woken", "raised")
"""What all charts have that is a plain immutable value between two steps, and may be another one then."""


class ChartState:
    """Where a running statechart is, what waits in it, and what its present step has done so far.

    A region is an integer slot with the number of its active leaf. A BASIC state has two numbers, one while
    its activity runs and the next one when it is complete.
    """

    __slots__ = (
        "_faults",
        "_functions",
        "abandoning",
        "agent",
        "breach",
        "chance",
        "drains",
        "effects",
        "events",
        "failed",
        "failure",
        "finished",
        "held",
        "index",
        "mail",
        "now",
        "outcome",
        "outcomes",
        "pending",
        "queue",
        "raised",
        "rounds",
        "seed",
        "spent",
        "started",
        "stopped_at",
        "suspended",
        "taken",
        "tokens",
        "woken",
        "writes",
    )

    PLAN: ClassVar[Plan]
    AGENT: ClassVar[type[object] | None] = None
    """What shows the chart as an agent with behaviours (`behaviours.py`), if it is to be shown so."""
    MESSAGES: ClassVar[Mapping[str, type[DataclassInstance]]] = {}
    """The message class of each channel that the chart publishes, and of each message it sends."""
    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {}
    """The numbers of the regions that read a channel."""
    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {}
    """For each BASIC state the slots of its region's leaf and token, and its number while it runs."""
    WAITING: ClassVar[frozenset[str]] = frozenset()
    """The BASIC states that never complete by themselves."""
    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """The slots that hold a variable: one, or one for each region that uses it."""
    REGIONS: ClassVar[tuple[str, ...]] = ()
    TIMES: ClassVar[Mapping[str, str]] = {}
    """The slots that hold when a state was entered, for those states where it matters."""
    COUNTS: ClassVar[Mapping[str, str]] = {}
    """The slots that hold how often a state was entered, for those states that a condition counts."""
    WAKES: ClassVar[Mapping[str, tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]]] = {}
    """Of each variable that wakes another region than the one that writes it: the copy that is read there.
    The slot of that region's leaf follows, and the first and last numbers of the leaves at which a condition
    reads it."""
    MISSED: ClassVar[Mapping[str, tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]]] = {}
    """Of each signal that a condition may miss: the number of a region and the slot of its leaf.
    The first and last numbers of the leaves at which such a condition reads it follow."""
    EXPIRING: ClassVar[bool] = False
    """Whether any region reads signals that expire."""
    WITHIN: ClassVar[Mapping[str, int]] = {}
    """The deadlines of BASIC states: how long their activities have from the entry, in ns."""
    KEPT: ClassVar[Mapping[str, str]] = {}
    """The slots of what is remembered of states that may be resumed: the numbers of their regions' leaves."""
    MARKS: ClassVar[Mapping[int, tuple[str, str]]] = {}
    """For each `on` transition the slots of what it saw when it was taken last, and of the time it waited."""
    PART_TIMERS: ClassVar[Mapping[str, tuple[str, tuple[str, ...]]]] = {}
    """Of each protocol branch that starts timers: the slot of their blackboard, and their names."""
    ABANDON: ClassVar[Mapping[str, str]] = {}
    """The methods with what protocol branches do when they are left before their END."""
    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = ()
    """The labels of each region's leaves by their numbers."""
    places: ClassVar[tuple[str, ...]] = ()
    """The attributes that hold a plain immutable value each (`saving.py`)."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if cls.REGIONS:  # one that was generated
            other = {*(f"b{number}" for number in range(len(cls.REGIONS))), *cls.KEPT.values()}
            # A class inside a generated one has its attributes.
            kinds = [kind for kind in reversed(cls.__mro__) if getattr(kind, "REGIONS", ())]
            own = [name for kind in kinds for name in kind.__dict__.get("__slots__", ())]
            cls.places = (*COMMON, *(name for name in own if name not in other))

    def __init__(self, agent: str) -> None:
        self.agent = agent
        self.now = 0
        self.started = False
        self.finished = False
        self.failure: str | None = None
        self.tokens = 0
        self.failed: dict[str, str] = {}
        self.breach: tuple[str, str] | None = None
        """Which state is entered though a variable could not hold what was written on the way, and why."""
        self.outcomes: dict[str, str | None] = {}
        """How the activities of states have ended, None for those that have not; the last is the newest."""
        self.events: set[str] = set()
        self.raised: tuple[str, ...] = ()
        """The events that actions have raised: each is for a step of its own, before what else has come."""
        self.spent: set[tuple[int, str]] = set()
        """The events that a transition of a region has taken in this step."""
        self.mail: dict[str, tuple[AgentMessage, ...]] = {info.label: () for info in self.PLAN.branches}
        self.rounds = Rounds()
        """Who was addressed in the branches, and who has answered."""
        self.abandoning = False
        """Whether a branch does now what it does when it is left before its END."""
        self.stopped_at = 0
        """Where among the effects of a step those begin that leave everything, for the chart has failed."""
        self.held: set[str] = set()
        """The branches that are suspended where they are left now, while a state is being left."""
        self.suspended: dict[str, tuple[int, dict[str, int]]] = {}
        """The branches that may be resumed: when each was left, and its timers then."""
        self.writes: list[tuple[int, str, object]] = []
        self.drains = False
        """Whether a step has dropped a signal behind which another one waits; reset like `woken`."""
        self.woken = False
        """Whether a step has written what another region reads; the caller of the next step resets it."""
        self.pending: Callable[[], Iterable[Sample]] = tuple
        self.queue = QUEUE
        """How many signals of a queued channel may wait in a region."""
        self._faults: set[int] = set()
        self._functions: dict[str, tuple[Callable[..., object], tuple[type, ...]]] = {}
        self.index = dict(self.PLAN.numbers).get(agent, 1)
        """The agent's number, in the range of agents of which it is one."""
        self.seed = 1
        self.chance: Random | None = None
        """What `random()` draws from; made with the first draw, from the run's seed and the agent's name."""
        self.outcome = Outcome()
        self.taken = self.outcome.taken
        self.effects = self.outcome.effects

    def settle(self) -> None:
        """Give the variables what the team sets in this agent."""
        for agent, name, value in self.PLAN.settings:
            if agent == self.agent:
                slots = self.VARIABLES[name]
                kind = type(getattr(self, slots[0]))
                self.set_variable(name, kind(value))

    # ---- generated -------------------------------------------------------------------------

    def enter(self) -> None:
        """Enter the root: its START becomes active."""
        raise NotImplementedError

    def round(self) -> bool:
        """One round over all regions; whether anything moved."""
        raise NotImplementedError

    def leave(self) -> None:
        """Leave everything: running activities are cancelled."""
        raise NotImplementedError

    def is_finished(self) -> bool:
        """Whether the root's END is active."""
        raise NotImplementedError

    def due(self, now: int) -> int | None:
        """The next moment after `now` at which time alone may enable something that is waited for."""
        raise NotImplementedError

    def configuration(self) -> tuple[str, ...]:
        """The labels of the active leaves, region by region in document order."""
        raise NotImplementedError

    def boards(self) -> tuple[Board | None, ...]:
        """The blackboard of each region, None where the region is not active."""
        raise NotImplementedError

    def all_boards(self) -> tuple[Board, ...]:
        """The blackboards of all regions."""
        raise NotImplementedError

    def values(self) -> tuple[object, ...]:
        """What the `places` hold, in their order."""
        raise NotImplementedError

    def set_values(self, values: tuple[object, ...]) -> None:
        """Let the `places` hold these again."""
        raise NotImplementedError

    # ---- questions between steps -----------------------------------------------------------

    def board_of(self, label: str) -> Board:
        """The blackboard of the region around a BASIC state."""
        return getattr(self, "b" + self.RUNNING[label][0][1:])  # type: ignore[no-any-return]

    def set_variable(self, name: str, value: object) -> None:
        """Set every copy of a variable."""
        for slot in self.VARIABLES[name]:
            setattr(self, slot, value)

    def variable(self, name: str) -> object:
        """The value of a variable between steps."""
        return getattr(self, self.VARIABLES[name][0])
