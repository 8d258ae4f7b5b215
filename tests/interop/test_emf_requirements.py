"""Goals, use cases, protocols and roles of the ASEME IDE become `sag`, `suc`, `aip` and `srm` blocks."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.emf.report import Fate, as_markdown
from aseme_dsl.project.editing.import_models import import_models
from tests.conftest import Snapshot
from tests.interop.test_emf_charts import MODELS, chart, compiled, model, text_of

CLUB = [MODELS / f"club.{ending}" for ending in ("sag", "suc", "aip", "srm")]


def test_all_models_of_a_project_become_one_file(snapshot: Snapshot, tmp_path: Path) -> None:
    project = import_models(CLUB)
    assert not project.diagnostics
    snapshot(text_of(project), "club.aseme")
    assert set(compiled(project, tmp_path)) == {"singer", "bass_player"}


def test_the_report_of_requirements(snapshot: Snapshot) -> None:
    project = import_models(CLUB)
    places = tuple(f"{row.place.line}" if row.place else "" for row in project.rows)
    assert all(places)
    snapshot(as_markdown("Club", project.rows).replace(f"{MODELS}/", ""), "club.md")


def test_each_model_alone_is_a_project() -> None:
    for path in CLUB:
        project = import_models([path])
        assert not project.diagnostics and project.system == "Club"


def test_the_statechart_of_a_role_counts_and_the_role_keeps_what_it_needs(tmp_path: Path) -> None:
    states = '<Children name="Tune" label="0.2" type="BASIC"/><Children name="0.3" label="0.3" type="END"/>'
    moves = (
        '<transitions source="//@nodes.0/@Children.0" target="//@nodes.0/@Children.1"/>'
        '<transitions TE="[a.State.B.c()]" source="//@nodes.0/@Children.1" target="//@nodes.0/@Children.2"/>'
    )
    iac = model(tmp_path, chart(states, moves, "Singer").replace('"top"', '"song"'), "singer.stct")
    project = import_models([*CLUB, iac])
    text = text_of(project)
    assert not project.diagnostics, render_text(project.diagnostics)
    assert text.count("srm singer") == 1 and "leave Tune : [a.state.B.c]" in text
    assert 'capability entertain "Sings." = Rest' in text and "uses makes_sound_for_the_hall" in text
    assert any("the formulas of its statechart count" in row.now for row in project.rows)


def test_a_formula_that_is_wrong_is_a_comment(tmp_path: Path) -> None:
    text = (
        CLUB[3].read_text("utf-8").replace("Tune.follow", "Tune..follow").replace("unused=A.B", "lead=&lt;")
    )
    project = import_models([model(tmp_path, text, "club.srm")])
    assert not project.diagnostics
    assert "lead = <" in text_of(project)
    holes = [row.element for row in project.rows if row.fate is Fate.HOLE]
    assert any("bass-player" in element for element in holes)
    analysis = analyse("x.aseme", {"x.aseme": text_of(project)})
    assert analysis.system is not None, render_text(analysis.diagnostics)


def test_a_protocol_that_cannot_be_written_is_a_comment_and_keeps_no_other_model_away(tmp_path: Path) -> None:
    lines = CLUB[2].read_text("utf-8").replace("Count.(verse)+", "Count.^2")
    alone = '<protocols name="dance" participants="//@participants.2 //@participants.1"/></AIP:AIPmodel>'
    aip = model(tmp_path, lines.replace("</AIP:AIPmodel>", alone), "club.aip")
    project = import_models([*CLUB[:2], aip, CLUB[3]])
    assert not project.diagnostics, render_text(project.diagnostics)
    text = text_of(project)
    assert "// aip song {" in text and "// aip dance {" in text and "plays song" not in text
    assert set(compiled(project, tmp_path)) == {"singer", "bass_player"}
    holes = {row.element: row.now for row in project.rows if row.fate is Fate.HOLE}
    assert holes.keys() >= {"protocol song", "protocol dance", "participant dancer", "participant lead"}
    assert "has no process" in holes["protocol dance"]


def test_a_goal_without_an_actor_is_left_out(tmp_path: Path) -> None:
    text = CLUB[0].read_text("utf-8")
    text = text.replace("</SAG:", '<actors/><goals name="lost goal"/></SAG:')
    project = import_models([model(tmp_path, text, "club.sag")])
    assert "lost_goal" not in text_of(project)
    assert [row.element for row in project.rows if row.fate is Fate.LEFT_OUT] == [
        "goal orphan",
        "goal lost goal",
    ]
