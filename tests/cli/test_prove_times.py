"""`asemec prove` on how long things take: deadlines, timers, ages, and messages on their way."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.cli.support import Done
from tests.cli.test_prove import verdicts

WAIT = """\
system Wait
srm one {
  liveness { one = Wait . Go . Rest }
  activities { Wait waits  Rest waits }
  control one { enter Go : after(1s) }
}
team T { a : one }
"""

SEND = """\
system Send
message Ping { int n }
topic t { KIND Ping }
srm sender {
  liveness { sender = Start . Pause . Rest }
  activities { Start waits  Pause waits  Rest waits }
  control sender {
    enter Pause : after(50ms) / t.KIND.Ping.n = 1; write_messages.t.KIND.Ping
    enter Rest  : after(500ms)
  }
}
srm reader {
  liveness { reader = Idle . Alert . Calm }
  activities { Idle waits  Alert waits  Calm waits }
  control reader {
    enter Alert : when [AT_FIRST]
    enter Calm  : when [AT_LAST]
  }
}
team T { s : sender  r : reader }
"""
SIGNAL = (
    SEND.replace("KIND", "signal").replace("AT_FIRST", "t.signal.Ping.n == 1").replace("AT_LAST", "false")
)
STATE = (
    SEND.replace("KIND", "state")
    .replace("AT_FIRST", "age(t.state.Ping) < 300ms")
    .replace("AT_LAST", "age(t.state.Ping) >= 300ms")
)

TIMER = """\
system Timer
srm one {
  liveness { one = (Work . Look . Reset)~ }
  activities { Look waits  Work within 3s }
  control one {
    enter Work  : / start_timer(rest, 2s)
    enter Look  : error
    enter Look  :
    enter Reset : when [expired(rest)]
  }
}
team T { a : one }
property "it looks" { assume Work takes 0ms..1s  every a in Work leads to a in Reset within 2s }
property "it rests" { assume Work takes 0ms..1s  no a in Reset within 999ms after a in Look }
"""


@pytest.fixture
def prove(prove: Callable[..., Done]) -> Callable[..., Done]:
    """The same, as JSON."""
    return lambda text, *arguments: prove(text, *arguments, "--json")


def verdict(prove, text: str, body: str) -> str:  # type: ignore[no-untyped-def]
    done = prove(f'{text}property "it" {{ {body} }}\n', "it")
    assert "Traceback" not in done.out
    return verdicts(done)["it"]


@pytest.mark.parametrize(
    ("body", "is_proved"),
    [
        ("every a in Wait leads to a in Go within 1s", True),
        ("every a in Wait leads to a in Go within 999ms", False),
        ("no a in Go before 1s", True),
        ("no a in Go before 1001ms", False),
        ("eventually a in Go within 1s", True),
        ("eventually a in Go within 999ms", False),
        ("no a in Go within 999ms after a in Wait", True),
        ("no a in Go within 1s after a in Wait", False),
    ],
)
def test_a_deadline_is_kept_to_the_nanosecond(prove, body: str, is_proved: bool) -> None:  # type: ignore[no-untyped-def]
    assert verdict(prove, WAIT, body) == ("PROVED" if is_proved else "REFUTED")


@pytest.mark.parametrize(
    ("text", "body", "is_proved"),
    [
        (SIGNAL, "every s in Pause leads to r in Alert within 200ms", True),
        (SIGNAL, "every s in Pause leads to r in Alert within 199ms", False),
        (SIGNAL, "r in Alert before s in Rest", True),
        (SIGNAL.replace("500ms", "150ms"), "r in Alert before s in Rest", False),
        (STATE, "every r in Alert leads to r in Calm within 300ms", True),
        (STATE, "every r in Alert leads to r in Calm within 299ms", False),
        (STATE, "eventually r in Calm within 350ms", True),
        (STATE, "eventually r in Calm within 349ms", False),
    ],
)
def test_messages_take_as_long_as_is_assumed(prove, text: str, body: str, is_proved: bool) -> None:  # type: ignore[no-untyped-def]
    expected = "PROVED" if is_proved else "REFUTED"
    assert verdict(prove, text, f"assume network delay 0ms..200ms {body}") == expected
    if "Calm within 30" not in body:  # they take any time
        assert verdict(prove, text, body) == "REFUTED"


def test_a_timer_runs_from_its_start(prove) -> None:  # type: ignore[no-untyped-def]
    assert set(verdicts(prove(TIMER, "it looks", "it rests")).values()) == {"PROVED"}
    dropped = TIMER.replace("enter Work  : / start_timer(rest, 2s)", "")
    assert verdicts(prove(dropped, "it looks"))["it looks"] == "REFUTED"
    late = TIMER.replace("start_timer(rest, 2s)", "start_timer(rest, 2001ms)")
    assert verdicts(prove(late, "it looks"))["it looks"] == "REFUTED"


def test_the_line_names_the_times_that_it_is_about(prove) -> None:  # type: ignore[no-untyped-def]
    body = "assume network delay 0ms..200ms every s in Pause leads to r in Alert within 200ms"
    (item,) = prove(f'{SIGNAL}property "it" {{ {body} }}\n', "it").json["results"]
    assert "delay 0 s to 0.2 s" in item["bounds"]
    assert "all times" in item["bounds"]


def test_deadlines_pass_in_the_order_in_which_they_are_due(prove) -> None:  # type: ignore[no-untyped-def]
    both = """\
