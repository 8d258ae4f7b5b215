"""What a notebook shows of models, drawings and runs."""

import base64
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from IPython.core.formatters import DisplayFormatter

import aseme_dsl
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import analyse
from aseme_dsl.diagrams import Layout, Options, draw_statechart, drawings
from aseme_dsl.project.building.build import Choice, build
from aseme_dsl.runtime import RunResult, Team, activities_in, load_system, run
from aseme_dsl.source import Source
from tests.documents.pages import texts

TEXT = """
system Kitchen
message Bell { bool rings }
topic door { state Bell }
sag { actor guest { goal eat } }
srm cook {
  liveness { cook = Look . Serve }
  activities { Look takes 1s  Serve takes 2s }
  control cook { enter Serve : [door.state.Bell.rings] }
}
srm guest { liveness { guest = Sit~ } activities { Sit takes 1s } }
team Kitchen { paula : cook  ann : guest }
"""
ALONE = TEXT.replace("  ann : guest", "")


def compiled(text: str) -> System:
    return aseme_dsl.compile(Source("kitchen.aseme", text))


def played(text: str, folder: Path, **options: object) -> RunResult:
    build(compiled(text), folder, Choice())
    return run(load_system(folder / "monas" / "Kitchen"), {}, **options)


def pictures(html: str) -> list[ElementTree.Element]:
    found = re.findall(r'<img src="data:image/svg\+xml;base64,([^"]+)"', html)
    return [ElementTree.fromstring(base64.b64decode(item)) for item in found]


class Printer:
    """Collects what is printed, as IPython's does."""

    def __init__(self) -> None:
        self.printed = ""

    def text(self, text: str) -> None:
        self.printed += text


def printed(value: System | RunResult) -> str:
    printer = Printer()
    value._repr_pretty_(printer, False)
    return printer.printed


def test_a_statechart_is_a_picture() -> None:
    svg = compiled(TEXT).iac("cook")._repr_svg_()
    assert svg is not None
    assert {"Look", "Serve"} <= set(texts(ElementTree.fromstring(svg)))


@pytest.mark.parametrize("model", ["sag", "suc", "srms"])
def test_other_models_are_pictures(model: str) -> None:
    found = getattr(compiled(TEXT), model)
    shown = found[0] if isinstance(found, tuple) else found
    svg = shown._repr_svg_()
    assert texts(ElementTree.fromstring(svg))
    assert shown._repr_html_() is None


def test_an_empty_model_shows_nothing() -> None:
    system = compiled(TEXT.replace("sag { actor guest { goal eat } }", ""))
    assert system.sag._repr_svg_() is None


def test_a_drawing_is_a_picture() -> None:
    for drawing in drawings(compiled(TEXT)):
        assert ElementTree.fromstring(drawing._repr_svg_() or "").tag.endswith("svg")


def test_a_system_shows_all_its_models() -> None:
    system = compiled(TEXT)
    html = system._repr_html_()
    assert html is not None
    assert system._repr_svg_() is None
    names = re.findall(r"<figcaption>(.*?)</figcaption>", html)
    assert names == ["sag", "suc", "srm.cook", "srm.guest", "iac.cook", "iac.guest"]
    assert len(pictures(html)) == len(names)
    assert printed(system) == "System Kitchen"


def test_a_large_statechart_shows_all_its_pieces() -> None:
    activities = [f"A{number}" for number in range(1600)]
    groups = [" . ".join(activities[start : start + 40]) for start in range(0, 1600, 40)]
    parts = [f"p{number} = {group}" for number, group in enumerate(groups)]
    whole = " . ".join(f"p{number}" for number in range(len(groups)))
    text = f"system Large srm robot {{ liveness {{ robot = {whole}\n" + "\n".join(parts) + "}}"
    chart = compiled(text).iac("robot")
    (nested,) = draw_statechart(chart, Options(layout=Layout.NESTED))
    assert nested._repr_svg_() is None
    html = nested._repr_html_()
    assert html is not None
    shown = {text for picture in pictures(html) for text in texts(picture)}
    assert set(activities) <= shown
    assert set(activities) <= set(texts(ElementTree.fromstring(chart._repr_svg_() or "")))


def test_a_result_shows_how_each_agent_ended_and_what_is_open(tmp_path: Path) -> None:
    result = played(ALONE, tmp_path)
    html = result._repr_html_()
    assert html is not None
    assert re.findall(r"<td>(.*?)</td>", html) == ["paula", "cook", "after Look"]
    assert "idle since 1 s: paula waits for input from outside" in html
    assert "idle since 1 s: paula waits for input from outside" in printed(result)


def test_an_analysis_is_a_short_table() -> None:
    analysis = analyse(
        Source("kitchen.aseme", "system Kitchen\nsrm cook { liveness { cook = Look . Serv<e } }")
    )
    html = analysis._repr_html_()
    assert html is not None
    cells = re.findall(r"<td>(.*?)</td>", html)
    assert cells[:3] == ["kitchen.aseme:2:41", "error", "E101"]
    assert "no system: 1 problem" in html
    assert "&lt;" in cells[3]
    assert printed(analysis).startswith("no system: 1 problem\nkitchen.aseme:2:41: error[E101]: ")
    assert "Kitchen: 2 problems" in (analyse(Source("kitchen.aseme", TEXT))._repr_html_() or "")


def test_a_result_holds_no_code_of_a_page(tmp_path: Path) -> None:
    (tmp_path / "look.py").write_text(
        "class Look:\n    def execute(self, context):\n        raise ValueError('<script>1</script>')\n"
    )
    build(compiled(TEXT), tmp_path / "out", Choice())
    result = run(load_system(tmp_path / "out/monas/Kitchen"), activities_in(tmp_path))
    html = result._repr_html_() or ""
    assert "&lt;script&gt;" in html
    assert "<script>" not in html


def test_a_run_without_an_end_takes_a_minute(tmp_path: Path) -> None:
    result = played(TEXT, tmp_path)
    assert (result.reason, result.end_ns) == ("time", 60_000_000_000)


def test_what_ends_a_run_replaces_the_minute(tmp_path: Path) -> None:
    def watch(team: Team) -> str | None:
        return "enough" if team.driver.clock.now() > 90_000_000_000 else None

    result = played(TEXT, tmp_path, stop=watch)
    assert result.reason == "enough"
    assert played(TEXT, tmp_path, until_ns=1_000_000_000).end_ns == 1_000_000_000


def test_ipython_takes_the_picture_and_the_short_text() -> None:
    shown = DisplayFormatter()  # type: ignore[no-untyped-call]
    data, _ = shown.format(compiled(TEXT))
    assert set(data) == {"text/plain", "text/html"}
    assert data["text/plain"] == "System Kitchen"
    data, _ = shown.format(compiled(TEXT).iac("cook"))
    assert set(data) == {"text/plain", "image/svg+xml"}
