"""Tools that others wrote read what is exported, without a warning."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.formats import Format, files_of
from aseme_dsl.interop.export.lowering import lowered
from aseme_dsl.interop.export.xstate import xstate
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.support.generated import system_of
from tests.support.node import packages

NODE = Path(__file__).with_name("node")
ROOT = Path(__file__).parents[3]
FILES = sorted((ROOT / "tests/acceptance").glob("*.aseme"))
DRAWINGS = "EXPORTED_DRAWINGS" in os.environ
"""Whether to ask tools that take long to install."""


def read(files: list[dict[str, str]], folder: Path, script: str) -> list[list[str]]:
    """What a tool says of each file."""
    made = packages(folder)
    shutil.copy(NODE / script, made)
    done = subprocess.run(
        ["node", str(made / script)],
        input=json.dumps(files),
        capture_output=True,
        text=True,
        timeout=300,
        check=True,
    )
    return [list(item) for item in json.loads(done.stdout)]


def exported(format_: Format, charts: int = 0) -> list[str]:
    """The texts of all charts of the acceptance files, and of random ones."""
    systems = [system_of(path.read_text("utf-8")) for path in FILES]
    systems += [system_of(text(Choices(seed))) for seed in range(charts)]
    found = []
    for system in systems:
        for chart in system.statecharts:
            files, _ = files_of(system, chart, format_)
            found += [made for _, made in files]
    return found


def test_a_modelling_tool_reads_processes() -> None:
    files = [{"bpmn": made} for made in exported(Format.BPMN, 30)]
    assert len(files) > 7
    assert read(files, NODE, "readers.cjs") == [[]] * len(files)


def test_the_module_for_xstate_has_no_type_errors() -> None:
    files = []
    for path in FILES:
        system = system_of(path.read_text("utf-8"))
        for chart in system.iacs:
            machine, refused = lowered(system, chart)
            if not refused:
                made = xstate(machine, "chart.json")
                files.append({"module": made.module, "config": made.config})
    assert len(files) == 2
    assert read(files, NODE, "readers.cjs") == [[], []]


def test_every_chart_of_the_papers_becomes_a_process() -> None:
    for path in FILES:
        system = system_of(path.read_text("utf-8"))
        for chart in system.statecharts:
            assert files_of(system, chart, Format.BPMN)[1] == ()


@pytest.mark.skipif(not DRAWINGS, reason="NOT TRIED here, but in the second lane")
def test_mermaid_reads_drawings() -> None:
    files = [{"mermaid": made} for made in exported(Format.MERMAID, 100)]
    assert read(files, NODE / "mermaid", "drawings.mjs") == [[]] * len(files)


@pytest.mark.skipif(not DRAWINGS, reason="NOT TRIED here, but in the second lane")
def test_plantuml_reads_drawings(tmp_path: Path) -> None:
    if shutil.which("plantuml") is None:
        pytest.skip("NOT TRIED, for there is no `plantuml` here: apt-get install plantuml")
    found = exported(Format.PLANTUML, 100)
    for number, made in enumerate(found):
        (tmp_path / f"{number}.puml").write_text(made, "utf-8")
    for name, made in (("whole.puml", found[0]), ("broken.puml", found[0].replace("state ", "state { ", 1))):
        (tmp_path / name).write_text(made, "utf-8")
    assert checked(["whole.puml"], tmp_path) == (0, "")
    assert checked(["broken.puml"], tmp_path)[0] != 0
    assert checked([f"{number}.puml" for number in range(len(found))], tmp_path) == (0, "")
    for made in found[:3]:
        done = subprocess.run(["plantuml", "-syntax"], input=made, capture_output=True, text=True, timeout=60)
        assert done.stdout.startswith("STATE"), done.stdout


@pytest.mark.skipif(not DRAWINGS, reason="NOT TRIED here, but in the second lane")
def test_plantuml_shows_the_names_of_composites(tmp_path: Path) -> None:
    if shutil.which("plantuml") is None:
        pytest.skip("NOT TRIED, for there is no `plantuml` here: apt-get install plantuml")
    system = system_of((ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8"))
    ((_, made),), _ = files_of(system, system.iacs[0], Format.PLANTUML)
    (tmp_path / "chart.puml").write_text(made, "utf-8")
    subprocess.run(["plantuml", "-tsvg", "chart.puml"], cwd=tmp_path, check=True, timeout=120)
    drawn = set(re.findall(r"<text[^>]*>([^<]*)</text>", (tmp_path / "chart.svg").read_text("utf-8")))
    names = set(re.findall(r'state "\w+" as (\w+)', made))
    assert names and not names & drawn


def checked(names: list[str], folder: Path) -> tuple[int, str]:
    """What PlantUML says of files: its exit code, and text about mistakes."""
    command = ["plantuml", "-checkonly", "-charset", "UTF-8", *names]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout + done.stderr


def test_what_processes_and_drawings_lack() -> None:
    system = system_of(
        "system S\nstatechart R {\n  state 0 OR\n  state 0.1 START\n  state 0.2 OR\n  state 0.2.1 START\n"
        "  state 0.2.2 BASIC A\n  state 0.3 BASIC B\n  0.1 -> 0.2 :\n  0.2.1 -> 0.2.2 :\n"
        "  0.2.2 -> 0.3 : go [true]\n}\n"
    )
    for format_, lacks in (
        (Format.MERMAID, {Foreign.CROSSING}),
        (Format.BPMN, {Foreign.CROSSING, Foreign.GUARDED_EVENTS}),
    ):
        files, refused = files_of(system, system.iacs[0], format_)
        assert files == ()
        assert {getattr(item.problem, "feature", None) for item in refused} == lacks
