"""What an activity can ask of the past, and one view of several channels; a long run stays small."""

from __future__ import annotations

import gc
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.runtime import Context, UndeclaredError
from aseme_dsl.runtime.chart import history
from aseme_dsl.runtime.chart.inputs import Sample
from tests.runtime.playing import MS, SECOND, make, play
from tests.support.generated import Generated, generate

TEXT = """
system S
message Pose { double x  optional int n }
message Seen { Pose pose  string name }
topic eyes { data Seen  state Pose }
srm R {
  liveness { R = Sense~ || (Wait . Look . Rest) }
  activities {
    Sense every 100ms takes 1ms writes eyes.data.Seen, eyes.state.Pose
    Wait takes 1s
    Look KIND reads eyes.data.Seen for 500ms, eyes.state.Pose
    Rest takes 50ms
  }
}
team T { ann : R }
"""


@pytest.fixture(scope="module", params=["thread", "process", "async", "step"])
def generated(request: pytest.FixtureRequest) -> Generated:
    return generate(TEXT.replace("KIND", "" if request.param == "thread" else f"as {request.param}"))


def looking(generated: Generated, look: Any) -> Any:
    """Have `look(context)` called after a second, at which ten measurements have been made, 0.0 to 0.9."""
    pose, seen = generated.messages.Pose, generated.messages.Seen
    kind = next(a.kind for a in generated.plan("R").activities if a.name == "Look")
    answers: list[Any] = []

    class Sense:
        def execute(self, context: Context) -> None:
            x = float(round(context.now_ns / (100 * MS)))
            context.publish("eyes.data.Seen", seen(pose=pose(x=x, n=int(x) if x > 7 else None), name="n"))
            context.publish("eyes.state.Pose", pose(x=x))

    if kind == "async":

        class Look:
            async def execute(self, context: Context) -> None:
                answers.append(look(context))

    elif kind == "step":

        class Look:  # type: ignore[no-redef]
            def execute(self, context: Context) -> Any:
                answers.append(look(context))
                yield 0.0

    else:

        class Look:  # type: ignore[no-redef]
            def execute(self, context: Context) -> None:
                answers.append(look(context))

    played = play(generated, {"Sense": Sense, "Look": Look}, until=SECOND + 100 * MS)
    assert played.of("error") == [] and played.of("activity", what="crash") == []
    return played, answers[0]


def test_the_past_of_a_channel(generated: Generated) -> None:
    def look(context: Context) -> Any:
        channel = "eyes.data.Seen"
        return {
            "age": context.age(channel),
            "none": context.age("eyes.data.Seen", sender="bob"),
            "at": context.at(channel, 0.25).pose.x,
            "now": context.at(channel, 0).pose.x,
            "window": [item.message.pose.x for item in context.history(channel, seconds=0.2)],
            "mean": context.mean(channel, "pose.x", 0.2),
            "some": context.mean(channel, "pose.n", 0.4),
            "between": context.interpolated(channel, "pose.x", 0.25),
            "after": context.interpolated(channel, "pose.x", 0.01),
            "whole": context.interpolated(channel, "pose.n", 0.15),
            "nothing": context.at(channel, 0.25, sender="bob"),
        }

    played, found = looking(generated, look)
    assert played.of("fault") == []
    moment = next(r["time"] for r in played.of("activity", activity="Look", what="start"))
    # It is measured when the activity that publishes it ends, 1 ms after each beat.
    last = max(r["time"] for r in played.of("message", channel="eyes.data.Seen") if r["time"] <= moment)
    x = round((last - MS) / (100 * MS))
    assert found["age"] == (moment - last) / SECOND
    assert found["now"] == x and found["at"] == x - 2 - (moment - last < 50 * MS)
    inside = [x - n for n in reversed(range(3)) if moment - last + n * 100 * MS <= 200 * MS]
    assert found["window"] == inside and found["mean"] == sum(inside) / len(inside)
    assert found["some"] == sum(n for n in range(8, x + 1)) / (x - 7)
    assert found["between"] == pytest.approx(x - (250 * MS - (moment - last)) / (100 * MS))
    assert found["after"] is None or moment - last < 10 * MS
    assert found["none"] is None and found["nothing"] is None
    assert found["whole"] == pytest.approx(x - (150 * MS - (moment - last)) / (100 * MS))


def test_to_look_back_further_than_is_declared_is_refused(generated: Generated) -> None:
    def look(context: Context) -> Any:
        context.history("eyes.data.Seen", seconds=0.5)
        assert len(context.history("eyes.data.Seen")) == 5
        with pytest.raises(UndeclaredError) as refused:
            context.mean("eyes.data.Seen", "pose.x", 2.5)
        with pytest.raises(UndeclaredError):
            context.at("eyes.data.Seen", 0.6)
        return str(refused.value)

    _, said = looking(generated, look)
    assert said == (
        "activity Look looks back 2.5 s at eyes.data.Seen, and it declares 0.5 s: "
        "add `activities { Look reads eyes.data.Seen for 2.5s }` to the .aseme file"
    )


