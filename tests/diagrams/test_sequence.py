"""Sequence diagrams: no text crosses a lifeline, whatever is said, and pages and groups lose nothing."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from aseme_dsl.diagrams.look.drawing import PageSize
from aseme_dsl.diagrams.sequence.groups import grouped
from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram
from aseme_dsl.diagrams.sequence.sequence_svg import drawn, pictures
from tests.diagrams.overlaps import Painted, overlaps

S = 1_000_000_000
LONG = "order 17, what the soup of the day, with bread, for the table at the window, as soon as it is hot"

KITCHEN = SequenceDiagram(
    "Kitchen · virtual time",
    tuple(
        Lifeline(name, role) for name, role in (("ann", "boss: manager"), ("bob", "cook"), ("cid", "cook"))
    ),
    (
        Arrow(1 * S, "ann", ("bob", "cid"), "cfp", "Job", "id 1", conversation="net-1"),
        Arrow(2 * S, "cid", ("ann",), "refuse", "Job", LONG, conversation="net-1"),
        Arrow(2 * S, "bob", ("bob",), "inform", "Note", conversation="note-2"),
        Arrow(3 * S, "bob", (), "inform", "Note", "to nobody", conversation="note-2"),
        Mark(4 * S, "ann", "continues to wait (2min)", "net-1"),
        Mark(5 * S, "bob", "breaks down: the pan is hot", "net-1", ends=True),
        Arrow(6 * S, "cid", ("ann",), "propose", "Job", "cost 2", conversation="net-1"),
    ),
    ("left out: 2 messages of 1 conversation",),
)


def texts(svg: str) -> list[str]:
    return re.findall("<text[^>]*>([^<]*)</text>", svg)


def test_what_is_drawn_can_be_read() -> None:
    svg = drawn(KITCHEN)
    assert overlaps(svg) == []
    said = texts(svg)
    assert {"ann", "boss: manager", "cfp Job", "id 1", "net-1", "note-2", "1 s", "6 s"} <= set(said)
    assert "left out: 2 messages of 1 conversation" in said
    assert "<title>2 s  cid → ann\nrefuse Job</title>" in svg
    assert svg.startswith('<svg xmlns="http://www.w3.org/2000/svg"') and 'role="img"' in svg
    assert "prefers-color-scheme:dark" in svg


def _moved(svg: str, said: str, by: float, down: float = 0.0) -> str:
    match = re.search(rf'<text x="([\d.]+)" y="([\d.]+)"([^>]*)>{re.escape(said)}<', svg)
    assert match is not None
    place = f'<text x="{float(match[1]) + by}" y="{float(match[2]) + down}"{match[3]}>{said}<'
    return svg.replace(match[0], place)


FAULTS: tuple[tuple[Callable[[str], str], str], ...] = (
    (lambda svg: _moved(svg, "cfp Job", -40), "a line crosses 'cfp Job'"),
    (lambda svg: _moved(svg, "cfp Job", 0, 8), "a line crosses 'cfp Job'"),
    (lambda svg: _moved(svg, "id 1", 0, -18), "'id 1'"),
    (lambda svg: _moved(svg, "cost 2", 22), "a line crosses 'cost 2'"),
    (lambda svg: _moved(svg, "propose Job", 600), "outside"),
    (lambda svg: svg.replace(">id 1<", f">{LONG}<"), f"crosses '{LONG}'"),
    (lambda svg: svg.replace(">ann<", ">ann, who is the boss of all<"), "crosses 'ann, who"),
)


@pytest.mark.parametrize(("fault", "words"), FAULTS)
def test_a_fault_in_a_diagram_is_noticed(fault: Callable[[str], str], words: str) -> None:
    svg = drawn(KITCHEN)
    broken = fault(svg)
    assert broken != svg
    assert any(words in item for item in overlaps(broken)), overlaps(broken)


def test_who_has_ended_on_one_page_has_no_lifeline_on_the_next() -> None:
    many = tuple(replace(row, moment=row.moment + n * S) for n in range(40) for row in KITCHEN.rows[:2])
    rows = (*KITCHEN.rows[:6], *many)
    made = list(pictures(replace(KITCHEN, rows=rows), PageSize.A4))
    lines = [svg.count('stroke-dasharray="3 3"') for svg in made]
    assert lines == [3, *(2 for _ in lines[1:])] and len(lines) > 2
    assert [f"page {n} of {len(made)}" in svg for n, svg in enumerate(made, 1)] == [True] * len(made)


def test_a_page_that_is_too_narrow_says_so() -> None:
    wide = SequenceDiagram(
        "Wide", tuple(Lifeline(f"agent{n}", f"role{n}") for n in range(30)), KITCHEN.rows[:0]
    )
    (svg,) = pictures(wide, PageSize.A4)
    assert texts(svg)[-1] == "this page fits at 47%"
    assert overlaps(svg) == []


def test_what_agents_of_a_group_say_in_turn_stays_apart() -> None:
    """Who speaks twice begins anew: what each says stays in order."""
    names = [f"w{n}" for n in (1, 2, 4)]
    lifelines = (Lifeline("boss", "boss"), *(Lifeline(name, "worker") for name in names))
    rows = (
        *(Arrow(S, name, ("boss",), "request", "Job", f"n {name}") for name in names),
        *(Arrow(2 * S, name, ("boss",), "cancel", "Job") for name in names[:2]),
        Arrow(3 * S, "boss", tuple(names), "inform", "Note"),
        *(Mark(4 * S, name, "is suspended") for name in names),
        Mark(5 * S, "w2", "breaks down: oil", ends=True),
    )
    made = grouped(SequenceDiagram("Plant", lifelines, rows), most=1)
    assert [line.name for line in made.lifelines] == ["boss", "w[1..2, 4]"]
    said = [f"{row.text} ({row.content})" if isinstance(row, Arrow) else row.text for row in made.rows]
    assert said == [
        "request Job (× 3)",
        "cancel Job (× 2)",
        "inform Note (to all)",
        "is suspended (× 3)",
        "w2: breaks down: oil",
    ]


def test_a_run_without_messages_is_an_empty_picture() -> None:
    for svg in (
        drawn(SequenceDiagram("Talk", (), ())),
        *pictures(SequenceDiagram("Talk", (), ()), PageSize.A4),
    ):
        assert texts(svg) == ["Talk"] and overlaps(svg) == []


def test_what_xml_cannot_hold_is_made_visible() -> None:
    """Other agents choose the names of conversations."""
    odd = 'a\x07 <b> & "c"'
    rows = (Arrow(S, odd, (odd,), "inform", "Note", odd, odd, odd), Mark(S, odd, odd, "talk"))
    svg = drawn(SequenceDiagram(odd, (Lifeline(odd, odd),), rows, (odd,)))
    assert overlaps(svg) == []
    assert texts(svg).count('a␇ &lt;b&gt; &amp; "c"') == 7


# ---- any talk -------------------------------------------------------------------------------------

NAMES = some.text("abcdefgh_3", min_size=1, max_size=22)
WORDS = some.sampled_from(
    ("", "n 1", "a_name_that_is_longer_than_any_column_of_the_page", LONG, LONG * 2, "x" * 90)
)


@some.composite
def talks(draw: some.DrawFn) -> SequenceDiagram:
    names = draw(some.lists(NAMES, min_size=1, max_size=9, unique=True))
    agents = some.sampled_from(names)
    to = some.lists(agents, max_size=3, unique=True).map(tuple)
    rows: list[Row] = []
    for number in range(draw(some.integers(0, 12))):
        conversation = draw(some.sampled_from(("", "talk-1", "contract_net-ann-1")))
        if draw(some.integers(0, 4)) == 0:
            text = draw(WORDS) or "is suspended"
            rows.append(Mark(number * S // 3, draw(agents), text, conversation, ends=draw(some.booleans())))
        else:
            kind, message = draw(some.sampled_from(("inform", "reject_proposal"))), draw(NAMES)
            sent = Arrow(
                number * S // 3, draw(agents), draw(to), kind, message, draw(WORDS), "", conversation
            )
            rows.append(sent)
    lifelines = tuple(
        Lifeline(name, draw(some.sampled_from(("", "robot", "robot: speaker, listener")))) for name in names
    )
    return SequenceDiagram(
        "Talk · virtual time", lifelines, tuple(rows), draw(some.sampled_from(((), (LONG * 3,))))
    )


@settings(max_examples=int(os.environ.get("RANDOM_DRAWINGS", "25")), deadline=None)
@given(talks())
def test_any_talk_can_be_read(talk: SequenceDiagram) -> None:
    assert overlaps(drawn(talk)) == []
    assert overlaps(drawn(grouped(talk, most=2))) == []
    for page in PageSize:
        for svg in pictures(talk, page):
            assert overlaps(svg) == []
            assert Painted(svg).height <= page.room[1] or not talk.rows
