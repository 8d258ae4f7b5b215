"""Options that have no effect in a call, and agents that are not there, are refused and never ignored."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

TEAM = """system Team
srm player { liveness { player = Look }  activities { Look takes 1s } }
team Players { bob : player  ann : player }
"""


@pytest.fixture
def built(here: Here, folder: Path) -> Here:
    (folder / "team.aseme").write_text(TEAM)
    assert here("run", "team.aseme", "--quiet").code == 0
    return here


def test_a_name_for_the_agent_of_no_plan_is_refused(built: Here) -> None:
    done = built("run", "team.aseme", "--agent", "nobody")
    assert done.code == 2
    assert "error[E028]: `--agent` has no effect without `--plan`" in done.err
    assert built("run", "team.aseme", "--plan", "player", "--agent", "nobody", "-q").code == 0


@pytest.mark.parametrize(
    "options", [("-o", "other"), ("--templates", "other"), ("--force",), ("--backend", "jade_like")]
)
def test_what_only_a_build_takes_is_refused_of_an_output_folder(
    built: Here, folder: Path, options: tuple[str, ...]
) -> None:
    done = built("run", "out", *options)
    assert done.code == 2
    said = " ".join(options) if options[0] == "--backend" else options[0]
    assert f"out: error[E028]: `{said}` has no effect" in done.err
    assert "hint:" in done.err
    assert built("run", "out", *options, "--json").json["diagnostics"][0]["code"] == "E028"
    assert not (folder / "other").exists()


def test_a_backend_that_was_built_is_taken(built: Here) -> None:
    assert built("run", "out", "--backend", "monas", "--quiet").code == 0
    assert built("run", "out", "--backend", "player=monas", "--quiet").code == 0


@pytest.mark.parametrize("options", [(), ("--lines",), ("-o", "some.jsonl")])
def test_an_agent_that_a_trace_does_not_have_is_an_error(built: Here, options: tuple[str, ...]) -> None:
    done = built("trace", "out", "--agent", "bobb", *options)
    assert done.code == 1
    assert "error[E029]: the trace has nothing about an agent `bobb`" in done.err
    assert "did you mean `bob`?" in done.err
    assert built("trace", "out", "--agent", "bob", *options).code == 0


@pytest.mark.parametrize("command", ["build", "run"])
@pytest.mark.parametrize(("name", "what"), [("team.aseme", "is a file"), ("nowhere", "does not exist")])
def test_templates_that_are_no_folder_are_an_error(built: Here, command: str, name: str, what: str) -> None:
    done = built(command, "team.aseme", "--templates", name)
    assert done.code == 1
    assert f"{name}: error[E030]: the folder of templates {what}" in done.err


def test_templates_of_a_project_that_are_no_folder_are_an_error(built: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text('[tool.asemec]\nfiles = ["team.aseme"]\ntemplates = "nowhere"\n')
    done = built("build")
    assert (done.code, "error[E030]" in done.err) == (1, True)
