"""W525: a signal that comes while nothing can take it, and is taken long afterwards."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis

TEXT = """system S
message Key { int number }
message Done { bool ok }
topic panel { signal Key  state Done }
srm machine {
  liveness { machine = (Wait . Serve . Rest)~ }
  activities { Wait waits  Serve takes 5s  Rest takes 1s }
  control machine {
    enter Serve : when [panel.signal.Key.number > 0]
  }
}
"""
PERSON = """srm person {
  liveness { person = Press~ }
  activities { Press takes 1s writes panel.signal.Key }
}
"""


def told(text: str) -> list[tuple[str, str, str]]:
    """What is said of signals that are taken late: the place, the message and the hint."""
    found = [item for item in analysis(text).diagnostics if item.code == "W525"]
    return [
        (item.span.text if item.span else "", item.problem.message, item.problem.hint or "") for item in found
    ]


def changed(*changes: tuple[str, str], text: str = TEXT) -> str:
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return text


def test_the_place_the_states_and_both_ways_out_are_said() -> None:
    [(place, message, hint)] = told(TEXT)
    assert place == "panel.signal.Key.number"
    assert message == (
        "a signal `panel.signal.Key` that comes in `Serve` and `Rest` is taken here afterwards,"
        " however old it is"
    )
    assert hint == (
        "let it expire (`signal Key expires 2s` on its topic), or drop it:"
        " `on Serve : ignores panel.signal.Key`"
    )


LATE = (
    changed(("Wait waits", "Wait takes 1s"), ("when [", "[")),
    changed(
        ("enter Serve : when [panel.signal.Key.number > 0]", "enter Serve : when [has(panel.signal.Key)]")
    ),
    changed(("enter Serve", "on Serve : ignores panel.signal.Key\n    enter Serve")),
    TEXT + PERSON,
    changed(("Serve . Rest", "(Serve || Rest)"), ("enter Serve", "enter (Serve || Rest)")),
    changed(
        ("(Wait . Serve . Rest)~", "(serve [> Stop)~  serve = Serve . Rest"),
        ("Wait waits ", "Stop waits "),
        ("enter Serve : when", "leave Stop : when"),
        ("control machine {", "control machine {\n    enter Stop : stop"),
    ),
)


@pytest.mark.parametrize("text", LATE)
def test_a_signal_that_may_wait(text: str) -> None:
    assert len(told(text)) == 1


SOUND = (
    changed(("signal Key", "signal Key expires 2s")),
    changed(("signal Key", "signal Key queued")),
    changed(
        ("enter Serve", "on (Serve . Rest) : ignores panel.signal.Key\n    enter Serve"),
        ("Serve . Rest", "(Serve . Rest)"),
    ),
    changed(
        (
            "enter Serve",
            "on Serve : when [has(panel.signal.Key)] / n += 1\n    on Rest : ignores panel.signal.Key\n"
            "    enter Serve",
        ),
        ("liveness", "var n : int = 0\n  liveness"),
    ),
    changed(
        (
            "Serve takes 5s  Rest takes 1s",
            "Serve takes 5s reads panel.signal.Key  Rest takes 1s reads panel.signal.Key",
        )
    ),
    changed(("when [panel", "after(5s) [panel")),
    changed((" . Serve . Rest", ""), ("enter Serve", "repeat Wait")),
    # It is an answer: it only comes when the machine has asked.
    changed(
        ("enter Serve", "repeat (Wait . Serve . Rest) : / write_messages.panel.state.Done\n    enter Serve"),
        text=TEXT + PERSON.replace("Press takes 1s", "Press takes 1s reads panel.state.Done"),
    ),
    # It comes from the same sequence of states.
    changed(("Serve takes 5s", "Serve takes 5s writes panel.signal.Key")),
)


@pytest.mark.parametrize("text", SOUND)
def test_sound_files(text: str) -> None:
    assert told(text) == []
