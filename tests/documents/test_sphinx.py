"""The Sphinx directive, in documentations that are built."""

from __future__ import annotations

import io
import os
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

from aseme_dsl.diagrams import writes_pdf
from aseme_dsl.diagrams.rendering import store
from aseme_dsl.documents import figures
from aseme_dsl.project.building.project import Compiled
from aseme_dsl.source import Source
from tests.documents.pages import BROKEN, SMALL, SVG, WALKER, ids, svgs, texts

CONF = """\
extensions = ["aseme_dsl.documents.sphinx", "myst_parser"]
myst_enable_extensions = ["colon_fence"]
html_theme = "basic"
html_copy_source = html_use_index = False
"""


class Site:
    """A documentation in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.write("conf.py", CONF)
        self.write("walker.aseme", WALKER)

    def write(self, name: str, text: str) -> None:
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)

    def build(self, builder: str = "html", *, strict: bool = False) -> tuple[int, str]:
        """Build it as `sphinx-build` does; the exit code and the warnings, with paths from its folder."""
        warnings = io.StringIO()
        with patch_docutils(str(self.folder)), docutils_namespace():
            app = Sphinx(
                self.folder,
                self.folder,
                self.folder / "_build" / builder,
                self.folder / "_build" / "doctrees",
                builder,
                status=None,
                warning=warnings,
                warningiserror=strict,
            )
            app.build()
        plain = re.sub(r"\x1b\[[0-9;]*m", "", warnings.getvalue())
        return app.statuscode, plain.replace(f"{self.folder}/", "")

    def page(self, name: str = "index") -> str:
        return (self.folder / "_build" / "html" / f"{name}.html").read_text()


@pytest.fixture
def site(tmp_path: Path) -> Site:
    return Site(tmp_path)


def rst(options: str = "", text: str = "", file: str = "") -> str:
    """A page with one diagram."""
    indented = "".join(f"   {line}\n" if line else "\n" for line in f"{options}\n\n{text}".split("\n"))
    return f"Title\n=====\n\n.. aseme-diagram:: {file}\n{indented}\n"


def test_a_model_of_a_file_is_drawn_inside_the_page(site: Site) -> None:
    site.write(
        "index.rst", rst(":model: iac.robot\n:caption: How it *walks*\n:name: walks", file="walker.aseme")
    )
    assert site.build(strict=True) == (0, "")
    (svg,) = svgs(site.page())
    assert svg.get("role") == "graphics-document document", "its states and lines are read"
    assert svg.get("aria-label") == "Statechart of the role robot: 9 states; activities Walk and Stand"
    assert {"Walk", "Stand", "[Seen.home]"} <= set(texts(svg))
    assert re.search(r"<figure [^>]*id=\"walks\"", site.page())
    assert "How it <em>walks</em>" in site.page()
    assert "<a xlink" not in site.page()


def test_in_a_page_of_myst(site: Site) -> None:
    block = f"```{{aseme-diagram}}\n:model: iac\n:source:\n\n{SMALL}```\n"
    site.write("index.md", f"# Title\n\n```{{aseme-diagram}} walker.aseme\n:model: srm.robot\n```\n\n{block}")
    assert site.build(strict=True) == (0, "")
    table, chart = svgs(site.page())
    assert table.get("aria-label") == "Role robot: formula robot; activities Walk and Stand"
    assert {"Look", "Wait"} <= set(texts(chart))
    assert "liveness { robot = Look | Wait }" in re.sub("<[^>]*>", "", site.page())
    assert len(ids(site.page())) == len(set(ids(site.page())))


def test_what_options_mean(site: Site) -> None:
    options = ":model: iac.robot\n:layout: both\n:at: 0.2\n:expressions: inline\n:alt: Walking"
    site.write("index.rst", rst(options, file="/walker.aseme"))
    assert site.build(strict=True) == (0, "")
    nested, tree = svgs(site.page())
    assert nested.get("aria-label") == tree.get("aria-label") == "Walking"
    assert "Seen.ball]" in "".join(texts(tree)) and "0.1" not in texts(tree)


def test_compact_drawings_keep_their_tips_and_leave_the_page_alone(site: Site) -> None:
    site.write("index.rst", rst(":model: iac.robot\n:layout: compact", file="/walker.aseme"))
    assert site.build(strict=True) == (0, "")
    (drawing,) = svgs(site.page())
    assert len(ids(site.page())) == len(set(ids(site.page())))
    assert any("BASIC Walk" in (item.text or "") for item in drawing.iter() if item.tag.endswith("title"))
    (style,) = (item.text or "" for item in drawing.iter() if item.tag.endswith("style"))
    selectors = re.findall(r"(?:^|[}\n])([^{}@\n]+)\{", style)
    assert selectors and all(
        part.startswith(".aseme-compact ") for rule in selectors for part in rule.split(",")
    )


def test_a_picture_beside_the_page(site: Site) -> None:
    site.write("deep/page.rst", rst(":model: iac.robot\n:embed: file", file="../walker.aseme"))
    site.write("index.rst", "Title\n=====\n\n.. toctree::\n\n   deep/page\n")
    assert site.build(strict=True) == (0, "")
    address, alt = re.findall(r'<img src="([^"]*)" alt="([^"]*)"', site.page("deep/page"))[0]
    assert alt.startswith("Statechart of the role robot")
    picture = site.folder / "_build" / "html" / "deep" / address
    ElementTree.fromstring(picture.read_bytes())


def test_a_mistake_is_a_warning_with_the_line_of_the_page(site: Site) -> None:
    block = f"```{{aseme-diagram}}\n:model: iac\n\n{BROKEN}```\n"
    pages = {
        "index.rst": rst(":model: iac", BROKEN) + ".. toctree::\n\n   one\n   two\n",
        "one.md": f"# Title\n\n{block}",
        "two.md": f"# Title\n\n::::{{note}}\n{block}::::\n",
    }
    places = []
    for name, text in pages.items():
        site.write(name, text)
        places += [f"{name}:{number}" for number, line in enumerate(text.split("\n"), 1) if "Loook" in line]
    code, warnings = site.build(strict=True)
    assert code == 1
    said = "WARNING: error[E204]: no formula has the activity `Loook`"
    assert [line.partition("; ")[0] for line in warnings.splitlines()] == [f"{at}: {said}" for at in places]
    for at in places:
        page = site.page(at.partition(".")[0])
        assert f"{at}:" in page and "<svg" not in page
    assert site.build() == (0, warnings)  # also when nothing has changed


def test_a_mistake_in_a_file_has_its_place_and_that_of_the_diagram(site: Site) -> None:
    site.write("broken.aseme", BROKEN)
    site.write("index.rst", rst(file="broken.aseme"))
    _, warnings = site.build()
    assert re.match(r"index\.rst:4: WARNING: \S*broken\.aseme:4:16: error\[E204\]", warnings)


def test_what_cannot_be_drawn(site: Site) -> None:
    wrong = [
        ("", "", "nowhere.aseme", "nowhere.aseme"),
        (":model: iac.robt", "", "walker.aseme", "did you mean iac.robot?"),
        (":at: 0.9", "", "walker.aseme", "0.9"),
        (":at: here", "", "walker.aseme", "has a state here"),
        (":at: 0..1", "", "walker.aseme", "the label of a state"),
        (":page: a5", "", "walker.aseme", "a4 or screen"),
        (":page: a4\n:layout: tree", "", "walker.aseme", "is for the layout compact"),
        (":depth: 0", "", "walker.aseme", "at least 1"),
        (":layout: square", "", "walker.aseme", "compact, nested, tree or both"),
        (":expressions: none", "", "walker.aseme", "add one of them as 'layout'"),
        ("", SMALL, "walker.aseme", "a file or a text, not both"),
        ("", "", "", "needs a file, or the text"),
        ("", "system Nothing", "", "nothing to draw"),
    ]
    for number, (options, text, file, _) in enumerate(wrong):
        site.write(f"page{number}.rst", ":orphan:\n\n" + rst(options, text, file))
    site.write("index.rst", "Title\n=====\n")
    code, warnings = site.build(strict=True)
    assert code == 1
    for number, (*_, said) in enumerate(wrong):
        assert re.search(rf"page{number}\.rst:6: (WARNING|ERROR): [^\0]*?{re.escape(said)}", warnings), said
    assert len(re.findall("(WARNING|ERROR): ", warnings)) == len(wrong)


def test_a_page_is_made_again_when_a_file_changes(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    real = store.render
    monkeypatch.setattr(
        store, "render", lambda item, *rest, **more: drawn.append(item.name) or real(item, *rest, **more)
    )
    shared, own = WALKER.split("srm robot", 1)
    head, shared = shared.split("\n", 1)
    site.write("shared.aseme", shared)
    site.write("walker.aseme", f'{head}\nimport "shared.aseme"\nsrm robot{own}')
    site.write("index.rst", rst(":model: iac.robot", file="walker.aseme"))
    assert site.build() == (0, "")
    assert drawn == ["iac.robot"]

    def changed(name: str, old: str, new: str) -> None:
        path = site.folder / name
        later = path.stat().st_mtime + 10
        path.write_text(path.read_text().replace(old, new))
        os.utime(path, (later, later))

    changed("walker.aseme", "Stand", "Sit")
    assert site.build() == (0, "")
    assert "Sit" in texts(svgs(site.page())[0])
    changed("shared.aseme", "bool home", "bool house")
    assert "no member `home`" in site.build()[1]
    changed("shared.aseme", "bool house", "bool home")
    assert site.build() == (0, "")
    assert "Sit" in texts(svgs(site.page())[0])
    assert drawn == ["iac.robot", "iac.robot"]  # the last one is the one before


def test_a_file_that_changes_while_it_is_compiled_is_compiled_again(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = figures.compile_root

    def slow(root: Path | Source) -> Compiled:
        found = real(root)
        site.write("walker.aseme", WALKER.replace("Stand", "Sit"))
        return found

    monkeypatch.setattr(figures, "compile_root", slow)
    page = rst(":model: iac.robot", file="walker.aseme")
    for text, seen in ((page, "Stand"), (f"{page}More\n", "Sit")):
        site.write("index.rst", text)
        assert site.build() == (0, "")
        assert seen in texts(svgs(site.page())[0])


def test_pictures_outlive_the_process(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    site.write("index.rst", rst(":model: iac.robot", file="walker.aseme"))
    site.build()
    monkeypatch.setattr("aseme_dsl.documents.sphinx._drawers", {})
    monkeypatch.setattr(store, "render", lambda *rest, **more: pytest.fail("drawn again"))
    site.write("index.rst", rst(":model: iac.robot", file="walker.aseme") + "More\n")
    assert site.build() == (0, "")
    assert len(svgs(site.page())) == 1


def test_other_builders(site: Site) -> None:
    site.write("index.rst", rst(":model: iac.robot\n:caption: How it walks", file="walker.aseme"))
    alt = "Statechart of the role robot: 9 states"
    for builder in ("text", "man", "texinfo", "latex", "xml"):
        assert site.build(builder, strict=True) == (0, ""), builder
    built = site.folder / "_build"
    assert alt in " ".join((built / "text" / "index.txt").read_text().split())
    form, begin = ("pdf", b"%PDF-") if writes_pdf() else ("png", b"\x89PNG")
    (picture,) = (built / "latex").glob(f"iac-robot-*.{form}")
    assert picture.read_bytes().startswith(begin)
    assert f"{{{picture.name}}}" in next((built / "latex").glob("*.tex")).read_text()


def long(name: str) -> str:
    return " . ".join(f"{name}Something{number}" for number in range(60))


LARGE = f"""\
   system Large
   srm robot {{
     liveness {{
       robot = first || second
       first = ({long("Do")})~
       second = ({long("Undo")})~
     }}
   }}
