"""The page that compares ten mistakes says what the compiler says today."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.source import Source

ROOT = Path(__file__).parents[2]
COMPARED = ROOT / "benchmarks" / "ten_mistakes"


def test_what_the_page_says_of_asemec() -> None:
    """The peers' part needs the peers: `python benchmarks/ten_mistakes --write PAGE`."""
    behaviour = (COMPARED / "kicker.aseme").read_text("utf-8")
    mistakes = tomllib.loads((COMPARED / "mistakes.toml").read_text("utf-8"))["mistake"]
    page = (ROOT / "docs" / "explanation" / "ten-mistakes.md").read_text("utf-8")
    shown = re.findall(r"```text\n(.*?)```", page, re.DOTALL)
    assert len(shown) == len(mistakes) == 10
    for mistake, text in zip(mistakes, shown, strict=True):
        old, new = mistake["aseme"]
        assert behaviour.count(old) == 1
        found = analyse(Source("kicker.aseme", behaviour.replace(old, new))).diagnostics
        assert text.startswith(render_text(found)), mistake["name"]
