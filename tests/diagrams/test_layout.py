"""Graphviz fails in many ways: each is noticed, tried otherwise, and said."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.diagrams import (
    Drawing,
    DrawingFailed,
    GraphvizMissing,
    Layout,
    Options,
    draw,
    draw_statechart,
    program,
    render,
)
from aseme_dsl.diagrams.rendering import layout as layout_module
from tests.diagrams.building import random_statechart, statechart
from tests.diagrams.pictures import Picture
from tests.diagrams.programs import counting, stand_in

REAL = program()

Fake = Callable[..., Path]


def drawing(formula: str = "(A | B)+ . C") -> Drawing:
    (made,) = draw_statechart(statechart(formula), Options(layout=Layout.NESTED))
    return made


@pytest.fixture
def fake(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Fake:
    """Puts a `dot` on the PATH that fails, unless an argument has a word; returns the list of its calls."""
    calls = tmp_path / "calls"
    calls.write_text("")

    def put(fails: str, *, unless: str = "") -> Path:
        stand_in(tmp_path / "bin", counting(calls, REAL, fails=fails, unless=unless))
        monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=os.pathsep)
        return calls

    return put


FAILURES = {
    "crashes": ("kill -SEGV $$", "was ended by SIGSEGV"),
    "fails": ("echo 'Error: trouble in init_rank' >&2; exit 1", "trouble in init_rank"),
    "complains": (f'echo "Error: lost a b edge" >&2; exec "{REAL}" "$@"', "lost a b edge"),
    "writes nothing": ("cat > /dev/null", "cannot be read"),
    "writes half": (f'"{REAL}" "$@" | head -c 900', "cannot be read"),
    "loses an edge": (f'"{REAL}" "$@" | sed \'s/id="t3"/id="gone"/\'', "t3 is not drawn"),
    "loses a text": (f'"{REAL}" "$@" | sed \'s/>A</></\'', "lacks the text 'A'"),
    "draws a state elsewhere": (
        f'"{REAL}" "$@" | sed \'/id="n0.2.2.3"/,/<text/s/ d="[^"]*"/ d="M9,900L99,990 9,990"/\'',
        "n0.2.2.3 is drawn outside of n0.2.2",
    ),
}


@pytest.mark.parametrize("how", FAILURES)
def test_a_failure_is_noticed_and_newrank_tried(how: str, fake: Fake) -> None:
    fails, _ = FAILURES[how]
    calls = fake(fails, unless="newrank")
    assert Picture(render(drawing(), "svg")).ids
    assert calls.read_text().splitlines() == ["-Tsvg", "-Tsvg -Gnewrank=true"]


@pytest.mark.parametrize("how", FAILURES)
def test_what_went_wrong_is_said(how: str, fake: Fake) -> None:
    fails, words = FAILURES[how]
    fake(fails)
    with pytest.raises(DrawingFailed, match=words) as failure:
        render(drawing(), "svg")
    assert str(failure.value).startswith("iac.Test.nested could not be drawn: ")


def test_a_program_that_hangs_is_ended_with_all_that_it_started(
    fake: Fake, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    started = tmp_path / "started"
    fake(f"sleep 300 & echo $! >> '{started}'; wait")

    class Hanging(subprocess.Popen[bytes]):
        """A program whose time begins when it has started what it starts, however long that takes."""

        def communicate(self, *arguments: Any, **options: Any) -> tuple[bytes, bytes]:
            began.append(self.pid)
            while not started.exists() or len(started.read_text().splitlines()) < len(began):
                assert self.poll() is None
                time.sleep(0.01)
            return super().communicate(*arguments, **options)

    began: list[int] = []
    monkeypatch.setattr("aseme_dsl.diagrams.rendering.layout.subprocess.Popen", Hanging)
    with pytest.raises(DrawingFailed, match=r"dot was not done after 0\.3 s"):
        render(drawing(), "svg", time_limit=0.3)
    assert len(began) == 2
    for number in (*began, *map(int, started.read_text().split())):
        assert _ends(number)


def _ends(number: int) -> bool:
    """Whether the process is gone, or only waits for somebody to take note that it is."""
    for _ in range(1200):
        try:
            os.kill(number, 0)
            state = Path(f"/proc/{number}/stat")
            if state.exists() and state.read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except (ProcessLookupError, FileNotFoundError):
            return True
        time.sleep(0.05)
    return False


def test_a_picture_in_another_format_is_checked_as_well(fake: Fake) -> None:
    calls = fake('echo "Error: lost a b edge" >&2; exit 0', unless="newrank")
    assert render(drawing(), "png").startswith(b"\x89PNG")
    assert calls.read_text().splitlines() == ["-Tsvg", "-Tsvg -Gnewrank=true", "-Tpng -Gnewrank=true"]


def test_a_word_about_fonts_is_no_failure(fake: Fake) -> None:
    fake(f'echo "Fontconfig error: Cannot load default config file" >&2; exec "{REAL}" "$@"')
    assert render(drawing(), "svg") == _real_svg()


def _real_svg() -> bytes:
    return layout_module.svg.cleaned(
        layout_module._run([REAL, "-Tsvg"], drawing().dot, 10.0), "IAC Test of Test"
    )


def test_where_nothing_draws_it_whole_it_is_drawn_in_pieces(fake: Fake, tmp_path: Path) -> None:
    chart = random_statechart(3, size=20, extra=0)
    (whole,) = draw_statechart(chart, Options(layout=Layout.NESTED))
    assert len(chart.states) > 120
    # Whatever has more than a few kilobytes fails; small drawings succeed.
    limit = len(whole.dot) - 1
    text = tmp_path / "text"
    fake(
        f"cat > '{text}'; test $(wc -c < '{text}') -lt {limit} || {{ echo 'Error: trouble' >&2; exit 1; }}; "
        f'exec "{REAL}" "$@" < \'{text}\''
    )
    drawn = draw(whole, "svg")
    names = [name for name, _ in drawn.files]
    assert names[:2] == ["iac.Test.nested.svg", "iac.Test.nested.0.svg"]
    assert len(names) > 2
    (note,) = drawn.notes
    assert "trouble" in note
    assert f"{len(names)} files, iac.Test.nested.svg is where to begin" in note
    index = Picture(drawn.files[0][1])
    for name in names[1:]:
        assert name in index.text
    shown = set.union(*(Picture(content).ids for _, content in drawn.files[1:]))
    assert {f"n{node.label}" for node in chart.states} <= shown
    assert {f"t{place}" for place in range(len(chart.transitions))} <= shown


def test_a_piece_that_fails_too_is_drawn_or_state_by_or_state(fake: Fake, tmp_path: Path) -> None:
    chart = random_statechart(3, size=20, extra=0)
    (whole,) = draw_statechart(chart, Options(layout=Layout.NESTED))
    text = tmp_path / "text"
    # As the real one does: it draws no cluster within a cluster.
    fake(
        f"cat > '{text}'; test $(grep -c subgraph '{text}') -lt 2 || {{ echo 'trouble' >&2; exit 1; }}; "
        f'exec "{REAL}" "$@" < \'{text}\''
    )
    drawn = draw(whole, "svg")
    composites = [node for node in chart.states if chart.children(node.label)]
    assert len(drawn.files) == len(composites) + 1
    assert len({name for name, _ in drawn.files}) == len(drawn.files)
    shown = set.union(*(Picture(content).ids for _, content in drawn.files))
    assert {f"t{place}" for place in range(len(chart.transitions))} <= shown


def test_a_table_has_no_pieces(fake: Fake) -> None:
    fake("exit 3")
    with pytest.raises(DrawingFailed, match="failed with code 3"):
        draw(Drawing("sag", "digraph { }"), "svg")


def test_without_graphviz_it_is_said_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(layout_module.sysconfig, "get_path", lambda name: str(tmp_path))
    with pytest.raises(GraphvizMissing, match=r"apt install graphviz.*pip install graphviz-pure"):
        draw(drawing(), "svg")
    assert draw(drawing(), "dot").files == (("iac.Test.nested.dot", drawing().dot.encode()),)


def test_dot_on_the_path_is_preferred(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    pure = stand_in(tmp_path / "bin", "exit 1", "graphviz-pure")
    assert program() == str(pure)
    dot = stand_in(tmp_path / "bin", "exit 1")
    assert program() == str(dot)


def test_the_program_of_the_package_is_found_though_its_environment_is_not_active(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if shutil.which("graphviz-pure", path=layout_module.sysconfig.get_path("scripts")) is None:
        pytest.skip("graphviz-pure has no wheel for this platform")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert Path(program()).name.startswith("graphviz-pure")


def test_another_format_is_refused() -> None:
    with pytest.raises(ValueError, match="'gif' is not one of svg, png, pdf, dot"):
        render(drawing(), "gif")
