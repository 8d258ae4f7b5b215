"""The behaviours that are measured."""

from __future__ import annotations

from random import Random

from benchmarks.behaviours.description import (
    Action,
    Behaviour,
    Change,
    State,
    Transition,
    all_of,
    basic,
    counting,
    entered,
    one_of,
)

STEPS = 512
"""How many steps the inputs of a behaviour have before they begin again (an even number)."""


def alternating(*events: str) -> tuple[tuple[str, Change], ...]:
    """These events in turn, with nothing changed on the blackboard."""
    return tuple((events[number % len(events)], ()) for number in range(STEPS))


def two_states() -> Behaviour:
    """Two states that lead to each other."""
    root = one_of(
        "two_states",
        basic("s1", Transition("ping", "s2")),
        basic("s2", Transition("pong", "s1")),
    )
    return Behaviour("two_states", "two states", counting(root), (), alternating("ping", "pong"))


DEPTH = 8


def deep(name: str, title: str, event: str) -> Behaviour:
    """Two towers of eight states: `leaf` toggles at the bottom, `cross` leads from top to top."""

    def count(state: str) -> tuple[Action, ...]:
        return (("count", entered(state)),)

    def tower(here: str, other: str) -> State:
        bottom, beside = f"{here}{DEPTH}", f"{here}{DEPTH}b"
        inner: tuple[State, ...] = (
            basic(bottom, Transition("leaf", beside), entry=count(bottom)),
            basic(beside, Transition("leaf", bottom), entry=count(beside)),
        )
        for level in range(DEPTH - 1, 0, -1):
            on = (Transition("cross", f"{other}1"),) if level == 1 else ()
            inner = (one_of(f"{here}{level}", *inner, on=on, entry=count(f"{here}{level}")),)
        return inner[0]

    root = one_of(name, tower("a", "b"), tower("b", "a"))
    return Behaviour(name, title, root, (), alternating(event))


def regions() -> Behaviour:
    """Eight regions that all move on one event."""
    region = [
        one_of(
            f"r{number}",
            basic(f"r{number}x", Transition("toggle", f"r{number}y")),
            basic(f"r{number}y", Transition("toggle", f"r{number}x")),
        )
        for number in range(1, 9)
    ]
    root = one_of("regions", all_of("all", *region))
    return Behaviour("regions", "eight regions on one event", counting(root), (), alternating("toggle"))


def player() -> Behaviour:
    """The player of the papers' Figure 4: twelve regions, its choices and joins as states of their own.

    `tick` is for what goes on inside `activate` and `action`, `tock` enters and leaves `action`, `calibrated`
    enters `activate`. Every fourth event is a `tock`; four flags change before each.
    """

    def tick(target: str, **flags: bool) -> Transition:
        return Transition("tick", target, tuple(flags.items()))

    def tock(target: str, **flags: bool) -> Transition:
        return Transition("tock", target, tuple(flags.items()))

    def forever(activity: str, done: str) -> State:
        return one_of(f"{activity}_forever", basic(activity, tick(activity, **{done: True})))

    def end(name: str, flag: str) -> State:
        return basic(name, entry=(("set", flag, True),))

    center = one_of(
        "center",
        basic(
            "CenterWalk",
            tick("CenterPass", walk_done=True, can_pass=True),
            tick("center_end", walk_done=True, can_pass=False),
        ),
        basic("CenterPass", tick("center_end", kick_done=True)),
        end("center_end", "role_ended"),
        on=(tick("do_end", role_ended=True),),
    )
    shot = one_of(
        "shot",
        basic(
            "ForWalkBall",
            tick("ForKick", walk_done=True, can_kick=True),
            tick("shot_end", walk_done=True, can_kick=False),
        ),
        basic("ForKick", tick("shot_end", kick_done=True)),
        end("shot_end", "shot_ended"),
        on=(tick("center_for_end", shot_ended=True),),
    )
    center_for = one_of(
        "center_for",
        basic(
            "ForWalkGoal",
            tick("shot", at_goal=True, ball_near=True),
            tick("center_for_end", at_goal=True, ball_near=False),
        ),
        shot,
        end("center_for_end", "role_ended"),
        on=(tick("do_end", role_ended=True),),
    )
    do = one_of(
        "do",
        basic(
            "Choose",
            tick("KickBall", can_kick=True),
            tick("center", is_center=True, engaged=True),
            tick("center_for", is_center=False, engaged=True),
            tick("WalkTowardsBall", engaged=False),
        ),
        basic("WalkTowardsBall", tick("do_end", walk_done=True)),
        basic("KickBall", tick("do_end", kick_done=True)),
        center,
        center_for,
        end("do_end", "do_ended"),
    )
    track = one_of(
        "track",
        basic("TrackBall", tick("track_end", track_done=True)),
        end("track_end", "track_ended"),
    )
    begun = [("set", flag, False) for flag in ("do_ended", "track_ended", "role_ended", "shot_ended")]
    action = all_of(
        "action",
        track,
        do,
        on=(
            tock("CheckForBall", do_ended=True, track_ended=True),
            tock("ScanForBall", ball_seen=False, abort=True),
        ),
        entry=(("count", entered("action")), *begun),
    )
    decision = one_of(
        "decision",
        basic("CheckForBall", tock("action", ball_seen=True), tick("ScanForBall", ball_seen=False)),
        basic("ScanForBall", tick("CheckForBall", scan_done=True)),
        action,
    )
    activate = all_of(
        "activate",
        forever("Vision", "vision_done"),
        forever("Localization", "localization_done"),
        forever("ObstacleAvoidance", "obstacles_done"),
        forever("HeadHandler", "head_done"),
        decision,
        entry=(("count", entered("activate")),),
    )
    initialize = one_of(
        "initialize",
        basic("Stand", tick("CalibrateCamera", stand_done=True)),
        basic("CalibrateCamera", Transition("calibrated", "activate")),
        entry=(("count", entered("initialize")),),
    )
    root = one_of(
        "player",
        all_of(
            "play",
            forever("Sensors", "sensors_done"),
            forever("RobotController", "controller_done"),
            forever("LedHandler", "leds_done"),
            forever("MotionController", "motion_done"),
            one_of("main", initialize, activate),
        ),
    )
    return Behaviour("player", "the player", counting(root), (*INPUTS, *OWN), _player_steps())


