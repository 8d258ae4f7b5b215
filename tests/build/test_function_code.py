"""The Python functions that a document names: found, or reported, without importing anything."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.build.function_code import check_functions
from aseme_dsl.build.project import compile_root
from aseme_dsl.cli import main
from tests.support.compiling import system

TEAM = """system Team
function near(int floor) : bool = "TARGET"
srm player {
  var level : int = 0
  liveness { player = Look . [Walk] }
  activities { Look takes 1s  Walk takes 1s }
  control player {
    enter Walk : [near(level)]
    skip  Walk : else
  }
}
"""


def said(folder: Path, target: str) -> list[tuple[str, str, str | None]]:
    found = check_functions(system(TEAM.replace("TARGET", target)), folder)
    assert all(item.span is not None and item.span.text == target for item in found)
    return [(item.code, item.message, item.hint) for item in found]


def test_a_file_alone_finds_its_functions_beside_it(tmp_path: Path) -> None:
    root = tmp_path / "team.aseme"
    root.write_text(TEAM.replace("TARGET", "plces:near"))
    (tmp_path / "places.py").write_text("def near(floor): return True\n")
    (found,) = [item for item in compile_root(root).diagnostics if item.code == "E541"]
    assert found.hint == "did you mean `places:near`?"
    root.write_text(TEAM.replace("TARGET", "places:near"))
    assert not [item for item in compile_root(root).diagnostics if item.code.startswith("E")]


def test_a_module_that_is_not_there(tmp_path: Path) -> None:
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "__init__.py").write_text("raise SystemExit\n")
    (tmp_path / "rooms" / "places.py").write_text("raise SystemExit\ndef near(floor): return True\n")
    assert said(tmp_path, "rooms.places:near") == []
    assert said(tmp_path, "rooms.plces:near") == [
        ("E541", "there is no Python module `rooms.plces`", "did you mean `rooms.places:near`?")
    ]
    assert said(tmp_path, "romms.places:near") == [
        ("E541", "there is no Python module `romms`", "did you mean `rooms.places:near`?")
    ]
    assert said(tmp_path, "xylophone:near") == [
        ("E541", "there is no Python module `xylophone`", "write the module with `def near`")
    ]


def test_a_name_that_the_module_lacks(tmp_path: Path) -> None:
    (tmp_path / "places.py").write_text("def naer(floor): return True\nlimit = 3\n")
    assert said(tmp_path, "places:near") == [
        ("E541", "the module `places` has no `near`", "did you mean `places:naer`?")
    ]
    assert [code for code, *_ in said(tmp_path, "places:limit")] == ["E541"]
    (tmp_path / "places.py").write_text("def near(:\n")
    assert [code for code, *_ in said(tmp_path, "places:near")] == ["E541"]


@pytest.mark.parametrize(
    ("signature", "fits"),
    [
        ("floor", True),
        ("floor, room=1", True),
        ("*floors", True),
        ("", False),
        ("floor, room", False),
        ("*, floor", False),
        ("floor, *, room", False),
        ("floor, *, room=1", True),
    ],
)
def test_the_parameters_that_can_be_seen(tmp_path: Path, signature: str, fits: bool) -> None:
    (tmp_path / "places.py").write_text(f"def near({signature}): return True\n")
    assert [code for code, *_ in said(tmp_path, "places:near")] == ([] if fits else ["E542"])


@pytest.mark.parametrize(
    "code",
    [
        "from elsewhere import near",
        "from elsewhere import *",
        "near = make()",
        "if True:\n    def near(a, b, c): return True",
        "@changed\ndef near(a, b, c): return True",
        "def __getattr__(name): return min",
        "globals()['near'] = min",
        "near, far = min, max",
        "try:\n    import near\nexcept ImportError as near:\n    pass",
        "def near(a, b): return True\nnear = changed(near)",
        "class near:\n    def __init__(self, a, b): pass",
        "near: object = min",
        "def make():\n    global near\n    near = min",
    ],
)
def test_nothing_is_said_of_what_cannot_be_seen(tmp_path: Path, code: str) -> None:
    (tmp_path / "places.py").write_text(code + "\n")
    assert said(tmp_path, "places:near") == []


@pytest.mark.parametrize("target", ["math:isfinite", "os.path:exists", "time:sleep"])
def test_the_library_of_python_is_trusted(tmp_path: Path, target: str) -> None:
    assert said(tmp_path, target) == []


def test_an_installed_package_is_looked_at_without_importing_it(tmp_path: Path) -> None:
    assert [code for code, *_ in said(tmp_path, "aseme_dsl.runtime.library.math:florr")] == ["E541"]
    assert [code for code, *_ in said(tmp_path, "aseme_dsl.runtime.library.maths:floor")] == ["E541"]
    assert said(tmp_path, "aseme_dsl.runtime.library.math:floor") == []


def test_a_run_that_lacks_a_function_does_not_begin(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "team.aseme").write_text(TEAM.replace("TARGET", "places:near"))
    (tmp_path / "places.py").write_text("def __getattr__(name):\n    raise AttributeError(name)\n")
    assert main(["run", str(tmp_path / "team.aseme"), "--for", "3s", "--output", str(tmp_path / "out")]) != 0
    said = "".join(capsys.readouterr())
    assert "E541: the function near(int): no function near in module places" in said
    assert "Look" not in said
