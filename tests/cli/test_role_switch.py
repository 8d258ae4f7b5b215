"""What an agent does after it has switched its role is measured as that of the other role."""

from __future__ import annotations

from pathlib import Path

from tests.cli.support import Here

TWO = """system Two
import runtime
srm goalie {
  liveness { goalie = Guard . Save~ }
  activities { Guard takes 200ms simulated  Save takes 100ms simulated }
  control goalie {
    enter Save~ : / runtime.signal.SelectPlan.plan = "player"; write_messages.runtime.signal.SelectPlan
  }
}
srm player {
  liveness { player = Chase . Kick~ }
  activities { Chase takes 300ms simulated  Kick takes 100ms simulated }
}
team Two { b : goalie }
property "one of them at once" { at most one (Guard or Save) }
"""


def test_metrics_and_coverage_follow_a_switch_of_the_role(here: Here, folder: Path) -> None:
    (folder / "two.aseme").write_text(TWO)
    done = here("run", "two.aseme", "-o", "out", "--for", "950ms", "--trace", "t.jsonl", "--json", "-q")
    assert [item["verdict"] for item in done.json["result"]["watched"]] == ["kept"]
    rows = here("metrics", "t.jsonl", "--json").json["metrics"]["rows"]
    found = {(row["of"], row["name"]): row["times"] for row in rows if row["kind"] == "state"}
    assert found == {
        ("goalie", "goalie"): [1],
        ("goalie", "Guard"): [1],
        ("goalie", "Save~"): [1],
        ("goalie", "Save"): [1],
        ("player", "player"): [1],
        ("player", "Chase"): [1],
        ("player", "Kick~"): [1],
        ("player", "Kick"): [5],
    }
    covered = here("coverage", "t.jsonl").out.splitlines()
    assert [line.split()[1:3] for line in covered if line.startswith("states")] == [["8", "8"]], covered


def test_why_asks_the_role_that_an_agent_had_then(here: Here, folder: Path) -> None:
    (folder / "two.aseme").write_text(TWO)
    here("run", "two.aseme", "-o", "out", "--for", "950ms", "--trace", "t.jsonl", "-q")
    kicked = here("why", "b", "Kick", "--at", "950ms", "t.jsonl").out
    assert "at 0.9 s it went to Kick from Kick" in kicked, kicked
    saved = here("why", "b", "Save", "--at", "950ms", "t.jsonl").out
    assert "b is in Kick" in saved and "at 0.2 s it went to Save from the start of Save~" in saved, saved
    refused = here("whynot", "b", "Save", "--at", "950ms", "t.jsonl").err
    assert "player has no state, transition or message Save" in refused, refused
    assert "it ran another model that has it" in refused


TOLD = """system Two
import runtime
srm goalie {
  liveness { goalie = Guard . (Dive | Jump | Wait) . Save~ }
  activities {
    Guard takes 200ms simulated  Dive takes 1s simulated  Jump takes 1s simulated
    Wait takes 100ms simulated  Save takes 100ms simulated
  }
  control goalie {
    enter Dive : [false]  enter Jump : [false]  enter Wait : else
    enter Save~ : / runtime.signal.SelectPlan.plan = "player"; write_messages.runtime.signal.SelectPlan
  }
}
srm player {
  liveness { player = Chase . Dive }
  activities { Chase takes 300ms simulated }
  control player { enter Dive : [false] }
}
team Two { b : goalie }
scenario "s" { b : goalie  by 3s b in Dive }
"""


def test_a_story_tells_the_transitions_of_two_roles_apart(here: Here, folder: Path) -> None:
    (folder / "two.aseme").write_text(TOLD)
    done = here("test", "two.aseme", "-j", "1")
    assert "b  enters Chase (two.aseme:15)\n" in done.out, done.out
