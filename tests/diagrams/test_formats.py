"""A drawing as PNG, PDF and DOT."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from aseme_dsl.diagrams import DrawingFailed, Layout, Options, draw_statechart, drawings, render, writes_pdf
from tests.diagrams.building import statechart
from tests.diagrams.test_escaping import drawing_of_goal
from tests.diagrams.texts import TEAM, compiled

PURE = not writes_pdf()


def test_every_drawing_can_be_a_png_and_a_pdf() -> None:
    for drawing in drawings(compiled(TEAM)):
        assert render(drawing, "png").startswith(b"\x89PNG\r\n")
        if not PURE:
            assert render(drawing, "pdf").startswith(b"%PDF-")


def test_dot_text_needs_no_graphviz(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    (drawing,) = draw_statechart(statechart("A . B"), Options(layout=Layout.NESTED))
    assert render(drawing, "dot") == drawing.dot.encode()
    assert drawing.dot.startswith('digraph "iac.Test.nested" {\n')


@pytest.mark.skipif(PURE or shutil.which("pdftotext") is None, reason="needs Graphviz' own dot and pdftotext")
def test_a_pdf_has_the_texts_in_every_alphabet(tmp_path: Path) -> None:
    text = "γκολ Ανίχνευση ζώνης ϊ Ünïcödé (a) \\ b"
    picture = tmp_path / "goal.pdf"
    picture.write_bytes(render(drawing_of_goal(text), "pdf"))
    read = subprocess.run(["pdftotext", "-enc", "UTF-8", picture, "-"], capture_output=True, check=True)
    assert "".join(text.split()) in "".join(read.stdout.decode().split())


def test_without_graphviz_own_dot_there_is_no_pdf(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    drawing = drawing_of_goal("γκολ")
    with pytest.raises(DrawingFailed, match=r"writes no PDF: .*`dot`.*apt install graphviz"):
        render(drawing, "pdf")
    assert render(drawing, "png").startswith(b"\x89PNG\r\n")