def test_what_has_no_past_is_refused(generated: Generated) -> None:
    def look(context: Context) -> Any:
        with pytest.raises(LookupError, match=r"eyes\.state\.Pose is not a data channel"):
            context.at("eyes.state.Pose", 1)
        with pytest.raises(TypeError, match=r"name is not a number: 'n'"):
            context.interpolated("eyes.data.Seen", "name", 0.1)
        with pytest.raises(ValueError):
            context.mean("eyes.data.Seen", "pose.x", -1)

    looking(generated, look)


def test_a_snapshot_is_of_one_moment() -> None:
    """While an activity waits, its snapshot stays as it was, and what it publishes through it counts."""
    generated = generate(TEXT.replace("KIND", "writes eyes.state.Pose"))
    found: list[Any] = []

    def look(context: Context) -> None:
        view = context.snapshot()
        before = context.latest_message("eyes.state.Pose").x
        view.wait(0.35)
        found.append((before, view.latest_message("eyes.state.Pose").x, view.at("eyes.data.Seen", 0).pose.x))
        found.append(context.latest_message("eyes.state.Pose").x)
        found.append((context.now_ns - view.now_ns) / MS)
        view.publish("eyes.state.Pose", generated.message("Pose", x=-1.0))
        view.raise_if_cancelled()

    pose, seen = generated.messages.Pose, generated.messages.Seen

    class Sense:
        def execute(self, context: Context) -> None:
            x = float(round(context.now_ns / (100 * MS)))
            context.publish("eyes.data.Seen", seen(pose=pose(x=x)))
            context.publish("eyes.state.Pose", pose(x=x))

    class Look:
        def execute(self, context: Context) -> None:
            look(context)

    played = play(generated, {"Sense": Sense, "Look": Look}, until=2 * SECOND)
    (before, later, data), now, passed = found
    assert before == later == data and now >= before + 3 and passed == 350
    assert [r["message"]["x"] for r in played.of("message", activity="Look")] == [-1.0]


@given(
    times=st.lists(st.integers(0, 1000), min_size=1, max_size=8).map(sorted),
    values=st.lists(st.floats(-1e6, 1e6), min_size=8, max_size=8),
    moment=st.integers(-10, 1010),
)
def test_a_line_between_two_measurements(times: list[int], values: list[float], moment: int) -> None:
    class Point:
        def __init__(self, x: float) -> None:
            self.x = x

    items = [Sample("a.data.P", Point(x), "a", t, ("a", 1)) for t, x in zip(times, values, strict=False)]
    found = history.interpolated(items, moment, "x")
    if not times[0] <= moment <= times[-1]:
        assert found is None
        return
    before = max(n for n, t in enumerate(times) if t <= moment)
    near = values[: len(times)]
    around = [near[n] for n, t in enumerate(times) if t == times[before]] + near[before + 1 : before + 2]
    assert found is not None and min(around) - 1e-6 <= found <= max(around) + 1e-6


def test_a_long_run_stays_small() -> None:
    """Objects after one simulated minute are as many as after half of it."""
    text = """
    system S
    message Count { int n }
    topic eyes { data Count  state Count  signal Count queued }
    topic slow { state Count every 70ms  data Count every 70ms }
    srm R {
      var x : int = 0
      liveness { R = (Sense . Turn)~ || (Rest . Nap)~ }
      activities {
        Sense every 50ms takes 10ms reads eyes.data.Count for 1s
          writes eyes.data.Count, eyes.state.Count, eyes.signal.Count, slow.state.Count, slow.data.Count, x
        Turn takes 5ms
        Rest takes 30ms  Nap takes 10ms
      }
      control R {
        enter Nap : [mean(eyes.data.Count.n, 2s) >= 0 && age(eyes.data.Count) < 1s]
        repeat (Rest . Nap) : [eyes.signal.Count.n >= 0]
      }
    }
    team T { ann, bob : R }
    """
    generated = generate(text)
    count = generated.messages.Count
    counted: list[int] = []

    class Sense:
        def execute(self, context: Context) -> None:
            for place in ("eyes.data", "eyes.state", "eyes.signal", "slow.state", "slow.data"):
                context.publish(f"{place}.Count", count(n=context.random.randrange(1000)))
            context.history("eyes.data.Count", seconds=1)
            context.set_variable("x", 1)

    def watch(team: Any) -> str | None:
        halves = team.driver.clock.now() // (6 * SECOND)
        if halves > len(counted):
            records.clear()
            gc.collect()
            counted.append(len(gc.get_objects()))
        return None

    team, records = make(generated, {"Sense": Sense}, stop=watch, until=60 * SECOND)
    gc.freeze()  # what was there before is not counted
    team.run()
    warm = counted[len(counted) // 2]
    assert len(counted) >= 9 and counted[-1] <= warm * 1.01, counted
