"""What was read of a text, for another process and for the text as it is after an edit."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.parsing.copies import dump, load, moved
from aseme_dsl.grammar.parsing.parts import Parts, TooSlow
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source

ROOT = Path(__file__).parents[2]
FILES = sorted(
    path for folder in ("examples", "stdlib", "tests") for path in ROOT.glob(f"{folder}/**/*.aseme")
)

TEXT = """\
system T
message Note { int number }
srm one { liveness { one = A . B } }
srm two { liveness { two = C . D } }
"""


def plain(part: object) -> object:
    """A part of a tree as tuples; two formulas are equal only if they are the same."""
    if isinstance(part, tuple):
        return tuple(map(plain, part))
    if isinstance(part, Source) or not dataclasses.is_dataclass(part):
        return part
    return type(part), *(plain(getattr(part, item.name)) for item in dataclasses.fields(part))


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_what_another_process_reads_is_the_same(path: Path) -> None:
    source = Source(str(path), path.read_text("utf-8"))
    found = parse(source)
    assert plain(load(dump(found, source), source)) == plain(found)


@pytest.mark.parametrize(
    ("before", "after"),
    [(TEXT, TEXT.replace("A . B", "A . Other . B")), (TEXT, "\n" + TEXT), (TEXT, TEXT[:-1] + " \n")],
)
def test_places_move_with_an_edit(before: str, after: str) -> None:
    first, second = Source("t", before), Source("t", after)
    file = moved(parse(first)[0], first, second)
    names = [item.name for item in file.declarations if isinstance(item, (tree.Srm, tree.Message))]
    assert [name.span.text for name in names] == ["Note", "one", "two"]
    assert {name.span.source for name in names} == {second}
    (_, *roles) = (item for item in file.declarations if not isinstance(item, tree.System))
    assert [item.span.text.split()[0] for item in roles] == ["srm", "srm"]


def slow_at(word: str) -> Parts:
    """Reads nothing that has this word in it."""

    def read(source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
        if word in source.text:
            raise TooSlow("longer than 1 s")
        return parse(source)

    return Parts(parse=read)


def declared(parts: Parts, text: str) -> tuple[list[str], list[tuple[str, str]]]:
    """The declarations of a text, and what is wrong with it, each with its line."""
    source = Source("t", text)
    found = parts.read(source)
    said = [
        (item.code, source.line(found.layout.whole(item.span).line) if item.span else "")
        for item in found.diagnostics
    ]
    return [item.span.text.split("{")[0].strip() for item in found.file.declarations], said


def test_what_cannot_be_read_is_as_it_was() -> None:
    parts = slow_at("Sloth")
    names, said = declared(parts, TEXT)
    assert said == []
    slow = TEXT.replace("A . B", "A . Sloth").replace("two = C", "two = E")
    assert declared(parts, slow) == (names, [("E116", "srm one { liveness { one = A . Sloth } }")])
    assert declared(parts, TEXT) == (names, [])


@pytest.mark.parametrize("broken", ["two = C", "Note { int"])
def test_what_is_broken_beside_it_is_said(broken: str) -> None:
    text = TEXT.replace("A . B", "A . Sloth").replace(broken, broken + " § (")
    _, said = declared(slow_at("Sloth"), text)
    assert [code for code, _ in said if code == "E116"] == ["E116"] and len(said) > 1


def test_what_was_never_read_declares_nothing() -> None:
    names, said = declared(slow_at("Sloth"), TEXT.replace("A . B", "A . Sloth"))
    assert (len(names), [code for code, _ in said]) == (3, ["E116"])
    # A file that cannot be read in parts is not read at all.
    names, said = declared(slow_at("Sloth"), TEXT.replace("A . B", "A . Sloth") + "/* not closed\n")
    assert names == [] and [code for code, _ in said] == ["E116"]
