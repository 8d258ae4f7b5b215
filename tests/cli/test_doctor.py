"""`asemec doctor`."""

from __future__ import annotations

import re
import tomllib
from importlib import metadata
from pathlib import Path

import pytest

import aseme_dsl
from aseme_dsl.project.settings.tools import OPTIONAL
from tests.cli.support import Here

ROOT = Path(__file__).parents[2]


def test_what_is_there_and_what_for(here: Here) -> None:
    done = here("doctor")
    assert done.code == 0
    assert done.out.startswith(f"asemec {aseme_dsl.__version__}\n")
    for name in (
        "Python",
        "textx",
        "Graphviz",
        "grpcio-tools",
        "jsonschema",
        "backend monas",
        "standard library",
    ):
        assert f"  {name} " in done.out
    assert "soccer" in done.out


def test_every_extra_is_there() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    extras = {name: packages for name, packages in project["optional-dependencies"].items() if name != "dev"}
    assert {package: extra for package, (extra, _) in OPTIONAL.items()} == {
        re.match(r"[\w-]+", package)[0]: extra  # type: ignore[index]
        for extra, packages in extras.items()
        for package in packages
    }
    table = (ROOT / "docs/index.md").read_text("utf-8")
    assert [name for name in extras if f"| `{name}` |" not in table] == []


def test_json(here: Here) -> None:
    result = here("doctor", "--json").json
    assert result["version"] == aseme_dsl.__version__
    tools = {tool["name"]: tool for tool in result["tools"]}
    assert tools["textx"]["found"] == metadata.version("textx")
    assert tools["textx"]["needed"] is True
    assert tools["jsonschema"]["needed"] is False


def test_what_is_missing_and_how_to_get_it(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.diagrams import GraphvizMissing
    from aseme_dsl.project.settings import tools

    there = metadata.version

    def version(name: str) -> str:
        if name in ("grpcio-tools", "jsonschema"):
            raise metadata.PackageNotFoundError(name)
        return there(name)

    def missing() -> str:
        raise GraphvizMissing

    monkeypatch.setattr(tools.metadata, "version", version)
    monkeypatch.setattr("aseme_dsl.diagrams.program", missing)
    done = here("doctor")
    assert done.code == 0
    assert "pip install 'aseme-dsl[proto]'" in done.out
    assert "pip install 'aseme-dsl[schema]'" in done.out
    assert "pip install graphviz-pure" in done.out


def test_without_what_is_needed_the_exit_code_is_1(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.project.settings import tools

    there = metadata.version

    def version(name: str) -> str:
        if name == "textx":
            raise metadata.PackageNotFoundError(name)
        return there(name)

    monkeypatch.setattr(tools.metadata, "version", version)
    done = here("doctor")
    assert done.code == 1
    assert "required: pip install textx" in done.out
