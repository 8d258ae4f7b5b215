"""Statecharts of KSE and the ASEME IDE become roles with formulas, or statecharts state by state."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.emf.charts import ForeignChart, read_chart
from aseme_dsl.interop.emf.comparison import differences, other_names
from aseme_dsl.interop.emf.markup import read_markup
from aseme_dsl.interop.emf.report import Fate
from aseme_dsl.project.editing.import_models import ImportedProject, import_models, write_project
from aseme_dsl.source import Source
from tests.conftest import Snapshot

MODELS = Path(__file__).parent / "models"
CHANGED = int(os.environ.get("ASEME_CHANGED_MODELS", "20"))
"""How many changed files of each format are tried; the second lane tries 5 000."""

EMPTY = '<s:Model xmlns:s="http://statechart/1.0" name="Empty"/>'


def imported(*names: str) -> ImportedProject:
    return import_models([MODELS / name for name in names])


def text_of(project: ImportedProject) -> str:
    return next(content.decode() for name, content in project.files.items() if name.endswith(".aseme"))


def model(folder: Path, text: str, name: str = "model.stct") -> Path:
    path = folder / name
    path.write_text(text, "utf-8")
    return path


def chart(states: str, transitions: str = "", name: str = "m") -> str:
    """A model of two states around others: START, what is given, END."""
    return (
        f'<s:Model xmlns:s="http://statechart/1.0" name="{name}"><nodes name="top" label="0" type="OR">'
        f'<Children name="0.1" label="0.1" type="START"/>{states}</nodes>{transitions}</s:Model>'
    )


def compiled(project: ImportedProject, folder: Path) -> dict[str, Statechart]:
    """The statecharts of an imported project in which all holes are conditions that hold."""
    for name, content in project.files.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content.replace(b"[?]", b"[true]").replace(b" ? ", b" . "))
    analysis = analyse(next(folder.glob("*.aseme")))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    return {item.name: item for item in analysis.system.iacs}


def foreign(name: str) -> ForeignChart:
    return read_chart(read_markup(Source(name, (MODELS / name).read_text("utf-8"))))


@pytest.mark.parametrize("name", ["lamp.stct", "porter.iac", "clock.model"])
def test_each_generation_of_files_comes_over(name: str, tmp_path: Path, snapshot: Snapshot) -> None:
    project = imported(name)
    assert not project.diagnostics
    snapshot(text_of(project), f"{name}.aseme")
    (ours,) = compiled(project, tmp_path).values()
    assert list(differences(ours, foreign(name))) == []
    assert list(other_names(ours, foreign(name))) == []


@pytest.mark.parametrize("name", ["lamp.stct", "porter.iac", "clock.model"])
def test_the_report_has_every_element(name: str) -> None:
    rows = imported(name).rows
    theirs = foreign(name)
    places = [str(row.place) for row in rows]
    for place in [item.place for item in theirs.states] + [item.place for item in theirs.transitions]:
        assert any(known.endswith(f":{place.line}:{place.column}") for known in places)


def test_an_imported_project_checks_and_has_holes_where_nothing_was_decided(tmp_path: Path) -> None:
    write_project(imported("lamp.stct"), tmp_path)
    found = analyse(tmp_path / "lamp.aseme").diagnostics
    assert [item.code for item in found] == ["E109"], render_text(found)
    holes = [row for row in imported("lamp.stct").rows if row.fate is Fate.HOLE]
    assert len(holes) == 1 and "lampIsNew" in holes[0].element and "nothing declares" in holes[0].now


def test_messages_come_from_a_proto_file_and_constants_from_a_header(tmp_path: Path) -> None:
    path = model(tmp_path, (MODELS / "lamp.stct").read_text("utf-8"), "lamp.stct")
    proto = (
        'syntax = "proto2"; message Light { required int32 Mode = 1; } message Touch { optional bool x = 1; }'
    )
    model(tmp_path, proto, "room.proto")
    without = import_models([path])
    assert sum("name the header" in row.now for row in without.rows) == 3
    header = model(tmp_path, "// modes\nenum { MODE_OFF, MODE_ON };\n#define MODE_ECO 7\n", "modes.h")
    project = import_models([path, header])
    text = text_of(project)
    assert 'import "room.proto"' in text and "let MODE_ON  = 1" in text
    assert "room.state.Light.Mode == MODE_ON" in text and "message Sky" in text
    assert compiled(project, tmp_path / "new")
    assert any("has no field `on`" in row.now for row in project.rows)


def test_constants_with_their_message_are_those_of_the_proto_file(tmp_path: Path) -> None:
    model(tmp_path, 'syntax = "proto2"; message B { enum C { ON = 3; } optional C c = 1; }', "b.proto")
    states = '<Children name="Go" label="0.2" type="BASIC"/><Children name="0.3" label="0.3" type="END"/>'
    moves = (
        '<transitions source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.1"/>'
        '<transitions TE="[a.State.B.c()==B::%s]"'
        ' source="//@nodes.0/@Children.1" target="//@nodes.0/@Children.2"/>'
    )
    project = import_models([model(tmp_path, chart(states, moves % "ON"))])
    assert "a.state.B.c == B_C.ON]" in text_of(project)
    assert compiled(project, tmp_path / "new")
    other = import_models([model(tmp_path, chart(states, moves % "OFF"))])
    assert any("`B_C` has no constant `OFF`" in row.now for row in other.rows)


def test_several_models_are_one_project_with_the_modules_of_monas(tmp_path: Path) -> None:
    agents = model(
        tmp_path, "<agent ThreadFrequency=25><name>V</name><activity>Vision</activity></agent>", "a.xml"
    )
    project = import_models([MODELS / "porter.iac", MODELS / "clock.model", agents])
    assert not project.diagnostics
    assert set(compiled(project, tmp_path)) == {"hotel_porter", "Clock"}
    assert "Vision every 40ms" in text_of(project)


def test_the_last_guarded_transition_comes_first_as_in_monas(tmp_path: Path) -> None:
    states = '<Children name="Go" label="0.2" type="BASIC"/><Children name="0.3" label="0.3" type="END"/>'
    ends = 'source="//@nodes.0/@Children.1" target="//@nodes.0/@Children.'
    moves = (
        '<transitions source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.1"/>'
        f'<transitions TE="[a.State.B.c()==1]" {ends}1"/><transitions TE="[a.State.B.c()==2]" {ends}2"/>'
    )
    text = text_of(import_models([model(tmp_path, chart(states, moves))]))
    assert text.index("leave  Go : [a.state.B.c == 2]") < text.index("repeat Go : [a.state.B.c == 1]")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (EMPTY, "it has no state"),
        ("<a/>", "`<a>` is not a model"),
        ('<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>', "it has a document type"),
        ('<!DOCTYPE a SYSTEM "file:///etc/passwd"><a/>', "it has a document type"),
        ("<a>&x;</a>", "undefined entity"),
        ("<a><b></a>", "mismatched tag"),
        ("", "no element found"),
        ("<a>" * 300, "nested more than 200 deep"),
        (chart('<Children name="X" label="0.2" type="HISTORY"/>'), "`X` (0.2) has the type `HISTORY`"),
        (chart('<Children name="X" label="0.2"/>'), "`X` (0.2) has no type"),
        (chart('<Children name="A_or_B" label="0.2" type="OR"/>'), "has nothing inside"),
        (
            chart("", '<transitions name="t" source="//@nodes.0"/>'),
            "the target of the transition `t` is missing",
        ),
        (chart("", '<transitions source="//@nodes.9" target="//@nodes.0"/>'), "the source of the transition"),
        (
            chart("", '<transitions source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.0"/>'),
            "START",
        ),
        (
            '<s:Model xmlns:s="x"><nodes type="OR" Father_of="//@nodes.1"/>'
            '<nodes type="OR" Father_of="//@nodes.0"/></s:Model>',
            "is inside itself",
        ),
        ('<s:Model xmlns:s="x"><nodes type="OR"/><nodes type="OR"/></s:Model>', "2 states without a parent"),
    ],
)
def test_what_is_not_a_statechart_is_refused_with_its_place(text: str, says: str, tmp_path: Path) -> None:
    project = import_models([model(tmp_path, text)])
    (problem, *_) = project.diagnostics
    assert problem.code == "E220" and says in problem.message and not project.files
    assert problem.span is not None


def test_a_hole_of_a_state_with_states_inside_is_one_of_when(tmp_path: Path) -> None:
    """Monas leaves such a state before it is complete: so does the condition that is still to be written."""
    inside = '<Children label="0.2.1" type="START"/><Children name="A" label="0.2.2" type="BASIC"/>'
    states = f'<Children name="x" label="0.2" type="OR">{inside}</Children><Children label="0.3" type="END"/>'
    ends = 'source="//@nodes.0/@Children.1" target="//@nodes.0/@Children.2"'
    text = text_of(import_models([model(tmp_path, chart(states, f'<transitions TE="[late]" {ends}/>'))]))
    assert "0.2 -> 0.3 : when [?]" in text


def test_the_metadata_of_a_transition_is_listed(tmp_path: Path) -> None:
    moves = (
        '<transitions metadata="by hand" source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.1"/>'
    )
    states = '<Children name="A" label="0.2" type="BASIC"/>'
    project = import_models([model(tmp_path, chart(states, moves))])
    assert ("metadata of transition 0.1 -> `A` (0.2)", "by hand") in {
        (row.element, row.now) for row in project.rows if row.fate is Fate.LEFT_OUT
    }


def test_a_refused_model_does_not_keep_the_others_away(tmp_path: Path) -> None:
    project = import_models([model(tmp_path, EMPTY), MODELS / "clock.model"])
    assert [item.code for item in project.diagnostics] == ["E220"] and "statechart Clock" in text_of(project)


def test_an_existing_file_is_not_overwritten(tmp_path: Path) -> None:
    (tmp_path / "import-report.md").write_text("mine", "utf-8")
    project = write_project(imported("clock.model"), tmp_path)
    assert [item.code for item in project.diagnostics] == ["E009"] and project.created == ()
    assert [path.name for path in tmp_path.iterdir()] == ["import-report.md"]


@pytest.mark.parametrize(
    ("written", "here"),
    [
        ("[a.State.B.c()]", "[a.state.B.c]"),
        ("[!a.State.B.c()]", "[!a.state.B.c]"),
        ("[!(a.State.B.c()>3 and a.Data.D.e()<0.5)]", "[!(a.state.B.c > 3 && a.data.D.e < 0.5)]"),
        ("[NULL != a.State.B or not f(a.State.B)]", "[has(a.state.B) || !f(a.state.B)]"),
        ("[_a.State.B.c()!=-2]", "[!has(a.state.B) || a.state.B.c != -2]"),
        ("[_a.State.B.c()==1 && f(3)]", "[(!has(a.state.B) || a.state.B.c == 1) && f(3)]"),
        (
            "[a.State.B.c()==ON]/publish.a.Signal.S.set_v(ON)",
            "C.ON] / a.signal.S.v = C.ON; write_messages.a.signal.S",
        ),
        ("[a.State.B.c()==messages::Mode::ON]", "[a.state.B.c == C.ON]"),
        ("go[a.State.B.c()=='x']", None),
        ("go[a.State.B.c()==2]/publish_all", "go [a.state.B.c == 2]"),
        ("go", "go"),
        (
            "[TimeoutCheck(t)]/TimeoutAction.t.1500;process_messages",
            "[expired(t)] / start_timer(t, 1500ms); read_messages",
        ),
        ("[false]", "[false]"),
        ("[a.State.B.c()+1 == 2]", None),
        ("[std::f(1)]", None),
        ("[a.State.B.c()==2", None),
        ("[a.State.B.c()==2]/beep", None),
        ("[]", None),
        ("[a.state.if.c()==2]", None),
        ("[signal.State.B.c()==2]", None),
        ("[" + "(" * 500 + "]", None),
    ],
)
def test_expressions_of_kse(written: str, here: str | None, tmp_path: Path) -> None:
    states = '<Children name="Go" label="0.2" type="BASIC"/><Children name="0.3" label="0.3" type="END"/>'
    escaped = written.replace("&", "&amp;").replace("<", "&lt;")
    moves = (
        '<transitions source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.1"/>'
        f'<transitions TE="{escaped}" source="//@nodes.0/@Children.1" target="//@nodes.0/@Children.2"/>'
    )
    project = import_models([model(tmp_path, chart(states, moves))])
    assert not project.diagnostics
    line = text_of(project)
    if here is None:
        assert "// KSE: " in line and "leave Go : [?]" in line
    else:
        assert here in " ".join(line.split()), line
    assert compiled(project, tmp_path / "new")


FILES = {path.name: path.read_text("utf-8") for path in sorted(MODELS.iterdir())}


@pytest.mark.parametrize("name", FILES)
@settings(max_examples=CHANGED, deadline=None)
@given(data=st.data())
def test_changed_files_are_imported_or_refused(
    name: str, data: st.DataObject, tmp_path_factory: pytest.TempPathFactory
) -> None:
    text = FILES[name]
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(text)))
        length = data.draw(st.sampled_from([0, 1, 2, 5, 30, 200]))
        pieces = [
            "",
            '"',
            "<",
            ">",
            "&",
            "/",
            ".",
            "[",
            "]",
            "(",
            "0.2",
            "END",
            "OR",
            "null",
            "//@nodes.0",
            "\x00",
            "é",
        ]
        copied = data.draw(st.integers(0, len(text)))
        put = data.draw(st.sampled_from([*pieces, text[copied : copied + length]]))
        text = text[:at] + put + text[at + length :]
    folder = tmp_path_factory.mktemp("changed")
    project = import_models([model(folder, text, name)])
    if project.files:
        compiled(project, folder / "new")
    else:
        assert project.diagnostics
