"""Machine: one step after the other, from wherever the events come."""

from __future__ import annotations

import contextlib
import copy
import gc
import pickle
import signal
import sys
import threading
from types import FrameType
from typing import Any

import pytest

from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.runtime.plain.machine import Machine
from aseme_dsl.runtime.plain.plain import ActivityFailed, Unsettled
from tests.support.generated import generate
from tests.support.plain_engine import plain_class

COUNTER = """
system Counter
srm R {
  var n : int = 0
  liveness { R = (A . B)~ }
  control R { enter B : hop / n = n + 1  leave B : hop }
}
"""
ENDLESS = """system S
srm R {
  var n : int = 0
  var m : int = 0
  liveness { R = a || b  a = Wait . Ping~  b = Pong~ }
  control a {
    enter (Ping~) : go
    repeat Ping : when [n > m] / m = n
  }
  control b { repeat Pong : when [n == m] / n = n + 1 }
}
"""


def chart(text: str, **options: bool) -> Any:
    return plain_class(generate(text), "R", PlainOptions(**options))


def test_it_does_what_the_chart_does() -> None:
    machine = Machine(chart(COUNTER)())
    machine.start()
    assert machine.send("hop")
    assert not machine.send("other")
    assert machine.chart.configuration() == ("0.2.3",)
    assert machine.send("hop")
    assert machine.chart.bb.n == 1


def test_a_strict_one_takes_a_word_that_is_no_event_for_a_mistake() -> None:
    kind = chart(COUNTER)
    assert kind.EVENTS == ("hop",)
    machine = Machine(kind(), strict=True)
    machine.start()
    for call in (machine.send, machine.post):
        with pytest.raises(ValueError, match=r"^R waits for no event 'hopp'; did you mean 'hop'\?$"):
            call("hopp")
        with pytest.raises(ValueError, match=r"no event 'other'; it waits for hop$"):
            call("other")
    assert machine.send("hop")
    machine.post("hop")
    assert machine.chart.bb.n == 1
    none = chart("system S srm R { liveness { R = A } }")
    with pytest.raises(ValueError, match="there is none"):
        Machine(none(), strict=True).send("hop")


def test_what_comes_during_a_step_is_taken_after_it() -> None:
    """An activity's method sends an event, and says that it has returned, while its state is entered."""
    order: list[str] = []

    class Watched(
        chart("system S srm R { liveness { R = A . B . C } control R { enter C : go } }", watched=True)
    ):  # type: ignore[misc]
        def start_A(self, label: str) -> None:
            order.append("A begins")
            assert not machine.done(label)
            order.append("A has begun")

        def start_B(self, label: str) -> None:
            order.append("B begins")
            machine.post("go")
            assert not machine.send("go")

        def start_C(self, label: str) -> None:
            order.append("C begins")

    machine: Machine[Any] = Machine(Watched())
    machine.start()
    assert order == ["A begins", "A has begun", "B begins", "C begins"]


def test_the_trace_tells_of_each_step() -> None:
    told: list[tuple[str, str, bool]] = []
    machine = Machine(chart(COUNTER)(), trace=lambda *step: told.append(step))
    machine.start()
    machine.send("hop")
    machine.post("no")
    machine.step()
    machine.done("0.2.2")
    assert told == [
        ("start", "", False),
        ("send", "hop", True),
        ("send", "no", False),
        ("step", "", False),
        ("done", "0.2.2", False),
    ]