INPUTS = (
    "sensors_done",
    "controller_done",
    "leds_done",
    "motion_done",
    "vision_done",
    "localization_done",
    "obstacles_done",
    "head_done",
    "stand_done",
    "walk_done",
    "can_pass",
    "kick_done",
    "can_kick",
    "at_goal",
    "ball_near",
    "is_center",
    "engaged",
    "track_done",
    "ball_seen",
    "abort",
    "scan_done",
)
OWN = ("do_ended", "track_ended", "role_ended", "shot_ended")
"""The flags of the player that the program sets, and those that the statechart itself sets."""

SEED = 14
"""With which every state of the player is entered in the course of its steps."""

CALIBRATED = 101
"""The step with the event `calibrated`; the player stands by then."""


OFTEN = {"ball_seen": 0.7, "can_kick": 0.3, "abort": 0.1}
"""How often a flag of the player is true: what is done a quarter of the time, others half, and these."""


def _player_steps() -> tuple[tuple[str, Change], ...]:
    """Four flags at random before each event."""
    random = Random(SEED)
    steps: list[tuple[str, Change]] = []
    for number in range(STEPS):
        chosen = random.sample(INPUTS, 4)
        change = tuple(
            (flag, random.random() < OFTEN.get(flag, 0.25 if flag.endswith("_done") else 0.5))
            for flag in chosen
        )
        steps.append(("tock" if number % 4 == 3 else "tick", change))
    steps[CALIBRATED] = ("calibrated", steps[CALIBRATED][1])
    return tuple(steps)


def idle() -> Behaviour:
    """A state that twenty conditions could end; none ever does."""
    flags = tuple(f"flag_{number}" for number in range(1, 21))
    root = one_of(
        "idle",
        basic("Waiting", *(Transition("tick", "Woken", ((flag, True),)) for flag in flags)),
        basic("Woken"),
    )
    return Behaviour("idle", "an idle tick with 20 guards", counting(root), flags, alternating("tick"))


def ring(states: int) -> Behaviour:
    """Rings of ten states each, a ring of them: `next` goes on in the small ring, `jump` in the large one."""
    groups = states // 10
    going = (("stopped", False),)
    rings = [
        one_of(
            f"g{group}",
            *(
                basic(f"g{group}s{place}", Transition("next", f"g{group}s{(place + 1) % 10}", going))
                for place in range(10)
            ),
            on=(Transition("jump", f"g{(group + 1) % groups}"),),
        )
        for group in range(groups)
    ]
    # Some way along each small ring, so that states early and late in the document are met.
    steps = alternating(*["next"] * 7, "jump")
    root = one_of(f"ring_{states}", *rings)
    return Behaviour(f"ring_{states}", f"a ring of {states} states", root, ("stopped",), steps)


