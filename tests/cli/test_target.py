"""What commands work on: a file, a project, an output folder, or the project of the current folder."""

from __future__ import annotations

import io
import json
import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

import click
import pytest

from aseme_dsl.cli import view
from aseme_dsl.cli.groups import LazyGroup
from aseme_dsl.cli.program import program
from tests.cli.support import GOOD, Done, Here

PROJECT = '[tool.asemec]\nfiles = ["src/walker.aseme"]\noutput = "made"\n'


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "walker.aseme").write_text(GOOD)
    (tmp_path / "pyproject.toml").write_text(PROJECT)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_trace_is_found_whatever_is_named(here: Here, project: Path) -> None:
    (project / "made").mkdir()
    done = here("run", "--for", "2s", "--allow", "waiting")
    assert done.code == 0, done.err
    assert (project / "made" / "trace.jsonl.gz").is_file()
    for command in ("trace", "sniff"):
        said = here(command, "made/trace.jsonl.gz").out
        for target in ([], ["."], ["made"], ["src/walker.aseme"], [str(project)]):
            again = here(command, *target)
            assert (again.code, again.out.replace(f"{project}/", "")) == (0, said), (command, target)


def test_the_project_around_the_current_folder_is_meant(here: Here, project: Path) -> None:
    os.chdir(project / "src")
    done = here("diagram", "--format", "dot", "-o", "drawn")
    assert done.code == 0, done.err
    assert list((project / "src" / "drawn").iterdir())
    assert here("run", "--for", "1s", "--allow", "waiting").code == 0
    assert here("trace").code == 0


def test_a_project_without_a_run_has_no_trace(here: Here, project: Path) -> None:
    for command in ("trace", "sniff"):
        done = here(command)
        assert done.code == 1
        assert done.err.endswith(
            "error[E001]: there is no trace made/trace.jsonl.gz\n   hint: `asemec run` writes it\n"
        )


def test_of_two_systems_one_is_named(here: Here, folder: Path) -> None:
    for command in ("run", "diagram", "view"):
        done = here(command, ".")
        assert done.code == 2 and "contains 2 systems" in done.err, (command, done.err)


# ---- every command -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Use:
    """A command with a target: what comes before and after that, how it ends, and what it says then."""

    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    code: int = 0
    says: str = ""


USES = {
    "check": Use(says="no problems found in 1 file\n"),
    "fmt": Use(after=("--check",), code=1, says="1 file would be formatted\n"),
    "build": Use(says="Walker -> made: "),
    "diagram": Use(after=("--format", "dot", "-o", "drawn"), says="files: "),
    "view": Use(says="src/walker.aseme: http://"),
    "run": Use(after=("--for", "2s", "--allow", "waiting"), says="  trace: made/trace.jsonl.gz\n"),
    "test": Use(says="    by 3s one in Walk\n  }\n"),
    "sim": Use(after=("--plain",), says="0 s\n"),
    "node": Use(("one",), ("--for", "1ms", "--trace", "one.jsonl"), says="  trace: one.jsonl\n"),
    "team swap": Use(code=1, says="error[E034]: nothing has changed:\nnothing runs from made: "),
    "trace": Use(says="made/trace.jsonl.gz: Walker, seed 1, virtual time\n"),
    "replay": Use(says=" of "),
    "observe": Use(says="nothing to check: "),
    "coverage": Use(),
    "metrics": Use(),
    "goals": Use(),
    "sniff": Use(says="no agent messages in this trace\n"),
    "optimise": Use(after=("--measure", "Walk", "--runs", "1", "--quicker", "1", "--for", "1s"), says="# "),
    "bench": Use(after=("--steps", "5", "--rounds", "1"), says="# "),
    "scaffold": Use(says="src/walker.aseme: 0 skeletons added\n"),
    "doctor": Use(says="sockets of a run, by transport\n"),
    "export": Use(before=("mermaid",), says="files: 1 "),
    "prove": Use(after=("--states", "20"), says="[2 robot; any delay"),
}
"""The commands that take a target."""
OTHERS = {
    *("new", "explain", "lsp", "key", "import", "completion", "match", "diff"),
    *("why", "whynot", "certificates", "deploy", "team status", "team switch", "team logs", "team stop"),
}
"""Those that take none, or two, or others before it: `team status` and its like are about what runs from an
output folder (-o)."""
FORMS = (
    "   hint: name a .aseme file, a project's folder or an output folder"
    " (or, for commands that read runs, a trace)\n"
)
TRACES = ("trace", "sniff", "replay", "observe", "coverage", "metrics")


