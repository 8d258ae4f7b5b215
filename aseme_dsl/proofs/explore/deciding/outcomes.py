"""Outcomes: conditions of statecharts are decided as a whole, not member by member.

What a message says that may be otherwise at the next look matters only in what conditions make of it. So a
move is made once for all that its conditions cannot tell apart: it carries all that may be so, a *group*, and
each condition splits it in two.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Container, Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from functools import lru_cache
from itertools import chain
from types import CodeType, ModuleType
from typing import TypeVar, cast

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart

_T = TypeVar("_T")

MOST = 64
"""So many in a group are carried together at the most."""

Supposed = dict[Hashable, object]
"""Questions with their answers."""


@dataclass(slots=True)
class _Asked:
    """What a condition asks next, when it has been given some answers; or whether it is true then."""

    question: Hashable
    answers: Sequence[object]
    ways: dict[object, _Asked | bool] = field(default_factory=dict)
    """What follows an answer, as far as that was looked at."""


class Outcomes:
    """What may be so in the present move, as far as its conditions have not told it apart."""

    def __init__(self, choices: Choices) -> None:
        self._choices = choices
        self._texts: dict[Hashable, str] = {}
        self._group: list[Supposed] = [{}]
        self._now: Supposed | None = None
        """What is supposed while a condition is looked at."""
        self._asked: dict[Hashable, Sequence[object]] = {}
        """What it has asked so far, with all answers."""
        self._script: list[int] = []
        self._widths: list[int] = []
        self._place = 0
        self._splits = 0
        self._mark = 0
        self._is_quiet = False
        self._begun = 0
        self._results: dict[tuple[tuple[int, ...], int], dict[bool, list[Supposed]]] = {}
        """What conditions have been in the present move, by the decisions before."""
        self.is_of_others: Callable[[Hashable], bool] | None = None
        """Whether agents that are not explored decide a question; None if there are none that do."""

    def begin(self, *, is_quiet: bool = False) -> None:
        """A move is made; `is_quiet`: first that in which no condition is true."""
        if self._begun != self._choices.begun:
            self._begun = self._choices.begun
            self._texts.clear()
            self._results.clear()
        self._is_quiet = is_quiet
        self._group = [{}]
        self._now = None
        self._splits = 0

    # ---- while a move is made ------------------------------------------------------------------

    def of(self, question: Hashable, answers: Sequence[_T], text: str) -> _T:
        """One of the answers: inside a condition each of them, else one that is decided now."""
        if len(answers) == 1:
            return answers[0]
        self._texts[question] = text
        if self._now is not None:
            self._asked.setdefault(question, answers)
            if question not in self._now:
                self._now[question] = answers[self._next(len(answers))]
            return cast("_T", self._now[question])
        held = dict.fromkeys(
            answer for item in self._group for answer in ((item[question],) if question in item else answers)
        )
        chosen = self._split(tuple(held), [question])
        self._group = [
            {**item, question: chosen} for item in self._group if item.get(question, chosen) == chosen
        ]
        return cast("_T", chosen)

    def holds(self, chart: Chart, condition: Callable[[], object]) -> bool:
        """Whether a condition is true; what is supposed from now on is all with which it is so.

        The condition is only looked at where it is given other answers than before: the same ones lead to
        the same result. Not if something hears what is asked: that may be more than is answered here.
        """
        if self._now is not None:
            return bool(condition())
        place = self._choices.way(), self._splits
        found = self._results.get(place)
        if found is None:
            made = self._choices.made
            found = self._looked_at(chart, condition)
            if made == self._choices.made:  # nothing was decided meanwhile
                self._results[place] = found
        # What was asked is only gone through where others may decide it.
        asked = chain.from_iterable(item for items in found.values() for item in items)
        is_true = self._split(tuple(sorted(found, reverse=not self._is_quiet)), asked)
        group = found[is_true]
        if len(group) > MOST:
            parts = range(0, len(group), MOST)
            begin = self._split(tuple(parts), chain.from_iterable(group))
            group = group[begin : begin + MOST]
        self._group = group
        return is_true

    def _looked_at(self, chart: Chart, condition: Callable[[], object]) -> dict[bool, list[Supposed]]:
        found: dict[bool, list[Supposed]] = {}
        effects = len(chart.effects)
        known = _Asked((), ((),))
        hears = self._choices.heard is not None
        try:
            for item in self._group:
                self._script.clear()
                self._widths.clear()
                while True:
                    self._place = 0
                    self._now = dict(item)
                    is_so = None if hears else self._known(known, self._now)
                    if is_so is None:
                        self._place = 0
                        self._now = dict(item)
                        self._asked.clear()
                        is_so = bool(condition())
                        del chart.effects[effects:]  # what functions have given is noted at the end
                        with suppress(TypeError):  # an answer that has no hash
                            self._learn(known, self._now, is_so)
                    found.setdefault(is_so, []).append(self._now)
                    if not self._again():
                        break
        finally:
            self._now = None
        return found

    def _known(self, known: _Asked, now: Supposed) -> bool | None:
        """What a condition is known to be with what is supposed `now`, to which it adds answers; if it is."""
        way: _Asked | bool | None = known.ways.get(())
        while type(way) is _Asked:
            question = way.question
            if question not in now:
                now[question] = way.answers[self._next(len(way.answers))]
            try:
                way = way.ways.get(now[question])
            except TypeError:  # an answer that has no hash
                return None
        return cast("bool | None", way)

    def _learn(self, known: _Asked, now: Supposed, is_so: bool) -> None:
        """Note what a condition has asked, and is."""
        last: object = ()
        for question, answers in self._asked.items():
            way = known.ways.get(last)
            if not isinstance(way, _Asked) or way.question != question:
                way = known.ways[last] = _Asked(question, answers)
            known, last = way, now[question]
        known.ways[last] = is_so

    def _split(self, answers: Sequence[_T], asked: Iterable[Hashable]) -> _T:
        """One of the answers, each of which comes of some of what was `asked`."""
        self._splits += 1
        is_of_others = len(answers) > 1 and self.decided_by_others(asked)
        return self._choices.of(("split", self._splits), answers, is_of_others=is_of_others)

    def decided_by_others(self, asked: Iterable[Hashable]) -> bool:
        """Whether agents that are not explored decide something that was asked."""
        return self.is_of_others is not None and any(map(self.is_of_others, dict.fromkeys(asked)))

    def _next(self, width: int) -> int:
        if self._place == len(self._script):
            self._script.append(0)
            self._widths.append(width)
        self._place += 1
        return self._script[self._place - 1]

    def _again(self) -> bool:
        while self._script and self._script[-1] + 1 == self._widths[-1]:
            self._script.pop()
            self._widths.pop()
        if self._script:
            self._script[-1] += 1
        return bool(self._script)

    # ---- when it is made -----------------------------------------------------------------------

    def mark(self) -> None:
        """What is decided in the end is heard before what is heard from now on."""
        self._mark = len(self._choices.heard or ())

    def end(self, is_left: Callable[[Hashable], bool]) -> Iterator[tuple[Hashable, object]]:
        """One of what may be so is: the answers. Those to questions that are left, from now on, too."""
        questions = [*filter(is_left, dict.fromkeys(chain.from_iterable(self._group)))]
        if questions:
            ways = dict.fromkeys(
                tuple((question, item[question]) for question in questions if question in item)
                for item in self._group
            )
            way = self._split(tuple(ways), questions)
            self._group = [
                item
                for item in self._group
                if tuple((question, item[question]) for question in questions if question in item) == way
            ]
        chosen = self._group[0]
        self._group = [chosen]
        heard = self._choices.heard
        if heard is not None:
            heard[self._mark : self._mark] = chosen.items()
        for question, answer in chosen.items():
            if answer is not None:
                self._choices.say(self._texts[question], answer)
            yield question, answer


# ---- charts -------------------------------------------------------------------------------------------


@lru_cache(maxsize=64)
def codes_of(chart: type[Chart]) -> Mapping[str, CodeType]:
    """The codes of the methods of a generated chart that look at conditions, in which `self.holds_open` is
    given each condition as a function."""
    module = sys.modules[chart.__module__]
    source = _source_of(module)
    if source is None:
        return {}
    tree = ast.parse(source)
    own = next(
        (item for item in tree.body if isinstance(item, ast.ClassDef) and item.name == chart.__name__), None
    )
    if own is None:
        return {}
    own.body = [item for item in own.body if isinstance(item, ast.FunctionDef) and _open(item, chart.places)]
    if not own.body:
        return {}
    tree.body = [*(item for item in tree.body if _is_future(item)), own]
    code = compile(ast.fix_missing_locations(tree), module.__file__ or "", "exec")
    (inner,) = (item for item in code.co_consts if isinstance(item, CodeType))
    found = (item for item in inner.co_consts if isinstance(item, CodeType))
    return {item.co_name: item for item in found if not item.co_freevars}


def _source_of(module: ModuleType) -> str | None:
    get = getattr(module.__loader__, "get_source", None)
    try:
        return None if get is None else cast("str | None", get(module.__name__))
    except (ImportError, OSError):
        return None


def _is_future(item: ast.stmt) -> bool:
    return isinstance(item, ast.ImportFrom) and item.module == "__future__"


def _open(method: ast.FunctionDef, slots: Container[str]) -> bool:
    """Give each condition of a method as a function; whether there is any."""
    if method.name.startswith("_holds_") or method.decorator_list:
        return False
    used = [
        item.id for item in ast.walk(method) if isinstance(item, ast.Name) and isinstance(item.ctx, ast.Load)
    ]
    is_any = False
    for item in ast.walk(method):
        if isinstance(item, ast.If) and _is_condition(item.test, used, slots):
            nothing = ast.arguments(posonlyargs=[], args=[], kwonlyargs=[], kw_defaults=[], defaults=[])
            holds = ast.Attribute(ast.Name("self", ast.Load()), "holds_open", ast.Load())
            item.test = ast.Call(holds, [ast.Lambda(nothing, item.test)], [])
            is_any = True
    return is_any


def _is_condition(test: ast.expr, used: Sequence[str], slots: Container[str]) -> bool:
    """Whether a test looks at messages, and leaves nothing behind that is used elsewhere."""
    reads = False
    bound: list[str] = []
    inside: list[str] = []
    for item in ast.walk(test):
        match item:
            case ast.NamedExpr(target=ast.Name(id=name)):
                bound.append(name)
            case ast.Attribute(value=ast.Name(id="self"), attr=name):
                if name.startswith("_holds_"):
                    reads = True
                elif name != "call" and name not in slots:
                    return False
            case ast.Name(id=name, ctx=ast.Load()):
                inside.append(name)
                reads = reads or name == "b"
            case ast.Lambda() | ast.ListComp() | ast.GeneratorExp() | ast.SetComp() | ast.DictComp():
                return False
            case _:
                pass
    return reads and all(inside.count(name) == used.count(name) for name in bound)


__all__ = ["Outcomes", "codes_of"]
