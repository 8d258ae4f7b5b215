"""The MkDocs plugin, in sites that are built."""

from __future__ import annotations

import logging
import os
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from xml.etree import ElementTree

import pytest
from mkdocs.commands.build import build
from mkdocs.config import load_config
from mkdocs.exceptions import Abort

from aseme_dsl.diagrams.rendering import store
from aseme_dsl.documents.mkdocs import AsemePlugin
from tests.documents.pages import BROKEN, SMALL, WALKER, ids, svgs, texts

CONFIGURATION = """\
site_name: Walkers
use_directory_urls: true
plugins: [aseme]
theme: {name: null, custom_dir: theme}
"""


class Site:
    """A site in a folder, with a theme of nothing but the page."""

    def __init__(self, folder: Path, log: pytest.LogCaptureFixture) -> None:
        self.folder, self.log = folder, log
        self.write("mkdocs.yml", CONFIGURATION)
        self.write("theme/main.html", "{{ page.content }}")
        self.write("docs/walker.aseme", WALKER)

    def write(self, name: str, text: str) -> None:
        path = self.folder / name
        path.parent.mkdir(exist_ok=True, parents=True)
        path.write_text(text)

    def build(self, *, strict: bool = True) -> list[str]:
        """Build it as `mkdocs build` does; the warnings, with paths from its folder."""
        self.log.clear()
        with self.log.at_level(logging.WARNING, "mkdocs"):
            build(load_config(str(self.folder / "mkdocs.yml"), strict=strict))
        return [record.getMessage() for record in self.log.records if record.levelno >= logging.WARNING]

    def page(self, name: str = "") -> str:
        return (self.folder / "site" / name / "index.html").read_text()


@pytest.fixture
def site(tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch) -> Site:
    monkeypatch.chdir(tmp_path)
    return Site(tmp_path, caplog)


def block(text: str = "", info: str = "") -> str:
    return f"```aseme-diagram {info}\n{text}```\n"


