"""What is built with what is known from before is, to the byte, what a build from nothing writes."""

from __future__ import annotations

import random
import re
import shutil
from pathlib import Path

import pytest

from aseme_dsl.project.building.build import Choice, build
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.building.workshop import Workshop
from tests.support.lanes import kept
from tests.support.large import large_file

ROOT = Path(__file__).parents[3]
FILES = [
    *sorted((ROOT / "tests" / "acceptance").rglob("*.aseme")),
    *sorted((ROOT / "examples").rglob("*.aseme")),
]
CHOICE = Choice(only=frozenset({"models", "proto", "monas", "jade_like"}))


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "activities" not in path.parts and path.name != ".asemec.json"
    }


class Rebuilding:
    """A root that is built again and again, each time compared with a build from nothing."""

    def __init__(self, root: Path, folder: Path) -> None:
        self.root, self.folder = root, folder
        self.workshop = Workshop()
        self.number = 0

    def build(self) -> bool:
        self.number += 1
        known = compile_root(self.root, workshop=self.workshop)
        cold = compile_root(self.root)
        assert list(map(str, known.diagnostics)) == list(map(str, cold.diagnostics))
        assert [str(item.span) for item in known.diagnostics] == [str(item.span) for item in cold.diagnostics]
        assert (known.system is None) == (cold.system is None)
        if known.system is None or cold.system is None:
            return False
        earlier = self.workshop.about(str(self.root)).begin(known.layout)
        written = build(known.system, self.folder / "known", CHOICE, earlier=earlier).written
        assert written.diagnostics == ()
        fresh = self.folder / f"cold{self.number}"
        build(cold.system, fresh, CHOICE)
        assert contents(self.folder / "known") == contents(fresh)
        return True


def edited(text: str, chance: random.Random) -> str:
    """A text with one small change, of which most are no mistake."""
    lines = text.split("\n")
    number = chance.randrange(len(lines))
    match chance.randrange(4):
        case 0:
            lines.insert(0, "// A comment above everything.")
        case 1:
            lines.insert(number, "")
        case 2:
            lines[number] += "  // said of this line"
        case _:
            lines[number] = re.sub(r"\b\d+\b", lambda found: str(int(found[0]) + 1), lines[number])
    return "\n".join(lines)


@pytest.mark.parametrize(
    "file",
    kept(FILES, lambda path: path.stem not in ("warehouse", "hospital", "meetings")),
    ids=lambda path: path.name,
)
def test_edits_of_a_file(file: Path, tmp_path: Path) -> None:
    chance = random.Random(file.name)
    for other in file.parent.glob("*.aseme"):
        shutil.copy(other, tmp_path)
    root = tmp_path / file.name
    texts = [file.read_text("utf-8")]
    for _ in range(2):
        texts.append(edited(texts[-1], chance))
    rebuilding = Rebuilding(root, tmp_path)
    built = 0
    for text in [*texts, texts[0]]:
        root.write_text(text, "utf-8")
        built += rebuilding.build()
    assert built >= 2 or not re.search(r"^system", texts[0], re.MULTILINE)


def test_declarations_that_come_go_and_move(tmp_path: Path) -> None:
    root = tmp_path / "large.aseme"
    rebuilding = Rebuilding(root, tmp_path)
    text = large_file(300)
    moved = re.sub(r"(?s)(\naip .*?)(\n\nmessage Reading1.*?\n}\n(?=\n))", r"\2\1", text, count=1)
    for version in (text, large_file(500), text.replace("Report", "Note"), moved, text):
        root.write_text(version, "utf-8")
        assert rebuilding.build()


def test_a_change_of_one_role_renews_nothing_else(tmp_path: Path) -> None:
    root = tmp_path / "large.aseme"
    text = large_file(400)
    workshop, out = Workshop(), tmp_path / "out"
    for version in (text, text.replace("takes 250ms uses drill2", "takes 260ms uses drill2")):
        root.write_text(version, "utf-8")
        known = compile_root(root, workshop=workshop)
        assert known.system is not None
        report = build(known.system, out, Choice(), earlier=workshop.about(str(root)).begin(known.layout))
    changed = {path.relative_to(out).as_posix() for path in report.written.changed}
    assert changed == {
        "models/srm.machine2.json",
        "diagrams/iac.machine2.svg",  # it shows how long activities take
        "diagrams/srm.machine2.svg",
        "monas/Plant/__init__.py",
        "monas/Plant/machine2/plan.py",
    }
