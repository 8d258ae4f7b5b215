"""An expression that was copied from KSE is one error, with its translation, which `--fix` writes."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.cli.program import run_program
from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source

TEXT = """\
system Door
enum Mode {{ OFF ON }}
message Visitor {{ bool present  Mode mode  int steps }}
topic door {{ state Visitor  signal Visitor }}
let MOST = 7
let NEAR = true
srm keeper {{
  var seen : int = 0
  liveness {{ keeper = (look | Rest)~  look = Turn . Stare }}
  control keeper {{
    enter look : [!has(door.state.Visitor)] // NULL
    {line}
    enter Rest : else
  }}
  activities {{ Turn takes 1s  Stare takes 1s  Rest takes 1s }}
}}
"""


def found(line: str) -> list[tuple[str, str | None, str | None]]:
    analysis = analyse(Source("door.aseme", TEXT.format(line=line)))
    return [(item.code, item.fix, item.hint) for item in analysis.diagnostics if item.severity == "error"]


@pytest.mark.parametrize(
    ("line", "here"),
    [
        (
            "repeat (look | Rest) : [TimeoutCheck(t)]/TimeoutAction.t.250",
            "when [expired(t)] / start_timer(t, 250ms)",
        ),
        ("leave look : [door.State.Visitor==NULL]", "when [!has(door.state.Visitor)]"),
        ("leave Rest : [door.State.Visitor.mode() == ON]", "[door.state.Visitor.mode == Mode.ON]"),
        ("leave Rest : when [NULL != door.Signal.Visitor]", "when [has(door.signal.Visitor)]"),
        (
            "leave Rest : [door.state.Visitor.steps() > MOST && seen == 2]",
            "[door.state.Visitor.steps > MOST && seen == 2]",
        ),
        (
            "leave Rest : [boost::posix_time::from_iso_string(t.State.TimeoutMsg.wakeup())"
            "<boost::posix_time::microsec_clock::local_time()]",
            "[expired(t)]",
        ),
        ("leave Rest : [NEAR && TimeoutCheck(t)]", "[NEAR && expired(t)]"),
        ("leave Rest : [true]/process_messages;publish_all", "[true] / read_messages"),
        (
            "leave Rest : /publish.door.Signal.Visitor.set_steps(3)",
            "/ door.signal.Visitor.steps = 3; write_messages.door.signal.Visitor",
        ),
        (
            "leave Rest :\n      [!door.State.Visitor.present()\n       && TimeoutCheck(t)]",
            "[!door.state.Visitor.present && expired(t)]",
        ),
    ],
)
def test_an_expression_of_kse_is_translated(line: str, here: str) -> None:
    assert found(line) == [("E118", here, f"here it is {here}")]
    assert found(f"{line.partition(':')[0]}: {here}") == []


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("leave Rest : [TimeoutCheck(t) && late == 3]", "nothing declares `late`"),
        ("leave Rest : [door.State.Visitor.mode() == AUTO]", "`Mode` has no constant `AUTO`"),
        ("leave Rest : [door.State.Visitor.steps()+1 > 2]", "it computes (`+`)"),
        ("leave Rest : [door.State.Visitor.size()]", "has no field `size`"),
        ("leave Rest : [TimeoutCheck(t)", "the condition has no `]`"),
    ],
)
def test_what_cannot_be_translated_says_why(line: str, why: str) -> None:
    ((code, fix, hint),) = found(line)
    assert (code, fix) == ("E118", None) and hint is not None and why in hint


@pytest.mark.parametrize(
    "line",
    [
        "leave Rest : [door.state.Visitor.step > 2]",
        "leave Rest : [nothing]",
        "leave Rest : [f(1)]",
        "leave Rest : [door.state.Signal.x]",
    ],
)
def test_other_mistakes_are_what_they_were(line: str) -> None:
    assert found(line) and "E118" not in [code for code, _, _ in found(line)]


def test_a_state_of_a_statechart_is_left_as_in_monas() -> None:
    text = (
        "system S\ntopic t { state M }\nmessage M { bool on }\nstatechart c {\n  state 0 OR\n"
        "  state 0.1 START\n  state 0.2 OR\n  state 0.2.1 START\n  state 0.2.2 BASIC A\n  state 0.3 END\n"
        "  0.1 -> 0.2 : /TimeoutAction.p.5\n  0.2.1 -> 0.2.2 :\n  0.2 -> 0.3 : [t.State.M.on()]\n}\n"
    )
    errors = [item for item in analyse(Source("s.aseme", text)).diagnostics if item.severity == "error"]
    assert [item.fix for item in errors] == ["/ start_timer(p, 5ms)", "when [t.state.M.on]"]


def test_the_file_is_mended_and_what_was_changed_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "door.aseme"
    path.write_text(TEXT.format(line="leave look : [door.State.Visitor==NULL]  // as there"), "utf-8")
    assert run_program(["check", "--fix", str(path)]) == 0
    said = capsys.readouterr()
    assert (
        "fixed[E118]: `[door.State.Visitor==NULL]` -> `when [!has(door.state.Visitor)]`"
        in said.out + said.err
    )
    assert path.read_text("utf-8") == TEXT.format(
        line="leave look : when [!has(door.state.Visitor)]  // as there"
    )


def test_a_line_by_labels_with_several_targets_is_looked_at() -> None:
    text = """system Door
message Visitor { bool present }
topic door { state Visitor }
statechart keeper {
  state 0 OR  state 0.1 START  state 0.2 AND
  state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC Look
  state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC Turn
  0.1 -> (0.2.1.2, 0.2.2.2) : [door.State.Visitor!=NULL]
  0.2 -> (0.2.1.2, 0.2.2.2) : [door.State.Visitor==NULL]  // NULL
  0.2.1.1 -> 0.2.1.2 :
  0.2.2.1 -> 0.2.2.2 :
}
"""
    found = analyse(Source("door.aseme", text)).diagnostics
    assert [(item.code, item.fix) for item in found if item.severity == "error"] == [
        ("E118", "[has(door.state.Visitor)]"),
        ("E118", "when [!has(door.state.Visitor)]"),
    ]
