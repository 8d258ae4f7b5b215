"""Completion anywhere: it never fails, and what it offers can be written where it is offered."""

from __future__ import annotations

import random
from itertools import islice
from pathlib import Path

import pytest

from aseme_dsl.editor.files.known import known_in
from aseme_dsl.editor.files.place import end_of_declaration, place_at
from aseme_dsl.editor.typing.completion import complete
from aseme_dsl.grammar import parse
from aseme_dsl.source import Source
from tests.editor.authoring import PATH, accepted, opened
from tests.support.mutations import slips

ROOT = Path(__file__).parents[2]
FILES = sorted((ROOT / "tests/acceptance").glob("*.aseme"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_completion_never_fails(path: Path) -> None:
    text = path.read_text("utf-8")
    known = known_in(opened(text))
    chance = random.Random(5)
    for slip in islice(slips(text, seed=1), 40):
        offset = chance.randrange(len(slip.text) + 1)
        complete(Source(PATH, slip.text), offset, known)
        complete(Source(PATH, slip.text[:offset]), offset, known)


@pytest.mark.parametrize(
    "garbage", ["", "‸", "{{{{", "}}}}", '"', "/*", "//", "a." * 50, "[" * 300, "\0\r\r\n"]
)
def test_any_text_has_an_answer(garbage: str) -> None:
    known = known_in(opened(FILES[0].read_text("utf-8")))
    for frame in ("{}", "srm r {{ liveness {{ r = {}", "aip p {{ control c {{ enter x : {}"):
        text = frame.format(garbage)
        for offset in (0, len(text) // 2, len(text)):
            complete(Source(PATH, text), offset, known)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_is_offered_can_be_written_there(path: Path) -> None:
    text = path.read_text("utf-8")
    known = known_in(opened(text))
    chance = random.Random(7)
    for _ in range(35):
        offset = chance.randrange(len(text) + 1)
        items = complete(Source(PATH, text), offset, known)
        place = place_at(text, offset)
        for item in chance.sample(items, min(3, len(items))):
            shown = f"{item} at {text[item.start - 60 : item.start]!r}"
            changed = accepted(text, item)
            stop = len(changed) - (len(text) - item.end)
            # The grammar takes it, and would take something behind it.
            before = text[place.first : item.start]
            assert place_at(before + changed[item.start : stop] + " ", stop - place.first + 1).expected, shown
            # What is a list of tokens for the grammar has no mistake in it but what is still to come.
            end = end_of_declaration(text, max(place.first, place.start))
            piece = changed[place.first : end + len(changed) - len(text)]
            for problem in parse(Source(PATH, piece))[1]:
                assert problem.span is not None
                inside = item.start <= problem.span.start + place.first
                written = item.start + len(changed[item.start : stop].rstrip(" .:="))
                assert not inside or problem.span.end + place.first >= written, (shown, problem.message)
