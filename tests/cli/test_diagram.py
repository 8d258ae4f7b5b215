"""`asemec diagram`."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from aseme_dsl.diagrams import writes_pdf
from tests.cli.support import Here

ALL = {"srm.robot", "iac.robot"}


def stems(folder: Path) -> set[str]:
    return {path.stem for path in folder.iterdir() if not path.name.startswith(".")}


def test_all_models_into_a_folder(here: Here, folder: Path) -> None:
    done = here("diagram", "good.aseme")
    assert (done.code, done.out) == (0, "files: 2 created\n")
    assert stems(folder / "diagrams") == ALL
    assert here("diagram", "good.aseme").out == "files: 2 unchanged\n"


@pytest.mark.parametrize(
    ("models", "drawn"),
    [
        (["srm.robot"], {"srm.robot"}),
        (["iac"], {"iac.robot"}),
        (["iac.robot.nested"], {"iac.robot.nested"}),
        (["iac.robot.tree", "srm"], {"iac.robot.tree", "srm.robot"}),
        (["*.tree"], {"iac.robot.tree"}),
    ],
)
def test_some_models(here: Here, folder: Path, models: list[str], drawn: set[str]) -> None:
    assert here("diagram", "good.aseme", *models, "-o", "some").code == 0
    assert stems(folder / "some") == drawn


@pytest.mark.parametrize(
    ("format", "begin"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF"), ("dot", b"digraph")]
)
def test_formats(here: Here, folder: Path, format: str, begin: bytes) -> None:
    if format == "pdf" and not writes_pdf():
        done = here("diagram", "good.aseme", "srm", "-o", "one.pdf")
        assert done.code == 1 and "writes no PDF: install Graphviz" in done.err
        assert not (folder / "one.pdf").exists()
        return
    assert here("diagram", "good.aseme", "srm", "-o", f"one.{format}").code == 0
    assert (folder / f"one.{format}").read_bytes().startswith(begin)
    assert here("diagram", "good.aseme", "srm", "-o", "many", "--format", format).code == 0
    assert (folder / "many" / f"srm.robot.{format}").read_bytes().startswith(begin)


def test_standard_output(here: Here, folder: Path) -> None:
    done = here("diagram", "good.aseme", "srm.robot", "-o", "-", "--format", "dot")
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith("digraph")


def test_one_file_takes_one_drawing(here: Here, folder: Path) -> None:
    done = here("diagram", "good.aseme", "-o", "all.svg")
    assert done.code == 2
    assert "is a file for one diagram, but 2 are selected" in done.err
    assert not (folder / "all.svg").exists()


def test_a_pdf_takes_several_drawings_one_a_page(here: Here, folder: Path) -> None:
    pypdf = pytest.importorskip("pypdf")
    if not writes_pdf():
        pytest.skip("this Graphviz writes no PDF")
    done = here("diagram", "good.aseme", "--page", "a4", "-o", "robot.pdf")
    assert done.code == 0, done.err
    document = pypdf.PdfReader(folder / "robot.pdf")
    assert [item.title for item in document.outline] == ["srm.robot", "iac.robot"]
    assert ["Walk" in page.extract_text() for page in document.pages] == [True, True]
    width, height = (float(side) for side in document.pages[1].mediabox[2:])
    assert (round(width), round(height)) == (842, 595)
    assert here("diagram", "good.aseme", "--page", "a4", "-o", "robot.pdf").out == "files: 1 unchanged\n"


def test_a_pdf_of_several_drawings_needs_a_package(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not writes_pdf():
        pytest.skip("this Graphviz writes no PDF")
    monkeypatch.setitem(sys.modules, "pypdf", None)
    done = here("diagram", "good.aseme", "-o", "robot.pdf")
    assert done.code == 1
    assert "pip install 'aseme-dsl[pdf]'" in done.err
    assert not (folder / "robot.pdf").exists()
    assert here("diagram", "good.aseme", "iac.robot", "-o", "robot.pdf").code == 0


def test_a_statechart_in_one_file(here: Here, folder: Path) -> None:
    # As the example of `--help` has it.
    done = here("diagram", "good.aseme", "iac.robot", "--at", "0.2", "--depth", "2", "-o", "robot.dot")
    assert done.code == 0, done.err
    assert "_background" in (folder / "robot.dot").read_text()
    for layout, groups in (("nested", True), ("tree", False)):
        assert here("diagram", "good.aseme", "iac.robot", "--layout", layout, "-o", f"{layout}.dot").code == 0
        assert ("subgraph" in (folder / f"{layout}.dot").read_text()) is groups


def test_the_format_and_the_suffix_are_the_same(here: Here, folder: Path) -> None:
    done = here("diagram", "good.aseme", "srm", "-o", "robot.pdf", "--format", "svg")
    assert (done.code, "--format svg does not fit" in done.err) == (2, True)
    assert not (folder / "robot.pdf").exists()


@pytest.mark.parametrize("name", ["robot.gif", "robot.jpeg", "robot.ps"])
def test_a_picture_that_cannot_be_written_is_no_folder(here: Here, folder: Path, name: str) -> None:
    done = here("diagram", "good.aseme", "srm", "-o", name)
    assert done.code == 2
    assert "svg, png, pdf or dot" in done.err
    assert not (folder / name).exists()


@pytest.mark.parametrize("format", ["svg", "png", "pdf", "dot"])
def test_a_drawing_takes_the_place_of_a_drawing_and_of_nothing_else(
    here: Here, folder: Path, format: str
) -> None:
    if format == "pdf" and not writes_pdf():
        pytest.skip("needs Graphviz' own dot")
    one = folder / f"one.{format}"
    for model in ("srm", "iac.robot", "iac.robot.nested", "srm"):
        assert here("diagram", "good.aseme", model, "-o", one).code == 0
    one.write_text("mine")
    done = here("diagram", "good.aseme", "srm", "-o", one)
    assert done.code == 2 and "is not a drawing that asemec wrote" in done.err
    assert one.read_text() == "mine"
    assert here("diagram", "good.aseme", "srm", "-o", one, "--force").code == 0
    assert one.read_bytes() != b"mine"


def test_what_was_not_drawn_stays_in_a_folder(here: Here, folder: Path) -> None:
    (folder / "some").mkdir()
    (folder / "some/srm.robot.svg").write_text("mine")
    done = here("diagram", "good.aseme", "srm", "-o", "some")
    assert done.code == 1
    assert "asemec did not write it" in done.err
    assert (folder / "some/srm.robot.svg").read_text() == "mine"
    assert here("diagram", "good.aseme", "srm", "-o", "some", "--force").code == 0


def test_a_source_is_not_taken_for_a_picture(here: Here, folder: Path) -> None:
    before = (folder / "good.aseme").read_text()
    assert here("diagram", "good.aseme", "srm", "-o", "good.aseme").code == 1
    assert (folder / "good.aseme").read_text() == before


def test_part_of_a_statechart(here: Here, folder: Path) -> None:
    assert here("diagram", "good.aseme", "iac.robot", "--layout", "nested", "-o", "all.dot").code == 0
    assert here("diagram", "good.aseme", "--at", "0.2", "--layout", "nested", "-o", "part.dot").code == 0
    assert (
        here("diagram", "good.aseme", "iac.robot", "--layout", "nested", "--depth", "1", "-o", "top.dot").code
        == 0
    )
    sizes = {name: len((folder / f"{name}.dot").read_text()) for name in ("all", "part", "top")}
    assert sizes["part"] < sizes["all"]
    assert sizes["top"] < sizes["all"]


def test_expressions(here: Here, folder: Path) -> None:
    texts = {}
    for choice in ("numbered", "inline", "none"):
        done = here("diagram", "good.aseme", "iac.robot.tree", "--expressions", choice, "-o", f"{choice}.dot")
        assert done.code == 0, done.err
        texts[choice] = (folder / f"{choice}.dot").read_text()
    assert len(set(texts.values())) == 3


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["iac.robbot"], "did you mean iac.robot?"),
        (["eac"], "there are srm.robot"),
        (["--at", "0.99"], "0.99"),
    ],
)
def test_what_is_not_there_is_wrong_use(here: Here, folder: Path, arguments: list[str], words: str) -> None:
    done = here("diagram", "good.aseme", *arguments)
    assert done.code == 2
    assert words in done.err


def test_a_file_with_errors(here: Here, folder: Path) -> None:
    done = here("diagram", "bad.aseme")
    assert done.code == 1
    assert "error[" in done.err
    assert not (folder / "diagrams").exists()
    failed = here("diagram", "bad.aseme", "--json")
    assert failed.json["errors"] == 2


def test_a_folder_with_several_systems(here: Here, folder: Path) -> None:
    done = here("diagram", ".")
    assert done.code == 2
    assert "contains 2 systems (bad.aseme, good.aseme)" in done.err


def test_json(here: Here, folder: Path) -> None:
    result = here("diagram", "good.aseme", "srm", "--json").json
    assert result["created"] == [str(Path("diagrams/srm.robot.svg"))]
    assert result["remarks"] == []


def test_without_graphviz(here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from aseme_dsl.diagrams import GraphvizMissing

    def missing() -> str:
        raise GraphvizMissing

    monkeypatch.setattr("aseme_dsl.diagrams.rendering.layout.program", missing)
    done = here("diagram", "good.aseme")
    assert done.code == 1
    assert "Graphviz is needed to draw" in done.err
    assert here("diagram", "good.aseme", "--format", "dot").code == 0


def test_progress_is_shown_on_a_terminal_alone(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments = ("diagram", "good.aseme", "iac", "--format", "dot")
    assert here(*arguments).err == ""
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("CI", "")
    said = here(*arguments).err
    assert "drawing 1 of 1: iac.robot" in said and said.endswith("\r\x1b[K")


def test_the_compact_layout(here: Here, folder: Path) -> None:
    assert here("diagram", "good.aseme", "iac", "-o", "one.svg").code == 0
    assert 'class="aseme-compact"' in (folder / "one.svg").read_text("utf-8")
    assert here("diagram", "good.aseme", "iac", "--layout", "compact", "-o", "one.png").code == 0
    done = here("diagram", "good.aseme", "iac", "--layout", "compact", "--page", "a4", "-o", "pages")
    assert (done.code, stems(folder / "pages")) == (0, {"iac.robot"})


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--page", "a4", "--layout", "tree"], "--page is for the compact layout"),
        (["--page", "a4", "--layout", "compact", "--depth", "1"], "without --depth"),
        (["--expressions", "none"], "--expressions is for --layout nested and --layout tree: add one"),
        (["--layout", "compact", "--at", "9"], "no statechart of"),
    ],
)
def test_what_the_compact_layout_does_not_take(
    here: Here, folder: Path, options: list[str], said: str
) -> None:
    done = here("diagram", "good.aseme", "iac", *options)
    assert done.code == 2
    assert said in done.err
