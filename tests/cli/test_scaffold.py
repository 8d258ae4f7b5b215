"""`asemec scaffold`."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import GOOD, Here

SKETCH = """\
system Match
sag {
  actor striker { goal win depends on keeper "More goals than they have." }
  actor keeper { }
}
suc { usecase win includes shout, run }
"""


@pytest.fixture
def sketch(folder: Path) -> Path:
    (folder / "match.aseme").write_text(SKETCH)
    return folder / "match.aseme"


def test_what_is_missing_is_added_behind_what_is_there(here: Here, sketch: Path) -> None:
    done = here("scaffold", "match.aseme")
    assert done.code == 0
    assert done.out == "match.aseme: 3 skeletons added\n"
    assert "match.aseme:6:15: the protocol `win`" in done.err
    text = sketch.read_text()
    assert text.startswith(SKETCH)
    assert "aip win {" in text
    assert "srm striker {" in text
    assert "process = Shout ? Run" in text and "//" not in text
    checked = here("check", "match.aseme")
    assert checked.code == 0 and "note[E109]" in checked.out and "fine" not in checked.out
    assert here("check", "--strict", "match.aseme").code == 1
    assert (
        here("fmt", "--check", "match.aseme").code in (0, 1) and "E109" not in here("fmt", "match.aseme").err
    )
    for command in ("build", "run", "diagram"):
        refused = here(command, "match.aseme")
        assert refused.code == 1 and "error[E109]" in refused.err, command
    assert not (sketch.parent / "out").exists()
    before = sketch.stat().st_mtime_ns, sketch.stat().st_ino
    assert here("scaffold", "match.aseme").out == "match.aseme: 0 skeletons added\n"
    assert (sketch.stat().st_mtime_ns, sketch.stat().st_ino) == before


PLAYED = """\
system Depot
suc { usecase bring by courier, office includes fetch }
aip bring { participant courier { process = Fetch } participant office { process = Fetch } }
srm courier { plays bring.courier as own  liveness { courier = own } }
srm office { liveness { office = Rest } activities { Rest takes 1s Fetch takes 1s } }
"""


def test_a_comment_is_not_counted_as_a_skeleton(here: Here, folder: Path) -> None:
    (folder / "depot.aseme").write_text(PLAYED)
    done = here("scaffold", "depot.aseme")
    assert done.out == "depot.aseme: 0 skeletons and 1 comment added\n"
    assert "but plays none of bring: comment added" in done.err
    assert "  // The use case bring; let a formula" in (folder / "depot.aseme").read_text()


def test_what_seems_to_be_renamed_is_told(here: Here, folder: Path) -> None:
    text = PLAYED.replace("usecase bring", "usecase transport")
    (folder / "depot.aseme").write_text(text)
    done = here("scaffold", "depot.aseme")
    assert "depot.aseme:2:15: warning[W560]" in done.err
    assert "aip transport" not in (folder / "depot.aseme").read_text()


def test_nothing_is_missing(here: Here, folder: Path) -> None:
    assert here("scaffold", "good.aseme").out == "good.aseme: 0 skeletons added\n"
    assert (folder / "good.aseme").read_text() == GOOD


def test_a_preview_changes_nothing(here: Here, sketch: Path) -> None:
    done = here("scaffold", "--diff", "match.aseme")
    assert done.code == 0
    assert done.out.startswith("--- match.aseme\n+++ match.aseme\n")
    assert "+aip win {" in done.out
    assert not any(line.startswith("-") for line in done.out.splitlines()[1:])
    assert sketch.read_text() == SKETCH


def test_line_ends_mark_permissions_and_links_stay(here: Here, sketch: Path) -> None:
    sketch.write_bytes(b"\xef\xbb\xbf" + SKETCH.replace("\n", "\r\n").encode())
    sketch.chmod(0o640)
    (sketch.parent / "link.aseme").symlink_to(sketch)
    assert here("scaffold", "link.aseme").code == 0
    content = sketch.read_bytes()
    assert content.startswith(b"\xef\xbb\xbfsystem Match\r\n")
    assert content.count(b"\n") == content.count(b"\r\n")
    assert sketch.stat().st_mode & 0o777 == 0o640
    assert (sketch.parent / "link.aseme").is_symlink()


def test_a_file_with_errors_stays_as_it_is(here: Here, folder: Path) -> None:
    before = (folder / "bad.aseme").read_bytes()
    done = here("scaffold", "bad.aseme")
    assert done.code == 1
    assert "error[" in done.err
    assert done.out == ""
    assert (folder / "bad.aseme").read_bytes() == before


def test_files_that_cannot_be_read(here: Here, folder: Path) -> None:
    (folder / "latin.aseme").write_bytes(b"system Caf\xe9")
    for name, code in (("missing.aseme", "E001"), ("latin.aseme", "E002")):
        done = here("scaffold", name)
        assert done.code == 1
        assert code in done.err


def test_standard_input_is_completed_on_standard_output(here: Here, folder: Path) -> None:
    done = here("scaffold", "-", input=SKETCH.encode())
    assert done.code == 0
    assert done.out.startswith(SKETCH)
    assert "aip win {" in done.out


def test_json(here: Here, sketch: Path) -> None:
    result = here("scaffold", "--json", "match.aseme").json
    (row,) = result["files"]
    assert row["file"] == "match.aseme"
    assert len(row["added"]) == 3
    assert "+aip win {" in row["difference"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_folder_that_cannot_be_written(here: Here, sketch: Path) -> None:
    sketch.parent.chmod(0o555)
    try:
        done = here("scaffold", "match.aseme")
        assert done.code == 1
        assert "error[E009]" in done.err
        assert sketch.read_text() == SKETCH
    finally:
        sketch.parent.chmod(0o755)


MOVER = """\
system T
enum Place { BELT SHELF }
srm robot {
  liveness { robot = MoveTo(Place.BELT) . Grasp }
  activities { MoveTo(goal : Place) takes 1s  Grasp ends held, slipped }
}
team X { r : robot }
"""


@pytest.fixture
def mover(here: Here, folder: Path) -> Path:
    (folder / "pyproject.toml").write_text('[tool.asemec]\nfiles = ["t.aseme"]\nactivities = "activities"\n')
    (folder / "t.aseme").write_text(MOVER)
    assert here("scaffold", "t.aseme").code == 0
    changed = MOVER.replace("(Place.BELT)", "(Place.BELT, 2.0)").replace("Place)", "Place, speed : double)")
    (folder / "t.aseme").write_text(changed)
    return folder / "activities" / "move_to.py"


def test_a_stub_that_nobody_has_edited_is_renewed(here: Here, mover: Path) -> None:
    before = mover.read_text()
    assert (
        "+    def execute(self, context: Context, goal: Place, speed: float)"
        in here("scaffold", "--diff").out
    )
    assert mover.read_text() == before
    done = here("scaffold", "t.aseme")
    assert f"{Path('activities', 'move_to.py')}: renewed" in done.out
    assert "grasp.py" not in done.out
    assert "goal: Place, speed: float) -> None:" in mover.read_text()
    assert "renewed" not in here("scaffold", "t.aseme").out


@pytest.mark.parametrize("edited", ["# mine\n", "        return None\n", "    speed = 3\n"])
def test_an_edited_stub_stays_and_check_gives_its_new_signature(here: Here, mover: Path, edited: str) -> None:
    mover.write_text(mover.read_text() + edited)
    before = mover.read_text()
    assert "renewed" not in here("scaffold", "t.aseme").out
    assert mover.read_text() == before
    assert "write `def execute(self, context, goal, speed)`" in here("check").out
