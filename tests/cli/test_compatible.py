"""`asemec check --compatible-with OLD`: what robots of two builds refuse of each other, before the upload."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from tests.cli.support import Here

OLD = """
system Talk
message Call { int n  optional string text }
message Job { int id }
topic team { signal Call queued  state Job }
aip deal {
  participant asker { sends request Job  receives inform Job  process = Ask . Hear }
  participant teller { sends inform Job  receives request Job  process = Think . Tell }
  control asker {
    enter Ask : / send request Job { id = 1 } to teller
    enter Hear : inform Job from teller or after(9s)
  }
  control teller { enter Think : request Job from asker  leave Tell : / send inform Job { id = 1 } to asker }
}
srm chief {
  plays deal.asker
  liveness { chief = asker . Shout }
  activities { Ask takes 10ms  Hear takes 10ms  Shout takes 500ms writes team.signal.Call, team.state.Job }
}
srm aide {
  plays deal.teller
  liveness { aide = teller~ || Listen~ }
  activities { Think takes 1ms  Tell takes 1ms  Listen takes 1s reads team.signal.Call, team.state.Job }
}
team T { ann : chief  bob : aide }
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "old.aseme").write_text(OLD)
    return tmp_path


def compared(here: Here, folder: Path, old: str, new: str, *more: str) -> tuple[int, str]:
    assert old in OLD
    (folder / "new.aseme").write_text(OLD.replace(old, new))
    done = here("check", "new.aseme", "--compatible-with", "old.aseme", *more)
    return done.code, done.out


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("takes 500ms", "takes 501ms"),
        ("int n  optional string text", "int n  optional string text  optional int more"),
        ("int n  optional string text", "int n"),
        ("process = Ask . Hear", "process = (Ask . Hear)"),
    ],
)
def test_what_works(here: Here, folder: Path, old: str, new: str) -> None:
    code, said = compared(here, folder, old, new)
    assert code == 0, said
    assert said.endswith("compatible with old.aseme\n")


@pytest.mark.parametrize(
    ("old", "new", "says", "places"),
    [
        (
            "int n  optional", "double n  optional",
            "channel team.signal.Call: not compatible: `n` is double here and int there", ("3:20", "3:23"),
        ),
        (
            "optional string text }", "optional string text  int more }",
            "channel team.signal.Call: new robots refuse it: `more` is not sent, and is not optional here",
            ("3:9", "3:49"),
        ),
        (
            "optional string text }", "string text }",
            "channel team.signal.Call: new robots refuse it: `text` is required here and optional there",
            ("3:39", "3:30"),
        ),
        (
            "{ int n  optional", "{ optional",
            "channel team.signal.Call: not compatible: `text` has the number 1 here and 2 there",
            ("3:39", "3:32"),
        ),
        (
            "Call queued", "Call",
            "channel team.signal.Call: not compatible: its signals queue", ("5:21", "5:21"),
        ),
        (
            "leave Tell : /", "leave Tell : / send inform Job { id = 2 } to asker;",
            "protocol deal: not compatible: its participants say something else, or in another order",
            ("6:5", "6:5"),
        ),
    ],
)  # fmt: skip
def test_what_does_not_work_has_its_places(
    here: Here, folder: Path, old: str, new: str, says: str, places: tuple[str, str]
) -> None:
    code, said = compared(here, folder, old, new)
    assert code == 1, said
    assert f"new.aseme:{places[1]}: {says}\n   old.aseme:{places[0]}: in old.aseme\n" in said
    code, text = compared(here, folder, old, new, "--json")
    (found,) = json.loads(text)["compatibility"]["incompatible"]
    assert code == 1 and found["reason"] in says and found["old"] == f"old.aseme:{places[0]}"


def test_what_only_one_has(here: Here, folder: Path) -> None:
    code, said = compared(here, folder, "ann : chief", "ann, dan : chief")
    assert code == 0 and "only in the new version: agent dan\n" in said


def test_a_build_and_a_revision(here: Here, folder: Path) -> None:
    assert here("build", "old.aseme", "-o", "out").code == 0
    (folder / "new.aseme").write_text(OLD.replace("int id", "string id").replace("id = 1", 'id = "1"'))
    done = here("check", "new.aseme", "--compatible-with", "out")
    assert done.code == 1
    assert "protocol deal: not compatible: Job: `id` is string here and int there" in done.out
    git = ["git", "-c", "user.name=x", "-c", "user.email=x@y"]
    (folder / "talk.aseme").write_text(OLD)
    for words in (["init", "-q"], ["add", "talk.aseme"], ["commit", "-qm", "x"]):
        subprocess.run([*git, *words], check=True, cwd=folder)
    (folder / "talk.aseme").write_text((folder / "new.aseme").read_text())
    done = here("check", "talk.aseme", "--compatible-with", "HEAD")
    assert done.code == 1 and "channel team.state.Job: not compatible" in done.out


def test_what_is_not_a_version(here: Here, folder: Path) -> None:
    done = here("check", "old.aseme", "--compatible-with", "nowhere.aseme")
    assert done.code == 2 and "nowhere.aseme" in done.err
