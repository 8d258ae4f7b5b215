"""Formulas taken apart and put together: the model means the same."""

from __future__ import annotations

import re

import pytest

from aseme_dsl.amola.liveness import ungrouped, walk
from aseme_dsl.amola.operators import Operator
from aseme_dsl.editor.changes.extract import extract
from aseme_dsl.editor.changes.inline import inline
from aseme_dsl.editor.changes.rewriting import Refused, after, piece_at
from tests.conftest import Snapshot
from tests.editor.authoring import opened
from tests.editor.test_actions import SOCCER, WAREHOUSE, difference, done, refused
from tests.support.compiling import codes, system

EXTRACT = "Make a formula"
INLINE = "Write `"


def charts(text: str) -> list[object]:
    """The charts of a text, without what their states are called."""
    made = system(text)
    return [
        (
            chart.name,
            [(node.label, node.type, node.activity) for node in chart.states],
            [(item.source, item.target, item.priority) for item in chart.transitions],
        )
        for chart in (*made.eacs, *made.iacs)
    ]


@pytest.mark.parametrize(
    ("name", "text", "selected"),
    [
        ("loop", SOCCER, "(Guard | NoGame)+"),
        ("body", SOCCER, "(Guard | NoGame)"),
        ("option", WAREHOUSE, "[Deliver . Report]"),
        ("sequence", WAREHOUSE, "Deliver . Report"),
        ("process", WAREHOUSE, "AwardTask . AwaitResult"),
    ],
)
def test_a_part_of_a_formula_gets_its_own(name: str, text: str, selected: str, snapshot: Snapshot) -> None:
    changed = done(text.replace(selected, f"«{selected}»", 1), EXTRACT)
    snapshot(difference(text, changed), f"extract_{name}.txt")
    assert codes(changed) == codes(text)
    assert charts(changed) == charts(text)


def test_neighbours_in_a_sequence_get_a_formula() -> None:
    changed = done(WAREHOUSE.replace("Announce . CollectBids", "«Announce . CollectBids»"), EXTRACT)
    assert "announce_then_collect_bids = Announce . CollectBids" in changed
    assert "enter announce_then_collect_bids : / send cfp Task to contractor" in changed
    assert codes(changed) == codes(WAREHOUSE)


def test_what_an_event_leaves_stays_together() -> None:
    text = (
        "system T\nsrm r {\n  liveness { r = «A . B» . C }\n"
        "  activities { A takes 1s  B takes 1s  C takes 1s }\n  control r { enter C : after(3s) }\n}\n"
    )
    assert refused(text, EXTRACT) == "`enter C` would no longer wait for `B` alone: it has an event"


@pytest.mark.parametrize(
    ("formula", "reason"),
    [
        ("«A . B»", "this is the whole formula: it has a name already"),
        ("«A» . B", "`A` has a name already"),
        (
            "A . «B . (C» | D)",
            "select a whole part of the formula: brackets and operators with all that belongs to them",
        ),
        ("A . («B | C» | D)", "some of the branches of `|` would mean something else alone"),
    ],
)
def test_what_cannot_stand_alone_is_refused(formula: str, reason: str) -> None:
    assert refused(f"system T\nsrm r {{\n  liveness {{ r = {formula} }}\n}}\n", EXTRACT) == reason


@pytest.mark.parametrize(
    ("name", "text", "formula"),
    [
        ("guard", SOCCER, "Guard    = "),
        ("action", SOCCER, "action     = "),
        ("initialize", SOCCER, "initialize = "),
    ],
)
def test_a_formula_is_written_where_it_is_used(
    name: str, text: str, formula: str, snapshot: Snapshot
) -> None:
    changed = done(text.replace(formula, f"‸{formula}", 1), INLINE)
    snapshot(difference(text, changed), f"inline_{name}.txt")
    assert codes(changed) == codes(text)
    assert charts(changed) == charts(text)


def test_a_formula_that_is_used_twice_is_written_twice() -> None:
    text = (
        "system T\nsrm r {\n  liveness {\n    r = pick . Rest . pick\n    ‸pick = A | B\n  }\n"
        "  activities { A takes 1s  B takes 1s  Rest takes 1s }\n"
        "  control pick {\n    enter A : [index_is_even]  // or not\n    enter B : else\n  }\n"
        "  var index_is_even : bool = true\n}\n"
    )
    changed = done(text, INLINE)
    assert "r = (A | B) . Rest . (A | B)" in changed
    for line in ("enter A#1 : [index_is_even]  // or not", "enter A#2 : [index_is_even]  // or not"):
        assert line in changed
    assert charts(changed) == charts(text.replace("‸", ""))


STAYING = """system T
srm r {
  var seen : int = 0
  liveness { r = (A . [B | C])~ }
  activities { A takes 1s  B takes 1s  C takes 1s }
  control r {
    enter (B | C) : [seen < 3]
    skip (B | C) : else
    enter B : [seen < 2]
    enter C : else
    on (B | C) : when [seen > 5] / seen = 0
    exit B : / seen = seen + 1
  }
}
"""


def test_what_is_done_in_a_state_goes_with_it() -> None:
    changed = done(STAYING.replace("[B | C]", "[«B | C»]"), EXTRACT)
    assert "    on b_or_c  : when [seen > 5] / seen = 0\n" in changed
    block = changed[changed.index("control b_or_c {") :]
    assert "exit B : / seen = seen + 1" in block and "enter B : [seen < 2]" in block
    assert charts(changed) == charts(STAYING)
    back = done(changed.replace("b_or_c = ", "‸b_or_c = "), INLINE)
    assert charts(back) == charts(STAYING)
    assert codes(back) == codes(STAYING)


def test_a_formula_with_parameters_is_not_written_out() -> None:
    text = (
        "system T\nenum Place { HOME FIELD }\nsrm r {\n"
        "  liveness {\n    r = go(Place.HOME) . go(Place.FIELD)\n    go‸(to) = MoveTo(to) . Rest\n  }\n"
        "  activities { MoveTo(goal : Place) takes 1s  Rest takes 1s }\n}\n"
    )
    assert refused(text, INLINE) == "`go` has parameters: each use of it stands for something else"


def test_the_formula_of_the_role_stays() -> None:
    marked = SOCCER.replace("    goalie   =", "    goa‸lie   =")
    with pytest.raises(StopIteration):
        done(marked, INLINE)


def test_every_part_can_be_taken_out_and_put_back() -> None:
    view = opened(WAREHOUSE)
    piece = piece_at(view.source, WAREHOUSE.index("aip contract_net"))
    taken = 0
    for owner in piece.owners:
        for named in owner.formulas.named.values():
            for node in walk(named.formula):
                term = ungrouped(node)
                if term.operator is Operator.NAME or term is ungrouped(named.formula):
                    continue
                start, end = piece.first + node.span.start, piece.first + node.span.end
                changed = after(WAREHOUSE, extract(view, start, end))
                assert charts(changed) == charts(WAREHOUSE)
                name = next(item for item in re.findall(r"(\w+) = ", changed) if item not in WAREHOUSE)
                back = after(changed, inline(opened(changed), changed.index(f"{name} = ")))
                assert charts(back) == charts(WAREHOUSE)
                assert codes(back) == codes(WAREHOUSE)
                taken += 1
    assert taken == 10


def test_a_broken_text_is_refused() -> None:
    view = opened("system T\nsrm r { liveness { r = (A . B) . } }\n")
    with pytest.raises(Refused):
        extract(view, 30, 37)
