"""What the drawings of goals, use cases, protocols and roles show can be read, by day and by night."""

from __future__ import annotations

import os
import random
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

import aseme_dsl
from aseme_dsl.amola.aip import Aip, Participant
from aseme_dsl.amola.sag import Actor, Goal, Sag
from aseme_dsl.amola.suc import Role, RoleType, Suc, UseCase
from aseme_dsl.diagrams import Layout, Options, draw_model, draw_statechart, render
from aseme_dsl.diagrams.look.colours import DARK, LIGHT
from tests.diagrams.building import FIGURE_4, SPAN, statechart
from tests.diagrams.overlaps import hidden_texts, overlaps

ROOT = Path(__file__).parents[2]
FILES = sorted(
    path
    for folder in ("examples", "tests/acceptance")
    for path in (ROOT / folder).rglob("*.aseme")
    if re.search(r"^system ", path.read_text("utf-8"), re.MULTILINE)
)


@cache
def pictures(path: Path) -> dict[str, str]:
    """The drawings of all models of a file but for its statecharts."""
    system = aseme_dsl.compile(path)
    models = [*([system.sag] if system.sag.actors else []), *([system.suc] if system.suc.usecases else [])]
    made = [draw_model(model) for model in (*models, *system.aips, *system.srms)]
    return {item.name: render(item, "svg").decode() for item in made}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_no_text_is_on_a_line_or_on_another(path: Path) -> None:
    for name, svg in pictures(path).items():
        assert overlaps(svg) == [], name


def test_the_files_have_all_protocols_of_the_library() -> None:
    declared = {
        name
        for file in (ROOT / "stdlib").glob("*.aseme")
        for name in re.findall(r"^aip (\w+)", file.read_text("utf-8"), re.MULTILINE)
    }
    drawn = {name.removeprefix("aip.") for path in FILES for name in pictures(path)}
    assert len(declared) == 12
    assert declared <= drawn


# ---- what the test above would notice -------------------------------------------------------------


def robocup(name: str) -> str:
    return next(made[name] for made in map(pictures, FILES) if name in made)


def texts(svg: str) -> list[re.Match[str]]:
    return list(re.finditer(r'<text [^>]*?x="([-\d.]+)" y="([-\d.]+)"[^>]*>', svg))


def moved(svg: str, text: re.Match[str], x: float, y: float) -> str:
    """The drawing with a text elsewhere."""
    other = text[0].replace(f'x="{text[1]}" y="{text[2]}"', f'x="{x}" y="{y}"')
    return svg[: text.start()] + other + svg[text.end() :]


def on_another(svg: str) -> str:
    one, other = texts(svg)[-2:]
    return moved(svg, one, float(other[1]), float(other[2]) - 4)


def on_a_line(svg: str) -> str:
    line = re.findall(r'class="edge[^"]*">(?s:.*?)<path [^>]*d="M([-\d.]+),([-\d.]+)', svg)[0]
    return moved(svg, texts(svg)[0], float(line[0]) - 8, float(line[1]) + 4)


def over_its_border(svg: str) -> str:
    return moved(svg, texts(svg)[-1], float(texts(svg)[-1][1]) + 300, float(texts(svg)[-1][2]))


def too_large(svg: str) -> str:
    return svg.replace('font-size="11.00"', 'font-size="40.00"', 1)


def lines_on_one_another(svg: str) -> str:
    """Another line goes the way of the first one, back."""
    one, other = re.findall(r'class="edge[^"]*">(?s:.*?)<path [^>]*d="([^"]*)"', svg)[:2]
    return svg.replace(other, f"M{' L'.join(reversed(re.findall(r'[-0-9.]+,[-0-9.]+', one)))}")


def through_a_head(svg: str) -> str:
    """The first line goes on through the head of its arrow, and beyond."""
    ends = re.findall(r'<path [^>]*d="(M[^"]*)"/>\n<polygon [^>]*points="([-\d.]+),([-\d.]+)', svg)
    (first, *_), (_, x, y) = ends[0], ends[-1]
    return svg.replace(
        first, f"M{float(x) - 60:.2f},{float(y) + 5:.2f}L{float(x) + 60:.2f},{float(y) + 5:.2f}"
    )


FAULTS: tuple[tuple[str, Callable[[str], str], str], ...] = (
    ("sag", on_another, " is on "),
    ("suc", on_another, " is on "),
    ("srm.player", on_another, " is on "),
    ("sag", on_a_line, "a line crosses "),
    ("suc", on_a_line, "a line crosses "),
    ("sag", over_its_border, " is outside"),
    ("aip.attack", over_its_border, " is outside"),
    ("suc", too_large, "a line crosses "),
    ("sag", lines_on_one_another, "lines run on one another"),
    ("suc", lines_on_one_another, "lines run on one another"),
    ("sag", through_a_head, "runs through the head of an arrow"),
)


@pytest.mark.parametrize(("name", "fault", "words"), FAULTS)
def test_a_fault_in_a_drawing_is_noticed(name: str, fault: Callable[[str], str], words: str) -> None:
    svg = robocup(name)
    assert overlaps(svg) == []
    found = overlaps(fault(svg))
    assert any(words in item for item in found), found


# ---- any model ------------------------------------------------------------------------------------

NAMES = some.text("abcdefgh_", min_size=1, max_size=26)
SAYS = some.sampled_from(
    ("", "Score.", "The ball is never where an opponent has reached it first, if we can.")
)


