"""Monas' agents.xml becomes a `modules` block."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.monas_agents import modules_of
from aseme_dsl.project.editing.import_models import ImportedProject, import_models, write_project
from aseme_dsl.project.files.foreign import imported_modules
from aseme_dsl.source import Source
from tests.interop.test_emf_charts import MODELS

TEXT = """<?xml version="1.0"?>
<agents>
  <!-- as in Monas -->
  <agent IsRealTime="0" Priority="0" ThreadFrequency="25" StatsCycle="200" Enable="1">
    <name>KVision</name>
    <activity Enable="1">Vision</activity>
    <activity>LocalWorldState</activity>
    <activity Enable="0">Behavior</activity>
  </agent>
  <agent><ThreadFrequency>30</ThreadFrequency><name>Head</name><activity>HeadController</activity></agent>
  <agent ThreadFrequency="0"><name>Planning</name><activity>PathPlanning</activity></agent>
  <provider ThreadFrequency="10">Sensors</provider>
  <provider>LedHandler</provider>
  <provider ThreadFrequency="10">Sensors</provider>
  <statechart Enable="1">Goalie</statechart>
  <statechart Enable="0">Tester</statechart>
</agents>
"""
MODULES = """modules {
  // statecharts: Goalie, Tester (switched off)
  // agent KVision
  Vision every 40ms
  LocalWorldState every 40ms
  // Behavior every 40ms  (switched off)
  // agent Head
  HeadController every 33.333333ms
  // agent Planning
  // PathPlanning
  // provider Sensors
  Sensors every 100ms
  // provider LedHandler
  // LedHandler
  // provider Sensors
}
"""


def test_agents_and_providers_become_modules_of_their_frequency() -> None:
    text, found = modules_of(Source("agents.xml", TEXT))
    assert text == MODULES
    assert [(item.code, item.message) for item in found] == [
        ("W111", "`Planning` runs without a pause (frequency 0): a module has a period"),
        ("W111", "`LedHandler` has no frequency"),
        ("W110", "the module `Sensors` is there a second time: it is left out"),
    ]


def test_the_block_is_what_an_srm_takes() -> None:
    text, _ = modules_of(Source("agents.xml", TEXT))
    analysis = analyse(Source("a.aseme", f"system S srm robot {{ liveness {{ robot = Walk }} {text} }}"))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    names = [item.name for item in analysis.system.srms[0].modules]
    assert names == ["Vision", "LocalWorldState", "HeadController", "Sensors"]


# The form of the files that the robots had: no root, and attributes with or without quotes.
SEVERAL_ROOTS = """<?xml version="1.0" ?>
<!-- What runs beside -->
<agent IsRealTime=1 Priority=1 ThreadFrequency=50 StatsCycle=1000>
\t<name>Motion</name>
\t<activity>Walker</activity>
\t<activity Enable=0>Kicker</activity>
</agent>

<agent IsRealTime="1" ThreadFrequency='5' Enable="1">
\t<name>Sharing</name>
\t\t<activity Enable="1">SharedModel</activity>
</agent>
<provider IsRealTime="1" ThreadFrequency="10" Enable="1">Sensors</provider>

