"""Machines that are written oddly: each is imported, or refused with the place, and nothing is mixed up."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from aseme_dsl.compiler import Analysis
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.files import ForeignNotRead
from aseme_dsl.project.editing import import_machines
from aseme_dsl.project.editing.import_models import ImportedProject, import_models
from aseme_dsl.source import Source, Span
from tests.interop.machines.playing import Player, imported

PARALLEL = '<state id="a"><transition event="go" target="c e"/></state><parallel id="p">{}</parallel>'


def scxml(states: str, data: str = "") -> str:
    return f'<scxml version="1.0" name="m"><datamodel>{data}</datamodel>{states}</scxml>'


def project(folder: Path, **files: str) -> ImportedProject:
    """What several files become together."""
    for name, text in files.items():
        (folder / f"{name}.scxml").write_text(text, "utf-8")
    return import_models([folder / f"{name}.scxml" for name in files])


@pytest.mark.parametrize("initial", ["r", "p", "a", "d", "c e"])
def test_a_state_may_say_wrongly_where_it_begins(initial: str) -> None:
    regions = (
        f'<state id="r" initial="{initial}"><state id="b"/><state id="c"/></state>'
        '<state id="d"><state id="e"/></state>'
    )
    found = imported("m.scxml", scxml(PARALLEL.format(regions)))
    assert any("r" in item and "begins" in item for item in found.lost), found.lost


def test_states_without_a_name_are_different_ones() -> None:
    found = imported(
        "m.scxml", scxml('<state><transition event="e" target="b"/></state><state/><state id="b"/>')
    )
    player = Player(found)
    assert len({item.id for item in found.plan.machine.nodes()}) == 4
    assert player.active() == [{found.plan.machine.root.children[0].id}]
    player.send("e")
    assert player.active() == [{"b"}]
    named = imported("m.scxml", scxml('<state/><state id="state 1"/><state/>'))
    assert len({item.id for item in named.plan.machine.nodes()}) == 4


def test_the_machine_itself_has_a_name_of_its_own() -> None:
    states = {"light machine": {"on": {"e": "other"}}, "other": {}}
    said = {"id": "light", "initial": "light machine", "on": {"e": ".other"}, "states": states}
    player = Player(imported("m.json", json.dumps(said)))
    player.send("e")
    assert player.active() == [{"other"}]


def test_a_machine_that_is_refused_leaves_the_others(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The compiler refuses no state today: a diagnostic on the line of one stands for it."""
    real = import_machines.analyse

    def refusing(root: Path) -> Analysis:
        analysis = real(root)
        source = Source(str(root), root.read_text("utf-8"))
        start = source.text.find("state 0.2 BASIC bad")
        if start < 0:
            return analysis
        wrong = Diagnostic(ForeignNotRead("m", "no"), Span(source, start, start + 5))
        return replace(analysis, diagnostics=(*analysis.diagnostics, wrong))

    monkeypatch.setattr(import_machines, "analyse", refusing)
    found = project(tmp_path, good=scxml('<state id="a"/>'), bad=scxml('<state id="bad"/>'))
    assert [item.span.source.path for item in found.diagnostics if item.span is not None] == [
        str(tmp_path / "bad.scxml")
    ]
    assert b"statechart m {" in found.files["m.aseme"]


def test_null_is_a_value_of_a_machine() -> None:
    found = imported(
        "m.scxml",
        scxml(
            '<state id="a"><transition event="e" target="a">'
            '<assign location="n" expr="null">7</assign></transition></state>',
            '<data id="n" expr="1"/>',
        ),
    )
    assert any(item.startswith("n = null") for item in found.lost), found.lost


def test_prefixes_say_to_which_namespace_an_element_belongs() -> None:
    found = imported(
        "m.scxml",
        '<sc:scxml xmlns:sc="http://www.w3.org/2005/07/scxml" xmlns:qt="http://qt" version="1.0" name="m">'
        '<sc:state id="a" qt:initial="b">'
        '<sc:transition event="e" target="b" qt:cond="x"/><qt:part/></sc:state>'
        '<sc:state id="b"/></sc:scxml>',
    )
    player = Player(found)
    player.send("e")
    assert player.active() == [{"b"}]
    assert any("qt:part" in row.element or "part" in row.element for row in found.rows)


def test_two_activities_are_not_one() -> None:
    def invokes(name: str) -> str:
        return f'<invoke id="{name}"/>'

    found = imported(
        "m.scxml",
        scxml(
            f'<state id="a">{invokes("go home")}<transition event="e" target="b"/></state>'
            f'<state id="b">{invokes("go_home")}<transition event="e" target="c"/></state>'
            f'<state id="c">{invokes("go home")}</state>'
        ),
    )
    states = [line.split() for line in found.text.splitlines() if " BASIC " in line]
    performed = [words[words.index("activity") + 1] for words in states]
    assert performed[0] == performed[2] != performed[1]