"""


def test_a_large_chart_becomes_pictures_that_lead_to_each_other(site: Site) -> None:
    options = "   :model: iac.robot\n   :page: a4\n\n"
    site.write("index.rst", f"Title\n=====\n\n.. aseme-diagram::\n{options}{LARGE}")
    assert site.build(strict=True) == (0, "")
    first, *others = svgs(site.page())
    assert others
    leads = {item.get("href", "") for item in first.iter(f"{SVG}a")}
    assert leads == {f"#{item.get('id')}" for item in others}
    for other in others:
        assert f"#{first.get('id')}" in {item.get("href") for item in other.iter(f"{SVG}a")}


def test_a_wide_chart_is_scrolled_and_not_made_too_small(site: Site) -> None:
    site.write("index.rst", "Title\n=====\n\n.. aseme-diagram::\n   :model: iac.robot\n\n" + LARGE)
    assert site.build(strict=True) == (0, "")
    (svg,) = svgs(site.page())
    found = re.search(r"min-width:(\d+)px", svg.get("style", ""))
    assert found is not None and int(found[1]) > 600
    assert '<div style="overflow-x:auto"><svg' in site.page()


def test_a_formula_is_drawn_by_its_name(site: Site) -> None:
    site.write("index.rst", "Title\n=====\n\n.. aseme-diagram::\n   :at: second\n\n" + LARGE)
    assert site.build(strict=True) == (0, "")
    (svg,) = svgs(site.page())
    assert "UndoSomething3" in texts(svg) and "DoSomething3" not in texts(svg)
