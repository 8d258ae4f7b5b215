"""Messages and scripted inputs as JSON."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.runtime import InputFileError, TeamError, read_inputs
from aseme_dsl.runtime.message.as_json import from_json, to_json
from aseme_dsl.runtime.team.timed_inputs import duration
from tests.runtime.playing import MS, SECOND, play
from tests.support.generated import generate

GENERATED = generate("""
system S
enum Mood { GOOD BAD }
message Inner { int n  string s }
message M {
  bool b  int i  double d  string s  bytes raw  Mood mood  Inner inner  duration wait
  repeated int numbers  repeated Inner inners  optional double maybe
}
topic t { state M, Inner }
srm R { liveness { R = A } control R { leave A : when [has(t.state.M) || t.state.Inner.n == 2 ] } }
""")
M = GENERATED.messages.M
INNER = GENERATED.messages.Inner
MESSAGES = {"M": M, "Inner": INNER}

inners = st.builds(INNER, n=st.integers(-(2**31), 2**31 - 1), s=st.text())
messages = st.builds(
    M,
    b=st.booleans(),
    i=st.integers(-(2**31), 2**31 - 1),
    d=st.floats(allow_nan=False),
    s=st.text(),
    raw=st.binary(),
    mood=st.sampled_from(GENERATED.messages.Mood),
    inner=inners,
    wait=st.integers(0, 2**60),
    numbers=st.lists(st.integers(), max_size=3).map(tuple),
    inners=st.lists(inners, max_size=2).map(tuple),
    maybe=st.none() | st.floats(allow_nan=False),
)


@given(messages)
def test_a_message_comes_back_as_it_was(message: Any) -> None:
    text = json.dumps(to_json(message), allow_nan=False)
    assert from_json(M, json.loads(text)) == message


def test_what_is_no_number_has_a_name() -> None:
    assert to_json(M(d=math.nan))["d"] == "NaN"
    assert math.isnan(from_json(M, {"d": "NaN"}).d)
    assert from_json(M, {"d": "-Infinity"}).d == -math.inf
    assert from_json(M, {"d": 3}).d == 3.0 and isinstance(from_json(M, {"d": 3}).d, float)


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        ({"x": 1}, "M has no member x; it has b, i, d,"),
        ({"i": True}, "i: a int is wanted, not True"),
        ({"i": 1.5}, "i: a int is wanted, not 1.5"),
        ({"b": 0}, "b: a bool is wanted, not 0"),
        ({"mood": "SO_SO"}, "mood: one of GOOD, BAD is wanted, not 'SO_SO'"),
        ({"mood": 7}, "mood: one of GOOD, BAD is wanted, not 7"),
        ({"inner": {"n": "x"}}, "inner.n: a int is wanted, not 'x'"),
        ({"inners": [{"n": 1}, 5]}, "inners[1]: a Inner is wanted, not 5"),
        ({"numbers": 5}, "numbers: a list is wanted, not 5"),
        ({"raw": "ü"}, "raw: bytes in base64 is wanted, not 'ü'"),
        ([], "a M is wanted, not []"),
    ],
)
def test_what_does_not_fit_is_named(data: Any, reason: str) -> None:
    with pytest.raises(ValueError) as raised:
        from_json(M, data)
    assert str(raised.value).startswith(reason)


def test_an_enum_is_read_by_name_or_number() -> None:
    mood = GENERATED.messages.Mood
    for data in ("BAD", "Mood.BAD", 1):
        assert from_json(M, {"mood": data}).mood is mood.BAD


@pytest.mark.parametrize(
    ("text", "ns"),
    [("200ms", 200 * MS), ("1.5s", 1500 * MS), ("2min", 120 * SECOND), ("7us", 7000), ("0s", 0)],
)
def test_durations(text: str, ns: int) -> None:
    assert duration(text) == ns


def test_every_wrong_line_of_a_script_is_named() -> None:
    lines = [
        "",
        '{"at": "1s", "channel": "t.state.M"}',
        "{",
        "[]",
        '{"at": "soon", "event": "Bell"}',
        '{"at": -1, "event": "Bell"}',
        '{"event": "Bell", "channel": "t.state.M"}',
        '{"channel": "t.state.N"}',
        '{"channel": "t.state.M", "message": {"i": "x"}}',
        '{"agent": 7, "event": "Bell"}',
        '{"when": 1, "event": "Bell"}',
        '{"at": 1}',
        '{"at": 1, "event": "Bell"}',
    ]
    with pytest.raises(InputFileError) as raised:
        read_inputs(lines, MESSAGES)
    told = str(raised.value).splitlines()
    assert [line.split(":")[0] for line in told] == [f"line {n}" for n in range(3, 14)]
    assert told[-1].endswith('`at` without a unit is in ns: write "1s", "1ms" or "1ns"')
    assert "'soon' is not a duration" in told[2]
    assert "i: a int is wanted" in told[6]


def test_a_script_plays_messages_and_events_in_time() -> None:
    script = [
        {"at": "20ms", "channel": "t.state.Inner", "message": {"n": 2}, "sender": "ring"},
        {"at": "10ms", "channel": "t.state.Inner", "message": {"n": 1}},
    ]
    run = play(GENERATED, script=script)
    assert run.received("me", "t.state.Inner") == ["10 from input n=1 s=", "20 from ring n=2 s="]
    assert run.result.end_ns == 20 * MS

    bell = "system S srm R { liveness { R = A } control R { leave A : bell } activities { A takes 1s } }"
    run = play(bell, script=[{"at": 30 * MS, "agent": "me", "event": "bell"}])
    assert (run.result.reason, run.result.end_ns) == ("finished", 30 * MS)


def test_a_script_for_nobody_is_an_error() -> None:
    with pytest.raises(TeamError, match=r"for an agent you; there are me"):
        play(GENERATED, script=[{"agent": "you", "channel": "t.state.M"}])
    silent = generate("system S message M { int n } topic t { state M } srm R { liveness { R = A } }")
    with pytest.raises(TeamError, match=r"no agent of the team reads t.state.M"):
        play(silent, script=[{"channel": "t.state.M"}])


def test_a_number_that_is_too_large_is_said_to_be() -> None:
    with pytest.raises(ValueError, match="a number is wanted, not 'one that is too large'"):
        from_json(float, 10**400)
