"""Parsing as the rest of the compiler uses it."""

from __future__ import annotations

import gc
import subprocess
import sys
import tracemalloc
from pathlib import Path

import pytest

from aseme_dsl.grammar import parse
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source
from tests.grammar.reading import ACCEPTANCE, read
from tests.support.large import large_file


def test_importing_the_package_imports_no_textx() -> None:
    code = "import sys, aseme_dsl.grammar, aseme_dsl.grammar.text.tree; print('textx' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "False\n"


@pytest.mark.parametrize("path", ACCEPTANCE, ids=lambda path: path.stem)
def test_the_acceptance_files(path: Path) -> None:
    file = read(path.read_text("utf-8"))
    kinds = [type(declaration).__name__ for declaration in file.declarations]
    assert (
        kinds
        == {
            "contract_net": [
                "System",
                "Message",
                "Message",
                "Message",
                "Message",
                "Aip",
                "Srm",
                "Srm",
                "Team",
            ],
            "kouretes": ["System", "Import", "Sag", "Suc", "Aip", "Srm", "Srm", "Team", "Scenario"],
            "testbehavior": ["System", "Enum", "Message", "Message", "Topic", "Topic", "Srm"],
        }[path.stem]
    )


def test_the_tree_belongs_to_the_source_that_was_given() -> None:
    source = Source("a buffer", "system A\nsrm b { liveness { b = A . . B } }")
    file, [mistake] = parse(source)
    assert file.source is source
    assert file.declarations[0].span.source is source
    assert mistake.span is not None and mistake.span.source is source
    assert str(mistake.span) == "a buffer:2:28"


def test_two_readings_are_independent() -> None:
    assert len(parse(Source("a", "system A {"))[1]) == 1
    assert parse(Source("b", "system A"))[1] == ()


def test_the_collector_is_left_as_it_was() -> None:
    before = gc.get_threshold()
    gc.set_threshold(123, 4, 5)
    try:
        parse(Source("a", "system A {"))
        assert gc.get_threshold() == (123, 4, 5)
    finally:
        gc.set_threshold(*before)


def test_a_large_file() -> None:
    text = large_file(2000)
    assert abs(text.count("\n") - 2000) < 80
    file = read(text)
    kinds = {type(declaration) for declaration in file.declarations}
    assert kinds == {tree.System, tree.Enum, tree.Message, tree.Topic, tree.Aip, tree.Srm, tree.Team}


def test_a_line_needs_ten_kilobytes_at_most() -> None:
    """So ten thousand fit into a hundred megabytes."""
    text = large_file(2_500)
    tracemalloc.start()
    try:
        read(text)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 25_000_000
