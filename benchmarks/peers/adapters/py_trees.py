"""py_trees: behaviour trees, which have neither events nor states: what they can do of the behaviours.

The idle tick is a choice of twenty conditions. The player is a tree that does about the same: its counts
differ, as a tree is asked from the top at each tick and has no event of its own for what enters and leaves.
"""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour as State
from py_trees.common import ParallelPolicy, Status
from py_trees.composites import Parallel, Selector, Sequence
from py_trees.decorators import Repeat

from benchmarks.behaviours.description import Behaviour, Guard, entered, left
from benchmarks.peers.adapters.python_code import Blackboard, Send, guard_function

DISTRIBUTION = "py_trees"


class Activity(State):
    """Runs until a condition holds; its entries and exits are counted."""

    def __init__(self, name: str, bb: Blackboard, is_done: Callable[[], bool]) -> None:
        super().__init__(name)
        self.bb = bb
        self.is_done = is_done
        self.entered = entered(name)
        self.left = left(name)

    def initialise(self) -> None:
        """Count the entry."""
        if self.entered in self.bb:
            self.bb[self.entered] += 1

    def update(self) -> Status:
        """Ask the condition."""
        return Status.SUCCESS if self.is_done() else Status.RUNNING

    def terminate(self, new_status: Status) -> None:
        """Count the exit."""
        if self.left in self.bb:
            self.bb[self.left] += 1


class Condition(State):
    """Succeeds or fails at once."""

    def __init__(self, name: str, holds: Callable[[], bool]) -> None:
        super().__init__(name)
        self.holds = holds

    def update(self) -> Status:
        """Ask the condition."""
        return Status.SUCCESS if self.holds() else Status.FAILURE


def maker(behaviour: Behaviour, bb: Blackboard) -> Callable[[], Send]:
    """What makes a tree and returns what ticks it, whatever the event.

    Raises:
        NotImplementedError: the behaviour lives from events, which a tree does not have.
    """
    if behaviour.name not in ("idle", "player"):
        raise NotImplementedError("a behaviour tree has no events")

    def start() -> Send:
        # Without the tree's visitors and handlers, of which there are none.
        tick = (idle(behaviour, bb) if behaviour.name == "idle" else player(bb)).tick_once
        return lambda event: tick()

    return start


def idle(behaviour: Behaviour, bb: Blackboard) -> State:
    """Twenty conditions, else waiting."""
    waiting, woken = behaviour.root.children
    conditions = [
        Condition(way.guard[0][0], guard_function("", way.guard, bb)) for way in waiting.transitions
    ]
    leave = Sequence(
        "leave",
        memory=False,
        children=[
            Selector("wake up", memory=False, children=conditions),
            Activity(woken.name, bb, lambda: False),
        ],
    )
    return Selector("idle", memory=False, children=[leave, Activity(waiting.name, bb, lambda: False)])


def player(bb: Blackboard) -> State:
    """The player as somebody writes it who thinks in trees."""

    def guard(**flags: bool) -> Guard:
        return tuple(flags.items())

    def activity(name: str, **flags: bool) -> State:
        return Activity(name, bb, guard_function("", guard(**flags), bb))

    def condition(**flags: bool) -> State:
        return Condition(" ".join(flags), guard_function("", guard(**flags), bb))

    def all_of(name: str, *children: State) -> State:
        return Parallel(name, ParallelPolicy.SuccessOnAll(), list(children))

    def sequence(name: str, *children: State) -> State:
        return Sequence(name, memory=True, children=list(children))

    def choice(name: str, *children: State) -> State:
        return Selector(name, memory=True, children=list(children))

    def forever(child: State) -> State:
        return Repeat(f"{child.name} forever", child, -1)

    center = sequence(
        "center",
        activity("CenterWalk", walk_done=True),
        choice(
            "pass if possible",
            sequence("pass", condition(can_pass=True), activity("CenterPass", kick_done=True)),
            condition(can_pass=False),
        ),
    )
    center_for = sequence(
        "center_for",
        activity("ForWalkGoal", at_goal=True),
        choice(
            "shoot if near",
            sequence(
                "shoot",
                condition(ball_near=True),
                activity("ForWalkBall", walk_done=True),
                activity("ForKick", kick_done=True),
            ),
            condition(ball_near=False),
        ),
    )
    do = choice(
        "do",
        sequence("kick", condition(can_kick=True), activity("KickBall", kick_done=True)),
        sequence("as center", condition(is_center=True, engaged=True), center),
        sequence("as center_for", condition(is_center=False, engaged=True), center_for),
        sequence("walk", activity("WalkTowardsBall", walk_done=True)),
    )
    action = all_of("action", activity("TrackBall", track_done=True), do)
    decision = choice(
        "decision",
        sequence("act", condition(ball_seen=True), action),
        activity("ScanForBall", scan_done=True),
    )
    activate = all_of(
        "activate",
        forever(activity("Vision", vision_done=True)),
        forever(activity("Localization", localization_done=True)),
        forever(activity("ObstacleAvoidance", obstacles_done=True)),
        forever(activity("HeadHandler", head_done=True)),
        forever(decision),
    )
    return all_of(
        "player",
        forever(activity("Sensors", sensors_done=True)),
        forever(activity("RobotController", controller_done=True)),
        forever(activity("LedHandler", leds_done=True)),
        forever(activity("MotionController", motion_done=True)),
        sequence("main", activity("Stand", stand_done=True), activate),
    )