@pytest.fixture(autouse=True)
def _views_end(monkeypatch: pytest.MonkeyPatch) -> None:
    def wait(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    monkeypatch.setattr(view.Watched, "wait", wait)
    monkeypatch.setattr("sys.stdin", io.StringIO())


def commands_of(group: click.Group) -> Iterator[tuple[str, click.Command]]:
    """The commands of a group by name, with those of the groups in it as `team status`."""
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        if isinstance(command, LazyGroup):
            yield from ((f"{name} {inner}", found) for inner, found in commands_of(command))
        else:
            yield name, command


def commands() -> Iterator[tuple[str, bool]]:
    """The name of each command, and whether it takes a target."""
    for name, command in commands_of(program):
        yield name, any(parameter.name in ("target", "targets") for parameter in command.params)


def test_every_command_is_known_here() -> None:
    assert {name for name, takes in commands() if takes} == USES.keys()
    assert {name for name, takes in commands() if not takes} == OTHERS


def use(here: Here, name: str, *target: object) -> Done:
    return here(*name.split(), *USES[name].before, *target, *USES[name].after)


@pytest.mark.parametrize("name", USES)
def test_a_target_has_the_same_forms_everywhere(here: Here, project: Path, name: str) -> None:
    """A file, a project's folder, an output folder, the project here; from elsewhere by the whole path."""
    assert here("run", "--for", "2s", "--allow", "waiting").code == 0
    for target in (["src/walker.aseme"], ["."], ["made"], []):
        done = use(here, name, *target)
        assert done.code == USES[name].code, (target, done)
        assert USES[name].says in done.out + done.err, (target, done)
    (project / "elsewhere").mkdir()
    os.chdir(project / "elsewhere")
    for target in ([project / "src/walker.aseme"], [project], [project / "made"], []):
        done = use(here, name, *target)
        assert done.code == USES[name].code, (target, done)


@pytest.mark.parametrize("name", USES)
def test_a_wrong_target_gives_one_text_everywhere(here: Here, project: Path, name: str) -> None:
    (project / "empty").mkdir()
    (project / "src/notes.txt").write_text("nothing")
    for target, text in (
        ("nowhere", f"nowhere: error[E001]: there is no file nowhere\n{FORMS}"),
        (
            "src/wolker.aseme",
            "src/wolker.aseme: error[E001]: there is no file src/wolker.aseme\n"
            "   hint: did you mean `walker.aseme`?\n",
        ),
        ("empty", f"empty: error[E001]: there is no .aseme file in empty\n{FORMS}"),
        ("", "Error: Invalid value for '[TARGET]"),
    ):
        done = use(here, name, target)
        assert done.code == (1 if target else 2), (target, done)
        assert text in done.out + done.err, (target, done)


@pytest.mark.parametrize("name", [name for name in USES if name not in TRACES])
def test_a_trace_is_no_source(here: Here, project: Path, name: str) -> None:
    (project / "some.jsonl").write_text("{}")
    done = use(here, name, "some.jsonl")
    assert done.code == 1
    assert "some.jsonl: error[E001]: some.jsonl is a trace, not a .aseme file\n" in done.out + done.err


@pytest.mark.parametrize("name", [name for name in USES if name not in (*TRACES, "doctor")])
def test_an_output_folder_whose_source_is_gone(here: Here, project: Path, name: str) -> None:
    assert here("build", "-o", "other", "--only", "models").code == 0
    (project / "src").rename(project / "moved")
    done = use(here, name, "other")
    assert done.code == 1
    assert "other: error[E020]: the source of this build, src/walker.aseme, cannot be found\n" in (
        done.out + done.err
    )


def test_a_build_that_makes_no_agents_is_an_output_folder_too(here: Here, project: Path) -> None:
    assert here("build", "-o", "other", "--only", "models").code == 0
    done = here("run", "other", "--for", "1s", "--allow", "waiting")
    assert (done.code, "trace: other/trace.jsonl.gz" in done.out) == (0, True), done


def test_what_is_made_of_an_output_folder_goes_there(here: Here, project: Path) -> None:
    assert here("build", "-o", "other").code == 0
    done = here("optimise", "other", *USES["optimise"].after)
    assert done.code == 0 and (project / "other/optimise/report.md").is_file(), done
    assert "Walker -> other: " in here("build", "other").out
    assert not (project / "made").exists()


def test_the_activities_of_an_output_folder_are_its_own(here: Here, project: Path) -> None:
    assert here("build", "-o", "other").code == 0
    activity = project / "other/monas/activities/walk.py"
    activity.write_text(activity.read_text() + "\ndef broken(:\n")
    assert here("check", "src/walker.aseme").code == 0
    assert "walk.py" in here("check", "other").out


def test_an_output_folder_may_be_moved_with_its_sources(here: Here, project: Path) -> None:
    assert here("build").code == 0
    (project / "there").mkdir()
    for name in ("src", "made", "pyproject.toml"):
        shutil.move(project / name, project / "there" / name)
    assert here("check", "there/made").out == "no problems found in 1 file\n"


def test_an_output_folder_behind_a_link(here: Here, project: Path, tmp_path: Path) -> None:
    (project / "disk/builds").mkdir(parents=True)
    (project / "made").symlink_to(project / "disk/builds")
    assert here("build").code == 0
    assert json.loads((project / "made/.asemec.json").read_text())["source"] == "../../src/walker.aseme"
    assert here("check", "made").out == "no problems found in 1 file\n"


def test_several_systems_of_one_output_folder(here: Here, folder: Path) -> None:
    (folder / "one.aseme").write_text(GOOD.replace("Walker\n", "One\n"))
    (folder / "two.aseme").write_text(GOOD.replace("Walker\n", "Two\n"))
    assert here("build", "one.aseme", "two.aseme").code == 0
    assert here("check", "out").out == "no problems found in 2 files\n"
    done = here("diagram", "out")
    assert done.code == 2 and "out contains 2 systems (one.aseme, two.aseme)" in done.err, done
    assert here("diagram", "out/Two", "-o", "drawn").code == 0


def test_without_a_project_the_output_folder_is_where_one_works(here: Here, folder: Path) -> None:
    (folder / "src").mkdir()
    (folder / "src/walker.aseme").write_text(GOOD)
    assert here("run", "src/walker.aseme", "--for", "2s", "--allow", "waiting").code == 0
    for target in ("src/walker.aseme", "src", "out"):
        assert here("trace", target).out.startswith("out/trace.jsonl.gz: Walker"), target


def test_two_sources_of_one_name_do_not_replace_each_other(here: Here, folder: Path) -> None:
    for name in ("one", "two"):
        (folder / name).mkdir()
        (folder / name / "main.aseme").write_text(GOOD.replace("Walker\n", f"{name.title()}\n"))
    assert here("build", "one/main.aseme").code == 0
    done = here("build", "two/main.aseme")
    assert done.code == 1 and "holds the build of One (from one/main.aseme)" in done.err, done


HOLES = GOOD.replace("Walk | Stand", "Walk ? Stand").replace(": else\n    leave", ": [?]\n    leave")
REFUSE_HOLES = USES.keys() - {"check", "fmt", "scaffold", "view", "doctor", *TRACES}
"""Those that would have to decide what is left open; `view` shows the problem on its page."""


@pytest.mark.parametrize("name", sorted(REFUSE_HOLES))
def test_what_is_left_open_is_refused(here: Here, project: Path, name: str) -> None:
    (project / "src/walker.aseme").write_text(HOLES)
    done = use(here, name)
    assert (done.code, done.out) == (1, "")
    assert "src/walker.aseme:5:28: error[E109]: an operator is still to be chosen here\n" in done.err
    assert not (project / "made").exists()


@pytest.mark.parametrize("name", sorted({"check", "fmt", "scaffold", "view", "doctor"}))
def test_what_is_left_open_is_noted_or_left_alone(here: Here, project: Path, name: str) -> None:
    (project / "src/walker.aseme").write_text(HOLES)
    done = use(here, name)
    assert done.code == USES[name].code, done
    assert "error" not in done.out + done.err
    assert ("note[E109]" in done.out) == (name == "check")
