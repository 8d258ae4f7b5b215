"""`asemec prove`: who has crashed or left, and who joins late, as in a run."""

from __future__ import annotations

import json
from pathlib import Path

from tests.cli.support import Here

CRASH = """\
system Crash
srm one {
  var n : int = 0
  liveness { one = (Go . Rest)~ }
  activities { Go takes 1s Rest takes 1s }
}
srm two { liveness { two = Watch . Off }  activities { Watch takes 2s Off waits } }
team T { x : one  y : two }
property "always" { assume at most 1 of one crash  always x in (Go or Rest) }
property "has" { always x has [n == 0] }
property "until" { x in (Go or Rest) until y in Off }
property "in time" { always x in one  every y in Watch leads to x in Rest within 10s }
property "never" { never x in Go and x in Rest }
"""

PEERS = """\
system Peers
message Q { int n }
aip ask {
  participant asker { sends query_ref Q receives inform Q  process = Plan . Hope }
  participant teller { sends inform Q receives query_ref Q  process = Answer }
  control asker {
    enter Hope : / send query_ref Q { n = 1 } to teller
    leave Hope : inform Q from teller or lost teller
  }
  control teller { enter Answer : query_ref Q from asker  leave Answer : / send inform Q { n = 2 } to asker }
}
srm one { plays ask.asker  liveness { one = asker . Ready }  activities { Ready takes 100ms } }
srm two { plays ask.teller  liveness { two = teller } }
team T { x : one  y : two }
property "gone" { assume at most 1 of two crash  never x in Ready and y in Answer }
"""


def proved(here: Here, folder: Path, text: str, *asked: str) -> list[str]:
    """The verdicts on the questions."""
    (folder / "it.aseme").write_text(text)
    done = here("prove", "it.aseme", *asked, "--json")
    return [item["verdict"] for item in json.loads(done.out)["results"]]


def test_who_has_crashed_is_in_no_state(here: Here, folder: Path) -> None:
    """It was in its last one for ever, so that `always x in …` was proved."""
    for name in ("always", "has", "until"):
        assert proved(here, folder, CRASH, name) == ["REFUTED"], name
    assert proved(here, folder, CRASH, "in time") == ["REFUTED", "REFUTED"]
    assert proved(here, folder, CRASH, "never") == ["PROVED"]
    scenario = 'scenario "s" { crash x at 500ms  for 5s }\n'
    (folder / "it.aseme").write_text(CRASH + scenario)
    assert "x is in no state" in here("test", "it.aseme").out


def test_what_who_has_crashed_did_counts_no_more(here: Here, folder: Path) -> None:
    """The sender of a question learns of the crash when nobody answers any more. That was UNDECIDED."""
    assert proved(here, folder, PEERS, "gone") == ["PROVED"]


LATE = """\
system Late
message Job { int n }
aip one {
  participant boss { sends request Job receives inform Job  process = Ask . Wait }
  participant worker { sends inform Job receives request Job  process = Do }
  control boss {
    enter Wait : / send request Job { n = 1 } to worker
    leave Wait : inform Job from worker or after(2s)
  }
  control worker {
    enter Do : request Job from boss
    leave Do : / send inform Job { n = 3 } to boss
    leave Do : lost boss
  }
  clause Wait@boss before Do@worker
  clause every Wait@boss leads to Do@worker
}
srm chief { plays one.boss  liveness { chief = boss . Rest }  activities { Rest waits } }
srm hand { plays one.worker  liveness { hand = Nap . worker }  activities { Nap takes 1s } }
team T { b : chief  w : hand }
"""


def test_a_conversation_goes_on_with_who_joins_when_all_have_left(here: Here, folder: Path) -> None:
    """It began anew with who joined, as if nobody had waited: that was UNDECIDED."""
    assert proved(here, folder, LATE, "team", "Wait@boss before Do@worker") == ["PROVED"]
    done = here("prove", "it.aseme", "team", "every Wait@boss leads to Do@worker")
    assert done.out.startswith("REFUTED")
    assert "b gets not_understood Job of w" in done.out.splitlines()[-1]