def switch() -> Behaviour:
    """A small machine of which a program has very many: two states that are on, and one that is off."""
    root = one_of(
        "switch",
        one_of(
            "On",
            basic("Dim", Transition("toggle", "Bright")),
            basic("Bright", Transition("toggle", "Dim")),
            on=(Transition("turn_off", "Off"),),
        ),
        basic("Off", Transition("turn_on", "On")),
    )
    steps = alternating("toggle", "toggle", "turn_off", "turn_on")
    return Behaviour("switch", "a small machine, many times", counting(root), (), steps)


def loop() -> Behaviour:
    """`(A . B)~`: two activities in turn, driven by their ends."""
    root = one_of("loop", basic("A", Transition("a_done", "B")), basic("B", Transition("b_done", "A")))
    ends = (("a_done", "A"), ("b_done", "B"))
    steps = alternating("a_done", "b_done")
    return Behaviour("loop", "a loop of two activities", counting(root), (), steps, ends=ends)


LOOPS = 8
FIRST_BALL, BALL_EVERY = 37, 19
"""The step before which the first message comes, and after how many there is another one."""
CLOSING = 2 * LOOPS
"""With so many steps at the end, all loops come back to where they began."""


def loops() -> Behaviour:
    """Eight times `(A . B)~` in parallel, driven by the ends of activities, which come in any order.

    In the first one, B waits for a message that says that the ball is near, and is absent at first: meanwhile
    it is remembered that A has ended.
    """

    def region(number: int) -> State:
        a, b = f"A{number}", f"B{number}"
        waiting = (basic(f"A{number}_ended", Transition("", b, (("ball.near", True),))),)
        return one_of(
            f"r{number}",
            basic(a, Transition(f"a{number}_done", b if number > 1 else waiting[0].name)),
            *(waiting if number == 1 else ()),
            basic(b, Transition(f"b{number}_done", a)),
        )

    numbers = range(1, LOOPS + 1)
    root = one_of("loops", all_of("all", *map(region, numbers)))
    return Behaviour(
        "loops",
        "eight loops, one waits for a message",
        counting(root, but=("A1_ended",)),
        (),
        _ends_of_loops(),
        messages=(("ball", "near"),),
        ends=tuple(
            (f"{kind.lower()}{number}_done", f"{kind}{number}") for number in numbers for kind in "AB"
        ),
        ended=(("A1_ended", "A1"),),
    )


def _ends_of_loops() -> tuple[tuple[str, Change], ...]:
    """The ends of activities that run, and whether the ball is near."""
    random = Random(SEED)
    is_b = dict.fromkeys(range(1, LOOPS + 1), False)
    is_waiting = is_near = False
    steps: list[tuple[str, Change]] = []

    def step(number: int, *near: bool) -> None:
        nonlocal is_waiting, is_near
        is_near = near[0] if near else is_near
        event = f"{'b' if is_b[number] else 'a'}{number}_done"
        steps.append((event, tuple(("ball.near", value) for value in near)))
        if number == 1 and not is_b[1]:
            is_waiting = True
        else:
            is_b[number] = not is_b[number]
        if is_waiting and is_near:
            is_waiting, is_b[1] = False, True

    while len(steps) < STEPS - CLOSING:
        comes = len(steps) >= FIRST_BALL and (len(steps) - FIRST_BALL) % BALL_EVERY == 0
        running = [number for number in is_b if not (number == 1 and is_waiting)]
        step(random.choice(running), *((random.random() < 0.5,) if comes else ()))
    step(2, True)  # what waits goes on, and has to end like all that has begun
    for number in reversed(is_b):
        if is_b[number]:
            step(number)
    while len(steps) < STEPS - 1:
        step(2)
    step(2, False)
    assert not any(is_b.values()), "the first step comes after the last one"
    return tuple(steps)


def lamps(number: int) -> Behaviour:
    """So many regions of two states in parallel, of which a program has very many."""
    region = [
        one_of(
            f"lamp{place}",
            basic(f"off{place}", Transition("toggle", f"on{place}")),
            basic(f"on{place}", Transition("toggle", f"off{place}")),
        )
        for place in range(1, number + 1)
    ]
    root = one_of(f"lamps_{number}", all_of("lamps", *region))
    return Behaviour(f"lamps_{number}", f"{number} lamps", root, (), alternating("toggle"))


BEHAVIOURS = {
    behaviour.name: behaviour
    for behaviour in (
        two_states(),
        deep("deep_leaf", "depth 8, a transition of the leaf", "leaf"),
        deep("deep_top", "depth 8, a transition of the top", "cross"),
        regions(),
        player(),
        idle(),
        loop(),
        loops(),
        ring(100),
        ring(1000),
        switch(),
    )
}

MANY = {1: BEHAVIOURS["switch"], 8: BEHAVIOURS["regions"], 64: lamps(64)}
"""Those of which there are very many at once, by the number of their regions."""
