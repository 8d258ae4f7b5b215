"""Pages that list what there is: keys of the configuration, declarations of the standard library, pages."""

from __future__ import annotations

import re
from dataclasses import fields

import pytest

from aseme_dsl.project.settings.configuration import Configuration, RunConfiguration
from aseme_dsl.project.settings.deployment import Deployment, TlsFiles
from aseme_dsl.project.settings.platform_settings import MangoConfiguration, SpadeConfiguration
from aseme_dsl.standard_library import standard_library
from tests.docs.pages import ROOT

DOCS = ROOT / "docs"


@pytest.mark.parametrize(
    "table",
    [Configuration, RunConfiguration, Deployment, TlsFiles, SpadeConfiguration, MangoConfiguration],
    ids=lambda table: table.__name__,
)
def test_the_configuration_has_every_key(table: type) -> None:
    page = (DOCS / "reference/configuration.md").read_text("utf-8")
    keys = {item.name for item in fields(table)} - {"folder", "path"}
    assert sorted(key for key in keys if not re.search(rf"[`.]{key}[`\].]", page)) == []


def test_the_standard_library_is_listed_whole() -> None:
    page = (DOCS / "reference/standard-library.md").read_text("utf-8")
    for path in sorted(standard_library().glob("*.aseme")):
        assert f"\n## `{path.stem}`\n" in page
        part = page.split(f"\n## `{path.stem}`\n")[1].split("\n## ")[0]
        declared = re.findall(
            r"^(?:let|function|topic|message|enum|aip|srm) (\w+)", path.read_text("utf-8"), re.M
        )
        assert sorted(name for name in set(declared) if f"`{name}`" not in part) == [], path.name


@pytest.mark.parametrize("part", ["tutorials", "howto", "explanation", "project", "explanation/coming-from"])
def test_the_index_of_a_part_names_its_pages(part: str) -> None:
    index = (DOCS / part / "index.md").read_text("utf-8")
    pages = {path.name for path in (DOCS / part).glob("*.md")} - {"index.md"}
    assert sorted(name for name in pages if f"]({name})" not in index) == []
