"""Transitions into several regions of an AND: written with all targets, or refused with their place."""

from __future__ import annotations

import json

import pytest

from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.formats import Format, files_of
from tests.interop.exports.engines import differences, on_javascript, python_statemachine
from tests.interop.exports.playing import Recorder, Recording
from tests.oracle.choices import Choices
from tests.oracle.examples import forget
from tests.support.generated import generate, system_of

TEXT = """\
system S
statechart c {
  state 0 OR  state 0.1 START  state 0.2 BASIC A  state 0.4 END
  state 0.3 AND
  state 0.3.1 OR  state 0.3.1.1 START  state 0.3.1.2 BASIC B  state 0.3.1.3 BASIC C
  state 0.3.2 OR  state 0.3.2.1 START  state 0.3.2.2 BASIC D  state 0.3.2.3 BASIC E
  state 0.3.3 OR  state 0.3.3.1 START  state 0.3.3.2 BASIC F  state 0.3.3.3 BASIC G
  0.1 -> 0.2 :  0.3.1.1 -> 0.3.1.2 :  0.3.2.1 -> 0.3.2.2 :  0.3.3.1 -> 0.3.3.2 :
  0.2 -> (0.3.1.3, 0.3.2.3) : go
  0.3.1.3 -> (0.3.1.2, 0.3.3.3) : hop
  0.3.1.2 -> 0.2 : stop
  0.3 -> (0.3.2.3, 0.3.3.3) : stop
}
team T { me : c }
"""


def recordings() -> list[Recording]:
    made = generate(TEXT)
    found = []
    for seed in range(8):
        recorder = Recorder(made, "c")
        assert recorder.refused == ()
        found.append(recorder.record(Choices(f"several {seed}")))
    forget(made)
    assert {"C_0_3_1_3", "E_0_3_2_3"} <= {name for one in found for step in one.steps for name in step.active}
    return found


def test_engines_enter_the_same_states() -> None:
    found = recordings()
    played = [*on_javascript(found).values()]
    pytest.importorskip("statemachine", reason="NOT TRIED, for there is no python-statemachine here")
    played.append([python_statemachine(one) for one in found])
    for engine in played:
        assert [differences(one, theirs) for one, theirs in zip(found, engine, strict=True)] == [[]] * 8


def test_all_targets_are_written() -> None:
    system = system_of(TEXT)
    (document,) = files_of(system, system.iacs[0], Format.SCXML)[0]
    assert 'target="C_0_3_1_3 E_0_3_2_3"' in document[1]
    written = dict(files_of(system, system.iacs[0], Format.XSTATE)[0])
    config = json.loads(next(text for name, text in written.items() if name.endswith(".json")))
    assert '"target": ["#C_0_3_1_3", "#E_0_3_2_3"]' in json.dumps(config)


@pytest.mark.parametrize("line", ["0.3 -> 0.4 : after(4s)", "exit 0.3 : / raise go"])
def test_what_engines_skip_of_an_and_that_is_entered_again_is_refused(line: str) -> None:
    """SCION and XState do not leave the AND: its time would go on, and its exit would not be done."""
    system = system_of(TEXT.replace("0.3.1.3 ->", f"{line}\n  0.3.1.3 ->"))
    for form in (Format.SCXML, Format.XSTATE):
        written, (refused,) = files_of(system, system.iacs[0], form)
        assert written == () and Foreign.REENTERING.value in refused.message
        assert refused.span is not None and refused.span.text.startswith("0.3.1.3 -> (")


@pytest.mark.parametrize(
    ("format", "feature"),
    [
        (Format.SISMIC, Foreign.ENTERING),
        (Format.STCT, Foreign.SEVERAL_TARGETS),
        (Format.MERMAID, Foreign.SEVERAL_TARGETS),
        (Format.PLANTUML, Foreign.SEVERAL_TARGETS),
        (Format.BPMN, Foreign.SEVERAL_TARGETS),
    ],
)
def test_what_a_format_cannot_say_is_refused_at_its_place(format: Format, feature: Foreign) -> None:
    system = system_of(TEXT)
    written, refused = files_of(system, system.iacs[0], format)
    assert written == ()
    found = [item for item in refused if feature.value in item.message]
    places = [where.span.text.split(" :")[0] for item in found for where in (item, *item.related)]
    assert places == [
        "0.2 -> (0.3.1.3, 0.3.2.3)",
        "0.3.1.3 -> (0.3.1.2, 0.3.3.3)",
        "0.3 -> (0.3.2.3, 0.3.3.3)",
    ]