system Both
srm one {
  liveness { one = (A . B) || (C . D) }
  activities { A waits  B waits  C waits  D waits }
  control one { enter B : after(1s)  enter D : after(2s) }
}
team T { a : one }
"""
    assert verdict(prove, both, "a in B before a in D") == "PROVED"
    assert verdict(prove, both, "a in D before a in B") == "REFUTED"


# ---- what was proved and is not so ------------------------------------------------------------------


def test_a_message_may_be_old_when_it_comes(prove) -> None:  # type: ignore[no-untyped-def]
    assert verdict(prove, STATE, "every s in Pause leads to r in Alert") == "REFUTED"


def test_a_state_is_seen_also_if_another_run_has_just_led_there(prove) -> None:  # type: ignore[no-untyped-def]
    both = """\
system Both
srm one { liveness { one = (A . B)~ } activities { A waits B waits }
          control one { enter B : after(300ms)  leave B : after(200ms) } }
srm two { liveness { two = (C . D)~ } activities { C waits D waits }
          control two { enter D : after(300ms)  leave D : after(200ms) } }
team T { s : one  r : two }
"""
    assert verdict(prove, both, "never (s in B and r in D)") != "PROVED"


def test_data_becomes_old(prove) -> None:  # type: ignore[no-untyped-def]
    text = STATE.replace("state", "data")
    assert verdict(prove, text, "never r in Calm") == "REFUTED"


def test_who_may_publish_seldom_may_publish_again_later(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Seldom
message Ping { int n }
topic t { data Ping every 100ms }
srm sender {
  liveness { sender = First . Second . Rest }
  activities { First waits  Second waits  Rest waits }
  control sender {
    enter Second : after(1s) / t.data.Ping.n = 1; write_messages.t.data.Ping
    enter Rest   : after(1s) / t.data.Ping.n = 2; write_messages.t.data.Ping
  }
}
srm reader {
  liveness { reader = Idle . Ready . Alert }
  activities { Idle waits  Ready waits  Alert waits }
  control reader { enter Ready : when [t.data.Ping.n == 1]  enter Alert : when [t.data.Ping.n == 2] }
}
team T { s : sender  r : reader }
"""
    assert verdict(prove, text, "never r in Alert") == "REFUTED"


PACED = """\
system Paced
srm robot {
  liveness { robot = Look~ || (Wait . Act)~ }
  activities { Look every 100ms  Wait waits }
  control robot { enter Act : after(1s) }
}
team T { a : robot }
"""