def test_no_event_of_any_thread_is_lost_and_no_step_begins_in_another() -> None:
    inside = 0

    class Watched(chart(COUNTER, watched=True)):  # type: ignore[misc]
        def took(self, *transitions: int) -> None:
            nonlocal inside
            inside += 1
            assert inside == 1
            inside -= 1

    machine: Machine[Any] = Machine(Watched())
    machine.start()
    each = 2_000
    threads = [threading.Thread(target=lambda: [machine.post("hop") for _ in range(each)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for _ in range(each):
        machine.send("hop")
    for thread in threads:
        thread.join()
    machine.step()
    assert machine.chart.bb.n == 5 * each // 2


def test_a_step_that_raises_leaves_the_machine_usable() -> None:
    text = """
system S
srm R {
  var n : int = 0
  liveness { R = A . B }
  control R { enter B : go  leave B : when [n > 0] / n = n + 1 }
}
"""

    class Watched(chart(text, watched=True)):  # type: ignore[misc]
        def start_B(self, label: str) -> None:
            raise OSError("no lamp")

    machine: Machine[Any] = Machine(Watched())
    machine.start()
    with pytest.raises(OSError, match="no lamp"):
        machine.send("go")
    machine.chart.bb.n = 1
    assert machine.step()
    assert machine.chart.finished


def test_what_is_queued_behind_a_step_that_raises_is_taken_in_its_order() -> None:
    order: list[str] = []

    class Told:
        """A chart whose first step is given more events; the second of them raises."""

        def send(self, event: str) -> bool:
            order.append(event)
            if event == "first":
                for other in ("a", "wrong", "b", "c"):
                    machine.post(other)
            if event == "wrong":
                machine.post("last")
                raise OSError(event)
            return True

    machine: Machine[Any] = Machine(Told())
    with pytest.raises(OSError, match="wrong"):
        machine.send("first")
    assert order == ["first", "a", "wrong"]
    machine.post("later")
    assert order[3:] == ["b", "c", "last", "later"]


def test_a_step_that_does_not_settle_is_an_error() -> None:
    text = "system S srm R { var b : bool = true liveness { R = A~ } control R { repeat A : when [b] } }"
    with pytest.raises(Unsettled, match=r"does not settle after 1000 rounds, at A: .*\(test\.aseme:1:70\)$"):
        chart(text)().start()


def test_regions_that_wake_each_other_for_ever_are_an_error_that_names_states_and_lines() -> None:
    machine = Machine(chart(ENDLESS)())
    machine.start()
    with pytest.raises(Unsettled) as raised:
        machine.send("go")
    said = str(raised.value)
    assert "1000 steps at one instant" in said and "at Ping, Pong" in said
    assert "test.aseme:8:" in said and "test.aseme:10:" in said
    assert "test.aseme:7:" not in said


def test_a_step_that_raises_is_not_overtaken_by_the_next() -> None:
    """What it has queued before comes first, and the next caller is told of his own step."""
    order: list[tuple[str, bool]] = []

    class Watched(chart(COUNTER, watched=True)):  # type: ignore[misc]
        def start_B(self, label: str) -> None:
            if self.bb.n == 1:
                machine.post("queued")
                machine.send("hop")
                raise OSError("no lamp")

    machine: Machine[Any] = Machine(Watched(), trace=lambda _, event, taken: order.append((event, taken)))
    for call in (machine.send, machine.post, lambda event: machine.step()):
        machine.chart.bb.n = 0
        machine.start()
        with pytest.raises(OSError, match="no lamp"):
            machine.send("hop")
        order.clear()
        found = call("hop")
        assert order[:2] == [("queued", False), ("hop", True)]
        assert found is order[2][1] or call is machine.post
        assert len(order) == 3
        assert machine.send("other") is False


def test_a_queued_step_that_raises_leaves_the_rest_in_its_order() -> None:
    order: list[str] = []

    class Told:
        def send(self, event: str) -> bool:
            order.append(event)
            if event == "first":
                for other in ("wrong", "a", "wrong", "b"):
                    machine.post(other)
            if event == "wrong":
                raise OSError(event)
            return True

    machine: Machine[Any] = Machine(Told())
    with pytest.raises(OSError, match="wrong"):
        machine.send("first")
    with pytest.raises(OSError, match="wrong"):
        machine.send("mine")
    assert order == ["first", "wrong", "a", "wrong"]
    assert machine.send("last")
    assert order[4:] == ["b", "mine", "last"]


def test_an_activity_may_fail_or_end_with_an_outcome() -> None:
    text = """
system S
srm R {
  liveness { R = work . Report  work = Grasp . (Carry | Open) }
  activities { Grasp ends held, slipped }
  control R { enter Report : error }
  control work {
    enter Carry : [outcome(Grasp) == held]
    enter Open  : [outcome(Grasp) == slipped]
  }
}
"""
    told: list[tuple[str, str, bool]] = []
    kind = chart(text)
    ends = []
    for way in ("held", "slipped", "failed"):
        machine = Machine(kind(), trace=lambda *step: told.append(step))
        machine.start()
        (label,) = machine.chart.configuration()
        assert machine.failed(label, "cold") if way == "failed" else machine.done(label, way)
        ends.append(machine.chart.configuration())
    assert len(set(ends)) == 3
    assert told[-1] == ("failed", label, True)
    with pytest.raises(ActivityFailed, match="warm"):
        machine.failed(*machine.chart.configuration(), "warm")
    with pytest.raises(KeyError):
        machine.done("7")


def test_what_is_written_before_a_step_is_not_seen_by_another() -> None:
    text = """
system S
srm R {
  var n : int = 0
  liveness { R = A . B }
  control R { enter B : when [n > 0] }
}
"""

    class Watched(chart(text, watched=True)):  # type: ignore[misc]
        def start_A(self, label: str) -> None:
            assert not machine.step(lambda chart: setattr(chart.bb, "n", 1))
            assert self.bb.n == 0

    machine: Machine[Any] = Machine(Watched())
    machine.start()
    assert machine.chart.configuration() == ("0.3",)


class Posting:
    """A chart that is given more events during a step with `many`."""

    def __init__(self, number: int) -> None:
        self.machine: Machine[Any] = Machine(self)  # type: ignore[type-var]
        self.number = number
        self.taken: list[str] = []

    def send(self, event: str) -> bool:
        self.taken.append(event)
        if event == "many":
            for number in range(self.number):
                self.machine.post(str(number))
        return True


def test_any_number_of_events_may_wait() -> None:
    posting = Posting(20_000)
    posting.machine.send("many")
    assert posting.taken == ["many", *map(str, range(20_000))]


def test_a_machine_outlives_what_a_signal_raises_at_any_moment() -> None:
    """As Ctrl-C does, or a timer: again and again, while it makes steps and takes what waits."""

    class Rung(Exception):
        pass

    def ring(*_: object) -> None:
        raise Rung

    kind = chart(COUNTER)
    before = signal.signal(signal.SIGALRM, ring)
    gc.disable()  # what is raised while others are told that memory is cleared, as by Hypothesis, nobody gets
    try:
        for trial in range(150):
            machine, posting = Machine(kind()), Posting(3)
            machine.start()
            with contextlib.suppress(Rung):
                signal.setitimer(signal.ITIMER_REAL, 0.000_5 + trial * 1e-6)
                for _ in range(20_000):
                    machine.send("hop")
                    machine.step()
                    machine.post("hop")
                    posting.machine.send("many")
                signal.setitimer(signal.ITIMER_REAL, 0)
            passed = machine.chart.bb.n
            assert machine.send("hop") and machine.send("hop") and machine.chart.bb.n == passed + 1
            assert posting.machine.send("last") and posting.taken[-1] == "last"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
        gc.enable()


def test_what_a_thread_sends_does_not_overtake_what_it_has_sent_before() -> None:
    """Another thread has made a step, during which that was queued, and is held up before it takes it."""
    order: list[str] = []
    inside, go, done, on = (threading.Event() for _ in range(4))

    class Held:
        def send(self, event: str) -> bool:
            order.append(event)
            if event == "a":
                inside.set()
                go.wait(60)
            return True

    machine: Machine[Any] = Machine(Held())  # type: ignore[type-var]

    def hold(frame: FrameType, what: str, argument: object) -> None:
        if frame.f_code.co_name == "drain":
            done.set()
            on.wait(60)

    def first() -> None:
        sys.settrace(hold)
        machine.send("a")

    thread = threading.Thread(target=first)
    thread.start()
    inside.wait(60)
    assert not machine.send("b")
    go.set()
    done.wait(60)
    assert machine.send("c")
    on.set()
    thread.join()
    assert order == ["a", "b", "c"]


def test_a_copy_is_a_machine_of_another_chart() -> None:
    machine = Machine(chart(COUNTER)(), strict=True)
    machine.start()
    assert repr(machine) == f"<Machine of {machine.chart!r}>"
    for other in (copy.copy(machine), copy.deepcopy(machine), pickle.loads(pickle.dumps(machine))):
        assert other.send("hop")
        assert (other.chart.configuration(), machine.chart.configuration()) == (("0.2.3",), ("0.2.2",))
        with pytest.raises(ValueError, match="no event 'hopp'"):
            other.send("hopp")


def test_a_machine_with_steps_that_wait_is_not_copied() -> None:
    class Fails(Posting):
        def send(self, event: str) -> bool:
            super().send(event)
            raise OSError(event)

    failing = Fails(2)
    with pytest.raises(OSError, match="many"):
        failing.machine.send("many")
    assert repr(failing.machine).endswith(", 2 steps wait>")
    with pytest.raises(RuntimeError, match="2 steps wait> cannot be copied"):
        pickle.dumps(failing.machine)