@some.composite
def models(draw: some.DrawFn) -> tuple[Sag, Suc, Aip]:
    names = draw(some.lists(NAMES, min_size=1, max_size=6, unique=True))
    others = some.lists(some.sampled_from(names), max_size=3, unique=True).map(tuple)
    goals = draw(some.lists(NAMES, min_size=1, max_size=7, unique=True))
    sag = Sag(
        tuple(Actor(name, SPAN) for name in names),
        tuple(Goal(name, draw(some.sampled_from(names)), draw(others), draw(SAYS), SPAN) for name in goals),
    )
    cases = (
        UseCase(
            name,
            draw(others),
            tuple(goals[i] for i in range(at + 1, len(goals)) if draw(some.booleans())),
            "",
            (),
            SPAN,
        )
        for at, name in enumerate(goals)
    )
    suc = Suc(tuple(Role(name, RoleType.SYSTEM, SPAN) for name in names), tuple(cases))
    people = (Participant(name, 1, None, (draw(SAYS), name * 3), (), (), (), (), SPAN) for name in names)
    return sag, suc, Aip(names[0], tuple(people), (), (), SPAN)


@settings(max_examples=int(os.environ.get("RANDOM_DRAWINGS", "6")), deadline=None)
@given(models())
def test_any_text_can_be_read(found: tuple[Sag, Suc, Aip]) -> None:
    for model in found:
        assert hidden_texts(render(draw_model(model), "svg")) == []


def dense(seed: int) -> tuple[Sag, Suc]:
    """Goals and use cases with many lines between them."""
    chance = random.Random(seed)

    def names(least: int, most: int) -> list[str]:
        words = ("".join(chance.choices("abcdefgh_", k=chance.randint(1, 26))) for _ in range(most))
        return list(dict.fromkeys(words))[: chance.randint(least, most)]

    people, goals = names(3, 6), names(4, 7)

    def some_of_them() -> tuple[str, ...]:
        return tuple(chance.sample(people, min(3, len(people))))

    sag = Sag(
        tuple(Actor(name, SPAN) for name in people),
        tuple(Goal(name, chance.choice(people), some_of_them(), "", SPAN) for name in goals),
    )
    cases = (
        UseCase(
            name, some_of_them(), tuple(n for n in goals[at + 1 :] if chance.random() < 0.5), "", (), SPAN
        )
        for at, name in enumerate(goals)
    )
    return sag, Suc(tuple(Role(name, RoleType.SYSTEM, SPAN) for name in people), tuple(cases))


FEW = (5, 24, 49)
MANY = os.environ.get("RANDOM_DRAWINGS")


@pytest.mark.parametrize("seed", range(int(MANY) // 2) if MANY else FEW)
def test_lines_are_told_apart_where_many_cross(seed: int) -> None:
    for model in dense(seed):
        assert overlaps(render(draw_model(model), "svg")) == []


# ---- by day and by night --------------------------------------------------------------------------

ON = {
    "ink": ("paper", "node", "choice", "frame", "pill", "q0", "or", "and", "basic"),
    "soft": ("paper", "node", "choice", "frame", "pill", "or", "and", "basic"),
    "number": ("paper", "or", "and", "basic"),
    "p0": ("paper", "or", "and", "basic"),
    "error": ("paper",),
    "cut": ("paper",),
}
BORDERS = {
    "line": ("paper", "or", "and", "basic"),
    "node-border": ("paper", "node"),
    "choice-border": ("paper", "choice"),
    "p0": ("paper", "q0"),
    "frame-border": ("paper", "frame"),
    "transition": ("paper",),
}


def contrast(one: str, other: str) -> float:
    """The contrast ratio of WCAG 2."""

    def light(colour: str) -> float:
        parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
        red, green, blue = (x / 12.92 if x <= 0.03928 else ((x + 0.055) / 1.055) ** 2.4 for x in parts)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    dark, bright = sorted((light(one), light(other)))
    return (bright + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_every_colour_stands_out(theme: dict[str, str]) -> None:
    low = [(ink, on) for ink, fills in ON.items() for on in fills if contrast(theme[ink], theme[on]) < 4.5]
    low += [
        (ink, on) for ink, fills in BORDERS.items() for on in fills if contrast(theme[ink], theme[on]) < 3
    ]
    assert low == []


def test_every_colour_of_a_drawing_has_one_for_the_night() -> None:
    assert LIGHT.keys() == DARK.keys()
    charts = draw_statechart(statechart(FIGURE_4), Options(layout=Layout.NESTED))
    charts += draw_statechart(statechart(FIGURE_4), Options(layout=Layout.TREE))
    drawn = [*map(robocup, ("sag", "suc", "aip.attack", "srm.player"))]
    for svg in (*drawn, *(render(item, "svg").decode() for item in charts)):
        used = set(re.findall(r' (fill|stroke)="([^"]*)"', svg))
        rules = set(re.findall(r'\[(fill|stroke)="(#\w+)"\]\{', svg))
        assert {item for item in used if item[1] not in ("none", "transparent")} == rules


def test_a_drawing_says_what_it_is_and_its_elements_what_they_are() -> None:
    svg = robocup("sag")
    about = "Actors and goals; solid arrow: has the goal · dashed arrow: depends on the actor"
    assert f'role="img" aria-label="{about}"' in svg
    titles = re.findall("<title>([^<]*)</title>", svg)
    assert titles[0] == about
    assert {"actor player", "coordinate_defense depends on player"} <= set(titles)
    assert not any(re.match(r"(goal|actor)\.", title) for title in titles)
