"""The element under the cursor is marked in drawings: in the extension of VS Code and in `asemec view`."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.cli.lsp import project
from aseme_dsl.cli.view import Watched
from aseme_dsl.editor import viewer
from aseme_dsl.editor.answers.diagram import Diagrams
from aseme_dsl.editor.files.workspace import Workspace
from tests.cli.support import GOOD

ROOT = Path(__file__).resolve().parents[2]
MEDIA = ROOT / "editors" / "vscode" / "media"
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
OPTIONS = (
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking"
    " --disable-component-update --disable-sync --virtual-time-budget=2000 --dump-dom"
).split()

SHAPES = "path, polygon, ellipse, polyline, rect, circle"
MARKED = {"choice": "n0.2.2", "node": "n0.2.3", "start": "n0.1", "edge": "t4", "line back": "t1"}

VSCODE = """
<!DOCTYPE html><meta charset="utf-8"><style>%(css)s</style>
<h1 id="title"></h1><p id="note"></p><div id="zoom"><button id="in"></button><button id="out"></button>
<button id="fit"></button></div><div id="picture"></div>
<script>const acquireVsCodeApi = () => ({ postMessage() {} });</script>
<script>%(script)s</script>
<script>
window.dispatchEvent(new MessageEvent("message", { data: %(data)s }));
%(report)s
</script>
"""

REPORT = """
const report = {};
for (const [name, id] of Object.entries(%(marked)s)) {
  %(mark)s
  const marked = [...document.querySelectorAll("#picture .here")];
  const inside = marked.flatMap((item) => [...item.querySelectorAll("%(shapes)s")]);
  report[name] = inside.filter((shape) => shape.getAttribute("stroke") !== "transparent")
    .map((shape) => getComputedStyle(shape).stroke);
}
const other = document.querySelector("#picture [id='n0.2.4'] rect");
report.other = [getComputedStyle(other).stroke];
document.body.dataset.report = JSON.stringify(report);
"""


@cache
def state() -> dict[str, Any]:
    """What `asemec view` shows of a small system."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "team.aseme"
        file.write_text(GOOD)
        return Watched(file, Workspace(project()), Diagrams(), None).state()


def computed(page: str, folder: Path) -> dict[str, list[str]]:
    """The colours of the lines of what is marked, for each element in turn, as Chromium computes them."""
    if CHROMIUM is None:
        pytest.skip("NOT TRIED, for there is no Chromium here")
    file = folder / "page.html"
    file.write_text(page)
    command = [CHROMIUM, f"--user-data-dir={folder / 'profile'}", *OPTIONS, file.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    found = re.search(r'data-report="([^"]*)"', done.stdout)
    assert found is not None, done.stdout[-2000:] + done.stderr[-2000:]
    report: dict[str, list[str]] = json.loads(html.unescape(found[1]))
    return report


def report_of(mark: str) -> str:
    return REPORT % {"marked": json.dumps(MARKED), "mark": mark, "shapes": SHAPES}


def script(text: str) -> str:
    return text.replace("</", "<\\/")


def test_in_vs_code_every_kind_of_element_is_marked(tmp_path: Path) -> None:
    shown = state()
    data = {"name": "a", "svg": shown["svg"], "places": shown["elements"], "title": "", "note": ""}
    page = VSCODE % {
        "css": (MEDIA / "diagram.css").read_text("utf-8"),
        "script": (MEDIA / "diagram.js").read_text("utf-8"),
        "data": script(json.dumps(data)),
        "report": report_of('window.dispatchEvent(new MessageEvent("message", { data: { here: id } }));'),
    }
    found = computed(page, tmp_path)
    other = found.pop("other")
    for name, strokes in found.items():
        assert strokes and set(strokes) == {"rgb(194, 65, 12)"}, name
    assert other == ["rgb(77, 122, 44)"]


def test_in_the_browser_every_kind_of_element_is_marked(tmp_path: Path) -> None:
    page = viewer.page("x").decode()
    # A page of a file has nobody to ask: it is shown what it would be told.
    page = page.replace(
        "\nfollow();\n",
        f"\nconst told = {script(json.dumps(state()))};\n" + report_of("show({ ...told, here: id });") + "\n",
    )
    found = computed(page.replace('nonce="x"', ""), tmp_path)
    other = found.pop("other")
    for name, strokes in found.items():
        assert strokes and set(strokes) == {"rgb(200, 51, 10)"}, name
    assert other == ["rgb(77, 122, 44)"]


@pytest.mark.parametrize("element", MARKED.values())
def test_the_shapes_of_an_element_are_in_it_and_those_of_others_are_not(element: str) -> None:
    """What the style sheets rely on: a marked element has its own shapes inside, and no other element's."""
    import xml.etree.ElementTree as ElementTree

    tree = ElementTree.fromstring(state()["svg"])
    (group,) = [item for item in tree.iter() if item.get("id") == element]
    inside = [item.tag.rpartition("}")[2] for item in group.iter()]
    assert set(inside) & {"path", "rect", "circle"}
    assert [item.get("id") for item in group.iter() if item.get("id") in state()["elements"]] == [element]
    css = (MEDIA / "diagram.css").read_text("utf-8")
    assert not re.search(r"\.here\s*>", css) and not re.search(r":hover\s*>", css)


def test_the_name_of_a_state_is_a_part_of_it_for_a_click(tmp_path: Path) -> None:
    report = """
    const found = {};
    for (const text of document.querySelectorAll("text.name")) {
      const box = text.getBoundingClientRect();
      const hit = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
      found[text.textContent] = [hit.closest("[id]").id];
    }
    document.body.dataset.report = JSON.stringify(found);
    """
    page = f"<!DOCTYPE html><meta charset='utf-8'>{state()['svg']}<script>{report}</script>"
    found = computed(page, tmp_path)
    assert len(found) > 1
    for name, (element,) in found.items():
        (own,) = re.findall(
            rf'id="(n[\d.]+)" class="state" role="img" aria-label="activity {name}\b', state()["svg"]
        )
        assert element == own
