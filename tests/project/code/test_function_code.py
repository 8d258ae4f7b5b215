"""The Python functions that a document names: found, or reported, without importing anything."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.cli import main
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.code.function_code import check_functions
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
    assert "team.aseme:2:10: E541: the function near(int): no function near in module places" in said
    assert "Look" not in said


# ---- what the configuration names ----------------------------------------------------------------


def of_run(folder: Path, written: str) -> list[tuple[str, str, str]]:
    """Code, place and message of what a `[tool.asemec.run]` gets wrong."""
    (folder / "team.aseme").write_text(
        "system Team\nsrm r { liveness { r = A }  activities { A takes 1s } }\n"
    )
    (folder / "pyproject.toml").write_text(
        f'[tool.asemec]\nfiles = ["team.aseme"]\n\n[tool.asemec.run]\n{written}\n'
    )
    found = compile_root(folder / "team.aseme").diagnostics
    return [(item.code, str(item.span).rpartition("/")[2], item.message) for item in found]


NOT_GIVEN = "the Python function `{}` takes `{}`, which a world is not given"
GAME = """
from functools import partial
def world(seed, size=3): ...
def any_world(**named): ...
def no_seed(number): ...
def needs_more(seed, size): ...
def by_name(*, seed): ...
def progress(world): ...
def progress_of_all(world, doing): ...
def nothing(): ...
def three(a, b, c): ...
bound = partial(world, size=4)
LIMIT = 3
"""


@pytest.mark.parametrize(
    "written",
    [
        'world = "game:world"',
        'world = "game:any_world"',
        'world = "game:by_name"',
        'world = "game:bound"',
        'progress = "game:progress"',
        'progress = "game:progress_of_all"',
        'summary = "game:progress"',
        'world = "aseme_dsl.worlds.field:no_such_thing_known_without_import"',
    ],
)
def test_what_the_configuration_names_is_there(tmp_path: Path, written: str) -> None:
    (tmp_path / "game.py").write_text(GAME)
    if "no_such" in written:
        assert [code for code, *_ in of_run(tmp_path, written)] == ["E541"]
        return
    assert of_run(tmp_path, written) == []


@pytest.mark.parametrize(
    ("written", "code", "message"),
    [
        ('world = "gme:world"', "E541", "there is no Python module `gme`"),
        ('seed = 3\nworld = "game:wrld"', "E541", "the module `game` has no `wrld`"),
        ('summary = "game:LIMIT"', "E541", "`LIMIT` of the module `game` is not a function"),
        (
            'world = "game:no_seed"',
            "E542",
            "the Python function `no_seed` takes `number`, which a world is not given",
        ),
        (
            'world = "game:needs_more"',
            "E542",
            "the Python function `needs_more` takes `size`, which a world is not given",
        ),
        ('world = "game:nothing"', "E542", "the Python function `nothing` takes no `seed`"),
        ('progress = "game:three"', "E542", "the Python function `three` takes 3 arguments, and gets 1"),
        ('summary = "game:nothing"', "E542", "the Python function `nothing` takes 0 arguments, and gets 1"),
        (
            'summary = "game:progress_of_all"',
            "E542",
            "the Python function `progress_of_all` takes 2 arguments, and gets 1",
        ),
    ],
)
def test_what_the_configuration_names_is_not_there(
    tmp_path: Path, written: str, code: str, message: str
) -> None:
    (tmp_path / "game.py").write_text(GAME)
    line = 5 + written.count("\n")
    found = of_run(tmp_path, written)
    assert [(item[0], item[2]) for item in found] == [(code, message)]
    assert found[0][1].startswith(f"pyproject.toml:{line}:")


def test_two_systems_of_a_project_say_it_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    of_run(tmp_path, 'world = "gme:world"')
    (tmp_path / "two.aseme").write_text((tmp_path / "team.aseme").read_text().replace("Team", "Two"))
    project = tmp_path / "pyproject.toml"
    project.write_text(project.read_text().replace('"team.aseme"', '"team.aseme", "two.aseme"'))
    assert main(["check", str(tmp_path)]) == 1
    assert capsys.readouterr().out.count("E541") == 1