def test_a_pause_between_two_runs_is_measured(prove) -> None:  # type: ignore[no-untyped-def]
    taking = "assume Look takes 0ms..30ms "
    again = "no a in Act before 1s"
    assert verdict(prove, PACED, f"{taking} {again}") == "PROVED"
    text = PACED.replace("Look~", "(Look . Send)~").replace("Wait waits", "Wait waits  Send waits")
    text = text.replace("enter Act : after(1s)", "enter Act : after(1s)  leave Send : after(10ms)")
    soon = "every a in Send leads to a in Look within 10ms"
    assert verdict(prove, text, f"assume Look takes 0ms..30ms {soon}") == "PROVED"
    twice = "no a in Send within 69ms after a in Send"
    assert verdict(prove, text, f"assume Look takes 0ms..30ms {twice}") == "PROVED"
    assert verdict(prove, text, f"assume Look takes 0ms..30ms {twice.replace('69', '75')}") == "REFUTED"
    assert verdict(prove, text, "assume Look takes 0ms..31ms " + twice.replace("69", "68")) == "PROVED"
    least = "every a in Send leads to a in Send within 130ms"
    assert verdict(prove, text, f"assume Look takes 0ms..30ms {least}") != "UNDECIDED"
    unpaced = text.replace("Look every 100ms  ", "")
    assert verdict(prove, unpaced, f"assume Look takes 0ms..30ms {twice}") == "REFUTED"


