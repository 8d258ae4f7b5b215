"""The wheel: it carries all that the package reads at run time, and works where no checkout is."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import aseme_dsl
from aseme_dsl.standard_library import standard_library

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of this checkout, built without the network."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder), str(ROOT)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    (built,) = folder.glob("*.whl")
    return built


def sources(folder: str, where: str) -> set[str]:
    """Every file of a folder of the checkout, named as the wheel must name it."""
    return {
        f"{where}/{path.relative_to(ROOT / folder).as_posix()}"
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }


def test_the_wheel_has_every_file_of_the_package_and_the_standard_library(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        carried = {name for name in archive.namelist() if ".dist-info/" not in name}
        licences = [name for name in archive.namelist() if name.endswith("/licenses/LICENSE")]
    moved = sources("stdlib", "aseme_dsl/_stdlib") | {"aseme_dsl/_constructs.md"}
    assert carried == sources("aseme_dsl", "aseme_dsl") | moved
    assert "aseme_dsl/py.typed" in carried
    assert len(licences) == 1


def test_an_installed_package_finds_its_standard_library(wheel: Path, tmp_path: Path) -> None:
    site = tmp_path / "site"
    (tmp_path / "site" / "stdlib").mkdir(parents=True)  # somebody else's
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    question = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from aseme_dsl.standard_library import standard_library\n"
        "print(standard_library())\n"
        "print(*sorted(path.name for path in standard_library().iterdir()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", question, str(site)], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    folder, names = done.stdout.splitlines()
    assert Path(folder) == site / "aseme_dsl" / "_stdlib"
    assert names.split() == sorted(path.name for path in standard_library().iterdir())


def test_a_checkout_reads_the_standard_library_at_its_root() -> None:
    assert standard_library() == ROOT / "stdlib"


def test_every_place_gives_the_same_version() -> None:
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    changes = (ROOT / "CHANGELOG.md").read_text("utf-8")
    assert re.findall(r"^version: (.+)$", citation, re.MULTILINE) == [aseme_dsl.__version__]
    assert f"## [{aseme_dsl.__version__}]" in changes


def test_dev_script_and_package_need_the_same_python() -> None:
    import dev

    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert project["requires-python"] == ">={}.{}".format(*dev.OLDEST_PYTHON)
