"""The story of a failed scenario: `.aseme` text in, what `asemec test` prints out."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.support import Here

GUARD = """\
system Guard
enum Mood { CALM ANGRY }
message Ball { double distance }
message Pressed { bool on }
message Seen { int number }
topic eyes { state Ball }
topic team { signal Pressed  state Seen }
srm guard {
  let is_near = eyes.state.Ball.distance < limit
  var limit : int = 100
  liveness { guard = Wait . (Chase | Rest)~ || Look }
  activities {
    Wait takes 1s simulated
    Chase takes 1s simulated
    Rest takes 1s simulated writes team.state.Seen
    Look takes 60s simulated
  }
  control guard {
    enter Chase : [is_near && limit > 50] / limit = 60
    enter Rest : else
  }
}
srm bell {
  liveness { bell = Idle . Ring }
  activities { Idle takes 1s simulated  Ring takes 1s simulated }
  control bell { enter Ring : [has(team.signal.Pressed)] }
}
team Guards { bob : guard  bell1, bell2, bell3, bell4 : bell }
"""

CASES = {
    # The definition of a `let`, the values of a condition, and the line that was passed over.
    "default": (
        "at 500ms bob receives eyes.state.Ball { distance = 200 }  at 1500ms bob in Chase",
        (
            "`bob in Chase` is not so at 1.5 s: bob is in Rest",
            "1 s  bob  Wait returns; Wait -> Rest : else (guard.aseme:20)",
            "not to Chase, as not [is_near && limit > 50] (guard.aseme:19),"
            " with eyes.state.Ball.distance = 200.0, limit = 100;"
            " where is_near is eyes.state.Ball.distance < limit (guard.aseme:9)",
            "bob  is in Rest (guard.aseme:11) since 1 s: its activity has not returned",
            "bob  is also in Look",
            "ask next: asemec whynot bob Chase --at 1s TRACE (`asemec test --traces DIR` writes it)",
        ),
    ),
    # A variable as the condition has read it, not as the action has set it.
    "set": (
        "at 500ms bob receives eyes.state.Ball { distance = 9 }  never bob in Chase  for 2s",
        (
            "`bob in Chase` came at 1 s: bob is in Chase",
            "1 s  bob  Wait returns; Wait -> Chase : [is_near && limit > 50] / limit = 60 (guard.aseme:19)",
            "with eyes.state.Ball.distance = 9.0, limit = 100",
            "ask next: asemec why bob Chase --at 1s TRACE (`asemec test --traces DIR` writes it)",
        ),
    ),
    # A condition with brackets is said as it is written.
    "brackets": (
        "never bob in (Chase or Rest)  for 2s",
        ("`bob in (Chase or Rest)` came at 1 s: bob is in Rest",),
    ),
    # Agents that do the same, and a signal that has not come.
    "alike": (
        "never two of bell in Ring  eventually some bell in Ring within 2s",
        (
            "`some bell in Ring` has not come by 2 s: bell[1..4] are in Idle",
            "0 s  bell[1..4]  each: enters Idle (guard.aseme:24)",
            "bell[1..4]  each: is in Idle (guard.aseme:24), whose activity returned at 1 s:"
            " it waits for [has(team.signal.Pressed)] (guard.aseme:26)",
            "with no team.signal.Pressed so far",
            "team.signal.Pressed has not come: no role of these agents sends it",
        ),
    ),
    # How far an order has come, and when.
    "order": (
        "in order bob in Wait, bob in Rest, bob in Chase  for 3s",
        (
            "`bob in Chase` (part 3 of 3) has not come by 3 s; the part before, `bob in Rest`, came at 1 s",
            "2 s  bob  Rest returns; Rest -> Rest : again (guard.aseme:11), else (guard.aseme:20)",
        ),
    ),
    "leads to": (
        "every bob in Rest leads to bob in Chase within 1500ms  for 5s",
        ("`bob in Rest` came at 1 s, but `bob in Chase` has not come by 2.5 s: bob is in Rest",),
    ),
    "before": (
        "bob in Chase before bob in Rest  for 3s",
        ("`bob in Rest` came at 1 s, but `bob in Chase` had not come: bob is in Rest",),
    ),
    "after": (
        "after 200ms bob in Rest : bob in Wait  for 3s",
        ("`bob in Wait` is not so at 1.2 s, 0.2 s after `bob in Rest`: bob is in Rest",),
    ),
    "row": (
        "table (d, then) { (200, Chase) }"
        "  at 0ms bob receives eyes.state.Ball { distance = d }  at 2s bob in then",
        ("`bob in Chase` is not so at 2 s: bob is in Rest", "with the row d = 200, then = Chase"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_story_says_what_was_awaited_what_was_read_and_where(name: str, here: Here, folder: Path) -> None:
    body, told = CASES[name]
    (folder / "guard.aseme").write_text(f'{GUARD}scenario "s" {{\n  {body}\n}}\n')
    done = here("test", "guard.aseme", "-j", "1")
    lines = [line.strip() for line in done.out.splitlines()]
    for text in told:
        assert any(line.endswith(text) for line in lines), f"{text}\n{done.out}"


def test_what_no_agent_reads_and_single_nanoseconds_are_not_in_a_story(here: Here, folder: Path) -> None:
    acts = "activity Rest writes team.state.Seen { number = 1 }"
    (folder / "guard.aseme").write_text(
        f'{GUARD}scenario "s" {{\n  {acts}\n  within 500ms of bob in Rest  sent Seen\n  for 3s\n}}\n'
        f'scenario "t" {{\n  {acts}\n  at 3s bob in Chase\n}}\n'
    )
    first, second = here("test", "guard.aseme", "-j", "1").out.split("\nfailed ")
    assert "00000" not in first
    assert "team.state.Seen" not in second


def test_the_trace_of_a_failure_is_there_to_be_asked(here: Here, folder: Path) -> None:
    (folder / "guard.aseme").write_text(f'{GUARD}scenario "it hunts" {{\n  at 3s bob in Chase\n}}\n')
    done = here("test", "guard.aseme", "-j", "1", "--traces", "found")
    asked = "asemec whynot bob Chase --at 3s found/it-hunts.jsonl.gz"
    assert f"  ask next: {asked}" in done.out.splitlines(), done.out
    answer = here(*asked.split()[1:])
    assert answer.code == 0 and "is absent: the message is not there" in answer.out, answer.out


CIRCLE = """\
system Circle
message M { bool on }
topic t { state M }
srm r {
  liveness { r = Wait . (Left . Right)~ }
  activities { Wait takes 1s simulated  Left takes 1s simulated  Right takes 1s simulated }
  control r {
    enter Right : when [t.state.M.on]
    repeat (Left . Right) : when [t.state.M.on]
  }
}
team T { bob : r }
scenario "it stays" { at 500ms bob receives t.state.M { on = true }  at 3s bob in Right }
"""


def test_a_step_without_an_end_names_the_circle(here: Here, folder: Path) -> None:
    (folder / "circle.aseme").write_text(CIRCLE)
    done = here("test", "circle.aseme", "-j", "1")
    circle = (
        "start of (Left . Right) -> Left (circle.aseme:5:26), Left -> Right (circle.aseme:8:5),"
        " (Left . Right) -> (Left . Right) (circle.aseme:9:5), and again"
    )
    assert f"the step does not settle after 2000 rounds: {circle}\n" in done.out, done.out


def test_what_runs_are_watched_with_loads_nothing_that_is_asked_later() -> None:
    """The process of a robot starts with it."""
    code = "import sys, aseme_dsl.project.testing.watching; print([n for n in sys.modules if '.asking' in n])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


SHOP = """\
system Shop
message Need { string item  int count  string note }
message Offer { int price }
aip buying {
  participant buyer { process = Ask . Await . Pay }
  participant seller { process = Hear . Offer }
  control buyer {
    enter Ask   : / send request Need { item = "nails", count = 3, note = "steel" } to seller
    enter Await : after(1s)
    enter Pay   : inform Offer from seller [inform.Offer.price < 5]
  }
  control seller {
    enter Hear  : request Need from buyer
    enter Offer : / send inform Offer { price = 9 } to buyer
  }
}
srm customer { plays buying.buyer  liveness { customer = buyer }  activities { Await takes 2s within 20s } }
srm shop { plays buying.seller  liveness { shop = seller } }
team Shop { ann : customer  bob : shop }
"""


@pytest.mark.parametrize(
    ("body", "told"),
    [
        (
            'eventually sent request Need n [n.item == "glue" && n.count > 2] within 4s',
            (
                '4 s: ann sent request Need at 0 s, but not [n.item == "glue"]: n.item = "nails"',
                "asemec why ann 'request Need' --at 0s TRACE (`asemec test --traces DIR` writes it)",
            ),
        ),
        (
            "by 4s ann in Pay",
            (
                "the last inform Offer was sent by bob at 0.1 s,"
                " but not [inform.Offer.price < 5]: inform.Offer.price = 9",
            ),
        ),
    ],
)
def test_a_message_that_only_a_filter_has_refused(
    body: str, told: tuple[str, ...], here: Here, folder: Path
) -> None:
    (folder / "shop.aseme").write_text(f'{SHOP}scenario "s" {{\n  {body}\n}}\n')
    done = here("test", "shop.aseme", "-j", "1")
    assert all(any(line.endswith(text) for line in done.out.splitlines()) for text in told), done.out


DOCK = """\
system Dock
message Load { double weight }
aip lifting {
  participant client { process = Drive . (AwaitLift | Leave) }
  participant worker {
    var weight : double = 0
    process = Weigh . (Lift | Decline)
  }
  control client {
    enter (AwaitLift | Leave) : / send request Load { weight = 30 } to worker
    enter AwaitLift : agree Load from worker
    enter Leave     : refuse Load from worker or lost worker or after(20s)
  }
  control worker {
    enter Weigh   : request Load l from client / weight = l.weight
    enter Lift    : [weight < 10] / send agree Load to client
    enter Decline : else / send refuse Load to client
  }
}
srm truck {
  plays lifting.client
  liveness { truck = client }
  activities { Drive takes 2s simulated  AwaitLift takes 1s simulated  Leave takes 1s simulated }
}
srm crane {
  plays lifting.worker when busy refuse
  liveness { crane = worker~ }
  activities { Weigh takes 1s simulated  Lift takes 5s simulated  Decline takes 100ms simulated }
}
team Dock { t[1..2] : truck  c : crane }
"""


@pytest.mark.parametrize(
    ("body", "told"),
    [
        # What was said instead, and the decision to ask about.
        (
            "t1 : truck  c : crane  by 10s sent agree Load by c",
            (
                "`sent agree Load by c` has not come by 10 s: c sent refuse Load at 3 s",
                "ask next: asemec whynot c 'agree Load' --at 3s TRACE (`asemec test --traces DIR` writes it)",
            ),
        ),
        # What an agent says without a decision of its own, and which of three events it was.
        (
            "t1, t2 : truck  c : crane  by 9s t2 in AwaitLift",
            (
                "2 s  t2  receives refuse Load { weight = 30.0 } from c, automatically: `when busy`",
                "by refuse Load from c",
                "ask next: asemec whynot t2 AwaitLift --at 2s TRACE (`asemec test --traces DIR` writes it)",
            ),
        ),
        (
            "t1, t2 : truck  c : crane  by 9s received agree Load by t2",
            (
                "`received agree Load by t2` has not come by 9 s: c sent refuse Load to t2 at 2 s",
                "ask next: asemec whynot c 'agree Load' --at 3s TRACE (`asemec test --traces DIR` writes it)",
            ),
        ),
        (
            "t1 : truck  c : crane  crash c at 2500ms  by 9s t1 in AwaitLift",
            ("as the part of c has ended: crashed",),
        ),
    ],
)
def test_who_refused_and_when_it_was_decided(
    body: str, told: tuple[str, ...], here: Here, folder: Path
) -> None:
    (folder / "dock.aseme").write_text(f'{DOCK}scenario "s" {{\n  {body}\n}}\n')
    done = here("test", "dock.aseme", "-j", "1")
    assert all(any(line.endswith(text) for line in done.out.splitlines()) for text in told), done.out


def test_code_that_is_not_repeatable_is_said_so(here: Here, folder: Path) -> None:
    (folder / "activities").mkdir()
    (folder / "activities" / "ring.py").write_text(
        "from pathlib import Path\n\n\nclass Ring:\n    def execute(self, context):\n"
        "        seen = Path('seen')\n        context.set_variable('n', int(seen.exists()))\n"
        "        seen.touch()\n"
    )
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["bell.aseme"]\nactivities = "activities"\n'
    )
    (folder / "bell.aseme").write_text(
        "system Bell\nsrm bell { var n : int = 0  liveness { bell = Ring . Rest }\n"
        "  activities { Ring takes 100ms writes n  Rest takes 1s simulated } }\nteam T { bob : bell }\n"
        'scenario "s" { activity Ring real  by 1s bob has [n == 1] }\n'
    )
    done = here("test", "bell.aseme", "-j", "1")
    assert "a second run with this seed was different" in done.out, done.out
    (folder / "pyproject.toml").unlink()
    done = here("test", "bell.aseme", "-j", "1")
    assert "bell.aseme:5:16: Ring is to be real, and there is no code of it" in done.out, done.out


def test_what_came_too_early_and_what_could_not_be_sent(here: Here, folder: Path) -> None:
    text = DOCK.replace("send refuse Load to client", "send refuse Load to one client")
    (folder / "dock.aseme").write_text(
        f'{text}scenario "s" {{ t1 : truck  c : crane  in order c in Decline, sent request Load  for 9s }}\n'
        'scenario "t" { t1 : truck  c : crane  by 9s sent refuse Load by c }\n'
    )
    done = here("test", "dock.aseme", "-j", "1")
    assert "`sent request Load` (part 2 of 2) has not come by 9 s: it came at 2 s, too early;" in done.out
    assert "`sent refuse Load by c` has not come by 9 s: c could not send it at 3 s: there is no" in done.out
