"""`asemec export` as a user meets it: files, refusals with places, and names that are dangerous elsewhere."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import pytest

from aseme_dsl.cli.program import run_program
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.export.formats import Format, files_of
from tests.support.generated import system_of

LAMP = """\
system Lamp
message Light { string colour  int level }
topic room { state Light }
srm lamp {
  var used : int = 0
  liveness { lamp = (Dark . Shine)+ }
  control lamp {
    enter Shine : touched or after(2s) [room.state.Light.colour != "a\\"<b>&--%"] / used = used + 1
    repeat (Dark . Shine) : [used < 3]
    leave (Dark . Shine) : else
  }
}
"""
SIGNALS = LAMP.replace("state Light", "signal Light").replace("room.state", "room.signal")


def exported(text: str, format_: Format) -> dict[str, str]:
    system = system_of(text)
    files, refused = files_of(system, system.iacs[0], format_)
    assert not refused, render_text(refused)
    return dict(files)


@pytest.fixture
def lamp(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "lamp.aseme"
    path.write_text(LAMP, encoding="utf-8")
    return path


def test_strings_of_the_document_stay_strings() -> None:
    (document,) = exported(LAMP, Format.SCXML).values()
    conditions = [item.get("cond") or "" for item in ET.fromstring(document).iter()]
    assert any(r'"a\"<b>&--%"' in condition for condition in conditions)
    config, module = exported(LAMP, Format.XSTATE).values()
    assert json.loads(config)["type"] == "parallel"
    assert r'"a\"<b>&--%"' in module


def test_names_that_a_format_does_not_have_are_noted_with_their_place(
    lamp: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = LAMP.replace("  liveness", "  let low = used < 3\n  liveness").replace("[used < 3]", "[low]")
    lamp.write_text(text, "utf-8")
    note = "lamp.aseme:10:30: `let low` is written out where it is used"
    for format_ in ("scxml", "xstate", "sismic"):
        assert run_program(["export", format_, "lamp.aseme"]) == 0
        assert capsys.readouterr().err == f"note: {note}\n"
    assert run_program(["export", "scxml", "lamp.aseme", "-o", "-"]) == 0
    assert capsys.readouterr().err == f"note: {note}\n"
    assert run_program(["export", "scxml", "lamp.aseme", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["remarks"] == [note]
    assert run_program(["export", "mermaid", "lamp.aseme"]) == 0
    assert capsys.readouterr().err == ""


def test_a_composite_of_plantuml_has_its_name_where_its_inside_is() -> None:
    """PlantUML forgets a name where the state stands once more without it."""
    (drawing,) = exported(LAMP, Format.PLANTUML).values()
    lines = [line.strip() for line in drawing.splitlines()]
    assert 'state "lamp" as lamp_0 {' in lines
    assert not [
        line for line in lines if line.startswith("state ") and line.endswith("{") and '"' not in line
    ]


def test_drawings_and_processes_escape_what_is_written() -> None:
    (drawing,) = exported(LAMP, Format.MERMAID).values()
    assert "#34;a#92;#34;#60;b#62;#38;#45;#45;#37;#34;" in drawing
    (drawing,) = exported(LAMP, Format.PLANTUML).values()
    assert '"a\\"<b>' not in drawing
    text = LAMP.replace("touched or after(2s) [room", "when [room")
    (process,) = exported(text, Format.BPMN).values()
    assert any(item.text and "<b>&--%" in item.text for item in ET.fromstring(process).iter())


def test_names_that_mean_something_elsewhere_are_only_names() -> None:
    text = "system S\nsrm R { liveness { R = done . scxml . In . constructor . __proto__ . class } }\n"
    (document,) = exported(text, Format.SCXML).values()
    states = [item.get("id") or "" for item in ET.fromstring(document).iter() if item.get("id")]
    assert len(states) == len(set(states))
    assert "constructor_0_5" in states


def test_a_name_from_an_older_model_is_escaped() -> None:
    """Names of states may be any text once a chart was not compiled but made."""
    system = system_of(LAMP.replace("touched or after(2s) [room", "when [room"))
    chart = system.iacs[0]
    odd = 'a"<b>\u2028--\x00 */ ${x} ω'
    states = (replace(state, name=odd) if state.type == "BASIC" else state for state in chart.states)
    made = replace(chart, states=tuple(states))
    for format_ in Format:
        for name, text in files_of(system, made, format_)[0]:
            assert "\x00" not in text
            if name.endswith((".scxml", ".bpmn", ".stct")):
                ET.fromstring(text)


def test_the_same_text_gives_the_same_bytes() -> None:
    for format_ in Format:
        lamp = LAMP.replace("touched or after(2s) [room", "when [room")
        if format_ is Format.STCT:
            lamp = "system Lamp\nsrm lamp { liveness { lamp = (Dark . Shine)+ } }\n"
        assert exported(lamp, format_) == exported(lamp, format_)
        assert all("asemec export" in text for text in exported(lamp, format_).values())


def test_what_engines_lack_is_an_error_with_its_place(
    lamp: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    lamp.write_text(SIGNALS, encoding="utf-8")
    assert run_program(["export", "scxml", "lamp.aseme"]) == 1
    assert "lamp.aseme:8:41: error[E323]: scxml cannot express this of `lamp`" in capsys.readouterr().err
    assert not (tmp_path / "export").exists()


def test_an_argument_that_may_be_absent_would_fail_its_state() -> None:
    system = system_of(
        "system S\nmessage Place { int x }\ntopic t { state Place }\nsrm R {\n"
        "  liveness { R = Go(t.state.Place.x) . Stay(3) }\n  activities { Go(x : int)  Stay(x : int) }\n}\n"
    )
    files, refused = files_of(system, system.iacs[0], Format.SCXML)
    assert files == ()
    assert [item.message for item in refused] == [
        "scxml cannot express this of `R`: what an activity is given, where it may be absent"
    ]


def test_a_timer_that_nothing_starts_is_declared() -> None:
    """Engines take a name without a datum for an error, and look again for ever."""
    text = LAMP.replace("touched or after(2s) [room", "when [expired(pace) && room")
    (document,) = exported(text, Format.SCXML).values()
    assert '<data id="timer_pace_0" expr="false"/>' in document


def test_a_file_of_the_user_stays(lamp: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own = lamp.parent / "export" / "iac.lamp.scxml"
    own.parent.mkdir()
    own.write_text("mine")
    assert run_program(["export", "scxml", "lamp.aseme"]) == 1
    assert "E009" in capsys.readouterr().err
    assert own.read_text() == "mine"
    assert run_program(["export", "scxml", "lamp.aseme", "--force"]) == 0
    assert own.read_text().startswith("<?xml")
    assert run_program(["export", "scxml", "lamp.aseme"]) == 0


def test_one_file_is_printed(lamp: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert run_program(["export", "scxml", "lamp.aseme", "--chart", "lamp", "-o", "-"]) == 0
    assert capfdbinary.readouterr().out.startswith(b"<?xml")


@pytest.mark.parametrize(
    "arguments",
    (["xstate", "lamp.aseme", "--datamodel", "python"], ["scxml", "lamp.aseme", "--chart", "lam"], ["gif"]),
)
def test_wrong_use(lamp: Path, arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run_program(["export", *arguments]) == 2
    assert "Error: " in capsys.readouterr().err