def test_what_is_assumed_of_activities_orders_their_ends(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Order
srm one { liveness { one = A . B } }
srm two { liveness { two = C . D } }
team T { a : one  b : two }
"""
    taking = "assume A takes 0s..2s assume C takes 3s..4s "
    assert verdict(prove, text, f"{taking} a in B before b in D") == "PROVED"
    assert verdict(prove, text, f"{taking} b in D before a in B") == "REFUTED"
    assert verdict(prove, text, "a in B before b in D") == "REFUTED"


def test_an_activity_that_is_quick_enough_does_not_fail(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Quick
srm one { liveness { one = A . B }  activities { A within 2s } }
team T { a : one }
property "it" { assume A takes 0s..MOST  A before B }
"""
    assert verdicts(prove(text.replace("MOST", "1999ms"), "failures"))["failures"] == "PROVED"
    done = prove(text.replace("MOST", "2s"), "failures")
    assert verdicts(done)["failures"] == "REFUTED", done.out


@pytest.mark.parametrize("is_sure", ["", "!"])
def test_a_region_that_is_entered_again_when_a_timer_expires_can_also_go_on(prove, is_sure: str) -> None:  # type: ignore[no-untyped-def]
    text = f"""\
system Anew
function sure(int n) : bool = "tests.oracle.functions:even"
srm robot {{
  var n : int = 1
  liveness {{
    robot = (part || idle)~
    part  = Look . [Kick]
    idle  = [Rest]
  }}
  control idle {{
    enter Rest : [false]
    skip Rest : else
  }}
  control part {{
    enter [Kick] : / start_timer(due, 1s)
    skip Kick : [expired(due) && {is_sure}sure(n)]
    enter Kick : [expired(due) && !({is_sure}sure(n))]
  }}
}}
team T {{ it : robot }}
"""
    assert verdict(prove, text, "never it in Kick") == "REFUTED"


FERRY = """\
system Ferry
message Wind { double speed }
topic sky { state Wind }
srm ferry {
  liveness { ferry = watch~  watch = Listen . (Reef | Steer) }
  activities { Listen writes sky.state.Wind }
  control watch {
    enter Reef  : [AGES && sky.state.Wind.speed > 20]
    enter Steer : else
  }
}
team Harbour { one : ferry }
"""


@pytest.mark.parametrize(
    "ages",
    [
        "age(sky.state.Wind) > 1s",
        "age(sky.state.Wind) > 1s && age(sky.state.Wind) < 5s",
        "age(sky.state.Wind) >= 5s && age(sky.state.Wind) < 6s",
    ],
)
def test_a_message_that_may_be_renewed_at_any_moment_comes_early_enough(
    prove, here, folder, ages: str
) -> None:  # type: ignore[no-untyped-def]
    text = FERRY.replace("AGES", ages) + 'property "it" { never some ferry in Reef }\n'
    done = prove(text, "it", "--save", "found.aseme")
    assert verdicts(done) == {"it": "REFUTED"}, done.out
    assert here("test", "found.aseme").code == 1


def test_a_message_that_may_be_renewed_is_as_old_as_since_then(prove) -> None:  # type: ignore[no-untyped-def]
    """What became old after 1 s was not yet so old as since it came first."""
    text = """\
system Renew
message Wind { double speed }
topic sky { state Wind }
srm ferry {
  liveness {
    ferry = Begin . [watch]
    watch = Listen . Wait . (look | Other)
    look  = Check . (Bad | Good)
  }
  activities { Begin writes sky.state.Wind  Listen writes sky.state.Wind }
  control ferry {
    enter watch : [sky.state.Wind.speed > 3]
    skip watch  : else
  }
  control watch {
    enter Wait  : after(800ms)
    enter look  : after(1s) [age(sky.state.Wind) > 1s]
    enter Other : after(1s)
  }
  control look {
    enter Bad  : after(1500ms) [age(sky.state.Wind) < LIMIT]
    enter Good : after(1500ms)
  }
}
team Harbour { one : ferry }
"""
    body = (
        "assume Listen takes 10s..10s assume Wait takes 10ms..10ms assume Check takes 10ms..10ms "
        "no one in Bad within 60min after one in Listen"
    )
    assert verdict(prove, text.replace("LIMIT", "3s"), body) == "REFUTED"
    assert verdict(prove, text.replace("LIMIT", "2500ms"), body) == "PROVED"


def test_two_deadlines_may_pass_at_one_moment(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Office
message Bell { bool loud }
topic harbour { signal Bell }
srm ferry {
  liveness { ferry = Sail . Ring }
  activities { Sail within 60s }
  control ferry { enter Ring : / harbour.signal.Bell.loud = true; write_messages.harbour.signal.Bell }
}
srm office {
  liveness { office = Doze . Open }
  control office { enter Open : when [harbour.signal.Bell.loud] }
}
team Harbour { one, two : ferry  port : office }
"""
    done = prove(text, "deadlock")
    assert verdicts(done)["deadlock"] == "REFUTED", done.out


CROSS = """\
system Cross
message Ping { int n }
message Pong { int n }
topic t { signal Ping  signal Pong }
srm one {
  liveness { one = A . B }
  control one { enter B : / t.signal.Ping.n = 1; write_messages.t.signal.Ping }
}
srm two {
  liveness { two = C . D }
  activities { C waits }
  control two { enter D : when [t.signal.Ping.n == 1] / t.signal.Pong.n = 1; write_messages.t.signal.Pong }
}
srm three {
  liveness { three = Idle . (First | Second) }
  control three {
    enter Second : when [t.signal.Ping.n == 1]
    enter First  : when [t.signal.Pong.n == 1]
  }
}
team T { a : one  b : two  c : three }
"""


@pytest.mark.parametrize(("delay", "is_proved"), [("1s..1s", True), ("1s..2s", False)])
def test_a_run_keeps_what_is_assumed_where_no_deadline_passes(prove, delay: str, is_proved: bool) -> None:  # type: ignore[no-untyped-def]
    """What goes over two agents takes two delays."""
    found = verdict(prove, CROSS, f"assume network delay {delay} never c in First")
    assert found == ("PROVED" if is_proved else "REFUTED")


@pytest.mark.parametrize(("most", "is_proved"), [("500ms", True), ("1500ms", False)])
def test_a_wait_for_ever_keeps_what_is_assumed(prove, most: str, is_proved: bool) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Ring
message Bell { bool loud }
topic t { signal Bell }
srm one {
  liveness { one = Sleep . [Ring] }
  control one {
    enter [Ring] :
    enter [Ring] : after(1s)
    enter Ring   : [outcome(Sleep) == good] / t.signal.Bell.loud = true; write_messages.t.signal.Bell
    skip Ring    : else
  }
  activities { Sleep ends good }
}
srm two {
  liveness { two = Doze . Open }
  control two { enter Open : when [t.signal.Bell.loud] }
}
team T { a : one  b : two }
"""
    done = prove(f'{text}property "it" {{ assume Sleep takes 0ms..{most}  never fault }}\n', "deadlock")
    assert verdicts(done)["deadlock"] == ("UNDECIDED" if is_proved else "REFUTED"), done.out