def test_the_plugin_is_found_by_its_name(site: Site) -> None:
    points = [point for point in metadata.entry_points(group="mkdocs.plugins") if point.name == "aseme"]
    assert points, "the environment is older than the plugin: install the project again"
    assert points[0].load() is AsemePlugin
    site.write("docs/index.md", block(info="file=walker.aseme model=iac.robot"))
    command = [sys.executable, "-m", "mkdocs", "build", "--strict"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    assert len(svgs(site.page())) == 1


def test_a_block_is_shown_and_drawn(site: Site) -> None:
    site.write(
        "docs/index.md", f"---\ntitle: x\n---\n# Title\n\n```aseme diagram=iac.robot\n{SMALL}```\nMore.\n"
    )
    assert site.build() == []
    (svg,) = svgs(site.page())
    assert {"Look", "Wait"} <= set(texts(svg))
    assert "liveness { robot = Look | Wait }" in re.sub("<[^>]*>", "", site.page())
    assert re.search("</figure>\\s*<p>More.</p>", site.page())


def test_a_file_is_drawn_in_a_list_and_beside_others(site: Site) -> None:
    text = f"""\
1. One

    {block(info='file=walker.aseme model=iac.robot caption="It walks & stands"')}
2. Two

{block(info="file=walker.aseme model=srm.robot,iac.robot layout=tree alt=Two")}
"""
    site.write("docs/index.md", text.replace("\n```\n", "\n    ```\n", 1))
    assert site.build() == []
    assert [svg.get("aria-label") for svg in svgs(site.page())] == [
        "Statechart of the role robot: 9 states; activities Walk and Stand",
        "Two",
        "Two",
    ]
    assert re.search(r"<li>\s*<p>One</p>\s*<figure", site.page())
    assert "<figcaption>It walks &amp; stands</figcaption>" in site.page()
    assert len(ids(site.page())) == len(set(ids(site.page()))) > 20


def test_a_picture_beside_the_page(site: Site) -> None:
    site.write("docs/deep/page.md", block(info="file=../walker.aseme model=iac.robot embed=file"))
    site.write("docs/index.md", block(info="file=/walker.aseme model=iac.robot embed=file"))
    assert site.build() == []
    for page in ("", "deep/page"):
        address, alt = re.findall(r'<img src="([^"]*)" alt="([^"]*)"', site.page(page))[0]
        assert alt.startswith("Statechart of the role robot")
        ElementTree.fromstring((site.folder / "site" / page / address).read_bytes())


def test_what_only_shows_such_a_block_is_left_alone(site: Site) -> None:
    text = f"````markdown\n{block(SMALL)}````\n\n```aseme\n{SMALL}```\n\n```aseme-diagram\nnever closed\n"
    site.write("docs/index.md", text)
    assert site.build() == []
    assert "<figure" not in site.page()
    assert "```aseme-diagram" in site.page()


def test_a_mistake_is_a_warning_with_the_line_of_the_page(site: Site) -> None:
    text = f"---\ntitle: x\n---\n\n# Title\n\n{block(SMALL)}\n{block(BROKEN)}"
    (line,) = [number for number, line in enumerate(text.split("\n"), 1) if "Loook" in line]
    site.write("docs/index.md", text)
    said = f"docs/index.md:{line}: error[E204]: no formula has the activity `Loook`; did you mean `Look`?"
    assert [item.partition(": ")[2] for item in site.build(strict=False)] == [said]
    assert len(svgs(site.page())) == 2  # those of the block above
    assert f"docs/index.md:{line}:" in site.page()
    with pytest.raises(Abort):
        site.build()


def test_what_cannot_be_drawn(site: Site) -> None:
    wrong = [
        (block(info="file=nowhere.aseme"), "nowhere.aseme"),
        (block(info="file=walker.aseme model=iac.robt"), "did you mean iac.robot?"),
        (block(info="file=walker.aseme dept=2"), "did you mean 'depth'?"),
        (block(info="file=walker.aseme depth=2 depth=3"), "'depth' is given twice"),
        (block(info='file=walker.aseme caption="x'), "a quote is not closed"),
        (block(SMALL, "file=walker.aseme"), "a file or a text, not both"),
        (block(), "needs a file, or the text"),
        (block("system Nothing\n"), "nothing to draw"),
    ]
    site.write("docs/index.md", "\n".join(text for text, _ in wrong))
    found = site.build(strict=False)
    assert len(found) == len(wrong)
    for warning, (_, said) in zip(found, wrong, strict=True):
        assert re.match(r"(\S+: )?docs/index\.md:\d+: ", warning)
        assert said in warning
    assert site.page().count("aseme-problem") == len(wrong)


def test_pictures_are_kept_in_a_folder(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    site.write("mkdocs.yml", CONFIGURATION.replace("[aseme]", "[{aseme: {cache: kept}}]"))
    site.write("docs/index.md", block(info="file=walker.aseme model=iac.robot"))
    assert site.build() == []
    assert [path.suffix for path in (site.folder / "kept").iterdir()] == [".svg"]
    monkeypatch.setattr(store, "render", lambda *rest, **more: pytest.fail("drawn again"))
    assert site.build() == []


def test_a_server_watches_what_was_drawn(site: Site) -> None:
    site.write("shared.aseme", WALKER.split("\n", 1)[1].partition("srm")[0])
    site.write("team.aseme", 'system Walker\nimport "shared.aseme"\nsrm' + WALKER.partition("srm")[2])
    site.write("docs/index.md", block(info="file=../team.aseme model=iac.robot"))
    config = load_config(str(site.folder / "mkdocs.yml"))
    build(config)
    plugin = config.plugins["aseme"]
    assert isinstance(plugin, AsemePlugin)
    watched: list[str] = []

    class Server:
        def watch(self, path: str) -> None:
            watched.append(os.path.relpath(path))

    plugin.on_serve(Server())  # type: ignore[arg-type]
    assert watched == ["shared.aseme", "team.aseme"]
    site.write("more.aseme", SMALL)
    site.write("docs/index.md", block(info="file=../more.aseme model=iac.robot"))
    build(config)
    assert watched == ["shared.aseme", "team.aseme", "more.aseme"]