<statechart Enable="0">Keeper</statechart>
"""


def test_several_roots_and_values_without_quotes_are_read() -> None:
    text, found = modules_of(Source("agents.xml", SEVERAL_ROOTS))
    assert (
        text
        == """modules {
  // statecharts: Keeper (switched off)
  // agent Motion
  Walker every 20ms
  // Kicker every 20ms  (switched off)
  // agent Sharing
  SharedModel every 200ms
  // provider Sensors
  Sensors every 100ms
}
"""
    )
    assert found == ()


def test_a_problem_after_the_first_root_has_its_place() -> None:
    text, (problem,) = modules_of(Source("agents.xml", SEVERAL_ROOTS.replace("Sharing</name>", "Sharing")))
    assert (text, problem.code) == ("", "E220")
    assert "`</agent>` does not close `<name>`" in problem.message
    assert problem.span is not None and problem.span.text == "</agent>"
    assert str(problem.span).startswith("agents.xml:12:")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "has no agent"),
        ("<agents>", "`<agents>` is not closed"),
        ("<agents></agent>", "`</agent>` does not close `<agents>`"),
        ("<agent/></agent>", "`</agent>` closes nothing"),
        ("<agent>a</agent b='c'>", "the tag `</agent` is not closed"),
        ("<agent Enable=>a</agent>", "the tag `<agent` is not closed"),
        ("<agent>a</agent><!-- b", "`<!--` is not closed by `-->`"),
        ("<agent>a < b</agent>", "a name is missing after `<`"),
        ("<agent>a & b</agent>", "begins no character reference"),
        ("<agent>&#x110000;</agent>", "begins no character reference"),
        ("<html><body/></html>", "is not a configuration of Monas"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><agents>&b;</agents>', "it has a document type"),
        ('<agent/><!DOCTYPE a SYSTEM "/etc/passwd">', "it has a document type"),
        ("<a>" * 5000, "nested more than 100 deep"),
    ],
)
def test_what_cannot_be_read_is_said(text: str, says: str) -> None:
    block, (problem,) = modules_of(Source("agents.xml", text))
    assert block == "" and problem.code == "E220" and says in problem.message


def test_a_name_ends_no_comment() -> None:
    name = "Head\n}\nsrm evil { liveness { evil = A } }\u2028\x1b[2J"
    text, _ = modules_of(Source("agents.xml", f"<agent ThreadFrequency=1><name>{name}</name></agent>"))
    assert len(text.splitlines()) == 3 and "\x1b" not in text


def project_of(folder: Path, *models: Path) -> ImportedProject:
    """The project of models and the `agents.xml` with `TEXT`, compiled into `folder`."""
    agents = folder / "agents.xml"
    agents.write_text(TEXT, "utf-8")
    project = write_project(import_models([*models, agents]), folder / "out")
    assert [item.code for item in project.diagnostics] == ["W111", "W111", "W110"]
    return project


def named(project: ImportedProject) -> dict[str, list[str]]:
    analysis = analyse(next(path for path in project.created if path.suffix == ".aseme"))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    return {role.name: [item.name for item in role.modules] for role in analysis.system.srms}


NAMES = ["Vision", "LocalWorldState", "HeadController", "Sensors"]


def test_alone_in_a_directory_they_become_a_project_that_checks(tmp_path: Path) -> None:
    project = project_of(tmp_path)
    assert named(project) == {"robot": NAMES}
    assert [(row.fate.value, row.element) for row in project.rows] == [
        ("added", "role robot"),
        ("taken over", "module Vision"),
        ("taken over", "module LocalWorldState"),
        ("left out", "module Behavior"),
        ("taken over", "module HeadController"),
        ("left out", "module PathPlanning"),
        ("taken over", "module Sensors"),
        ("left out", "module LedHandler"),
        ("left out", "module Sensors"),
        ("left out", "statechart Goalie"),
        ("left out", "statechart Tester"),
    ]
    assert all(row.place is not None for row in project.rows[1:])


@pytest.mark.parametrize("files", [("club.srm",), ("club.sag",), ("club.suc",)])
def test_beside_requirements_a_role_gets_the_modules(files: tuple[str, ...], tmp_path: Path) -> None:
    roles = named(project_of(tmp_path, *(MODELS / name for name in files)))
    assert [name for name, modules in roles.items() if modules == NAMES] == (
        ["singer"] if "club.srm" in files else ["robot"]
    )


def test_what_means_nothing_is_said() -> None:
    _, found = modules_of(Source("agents.xml", "<agent ThreadFrequency=1>A</agent> b <Colour>red</Colour>"))
    assert [(item.code, item.message) for item in found] == [
        ("W110", "there is text between the elements: it is left out"),
        ("W110", "`<Colour>` means nothing here: it is left out"),
    ]


@pytest.mark.parametrize(
    "unit",
    [
        "<a/>",
        "<!--",
        "<agent>",
        "&",
        "<agent ",
        "\n",
        "a=b ",
        "</a>",
        "<![CDATA[]]>",
        "<agent ThreadFrequency=1>A</agent>",
    ],
)
def test_a_long_text_takes_work_in_proportion(unit: str) -> None:
    """Of many characters: what takes the square of that would not come to an end."""
    block, found = modules_of(Source("agents.xml", unit * (200_000 // len(unit))))
    assert block or found


@given(st.text(alphabet="<>/agentprovider ='\"&;é\x00\n0123", max_size=80))
def test_no_text_is_too_strange(text: str) -> None:
    block, found = modules_of(Source("agents.xml", text))
    assert block or found


def test_a_file_without_end_is_not_read(tmp_path: Path) -> None:
    pipe = tmp_path / "agents.xml"
    os.mkfifo(pipe)
    text, (problem,) = imported_modules(pipe)
    assert (text, problem.code) == ("", "E001")
    large = tmp_path / "large.xml"
    large.write_text(" " * 1_000_001, "utf-8")
    text, (problem,) = imported_modules(large)
    assert (text, problem.code, problem.hint) == ("", "E003", None)
