"""Network words: `delay 0..300ms loss 20% reorder`, of scenarios, and `delay=0..300ms,loss=20%,reorder` of
command lines and projects."""

from __future__ import annotations

import re
from decimal import Decimal

from aseme_dsl.diagnostics import Problem, closest
from aseme_dsl.diagnostics.problems.scenarios import network as problems
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.runtime.time.clock import UNITS

_PART = re.compile(r"\s*(?P<word>[^\W\d]\w*)(?:(?:\s*=\s*|\s+(?=[\d.]))(?P<value>[\w.%+-]+))?\s*")
_MOMENT = re.compile(r"(\d{1,15}(?:\.\d{1,9})?)(ms|s|min)?", re.ASCII)
_SHARE = re.compile(r"(\d{1,3}(?:\.\d{1,9})?)%", re.ASCII)
_LONGEST = 24 * 3600 * 10**9
"""The longest delay, in ns."""
_MOST = 1000
"""So many characters the words may have."""


class NetworkWordsError(ValueError):
    """The words mean nothing: `problem` says why, `start` and `end` where in the text."""

    def __init__(self, problem: Problem, start: int, end: int) -> None:
        super().__init__(problem.message)
        self.problem = problem
        self.start = start
        self.end = end


def read_network(text: str) -> Network:
    """The network that the words describe. Parts are separated by commas or blanks, values by `=` or a blank.

    Raises:
        NetworkWordsError: they mean nothing, or contradict each other.
    """
    if len(text) > _MOST or not text.strip():
        raise NetworkWordsError(problems.NoNetworkWords(), 0, min(len(text), _MOST))
    given: dict[str, re.Match[str]] = {}
    least = most = 0
    loss = 0.0
    place = 0
    while place < len(text):
        found = _PART.match(text, place)
        if found is None:  # two commas, or an `=` without a word
            raise NetworkWordsError(problems.NoNetworkWords(), place, place + 1)
        word, value = found["word"], found["value"]
        if word not in problems.NETWORK_WORDS:
            near = closest(word, problems.NETWORK_WORDS)
            raise NetworkWordsError(problems.UnknownNetworkWord(word, near), *found.span("word"))
        if word in given:
            raise NetworkWordsError(problems.NetworkWordTwice(word), *found.span("word"))
        given[word] = found
        match word:
            case "delay":
                least, most = _delay(found)
            case "loss":
                loss = _loss(found)
            case _:
                if value is not None:
                    raise NetworkWordsError(problems.ValueOfReorder(value), *found.span("value"))
        place = found.end()
        if place < len(text) and text[place] == ",":
            place += 1
            if not text[place:].strip():
                raise NetworkWordsError(problems.NoNetworkWords(), place - 1, place)
    if "reorder" in given and least == most:
        raise NetworkWordsError(problems.ReorderWithoutRange(), *given["reorder"].span("word"))
    return Network(least, most, loss, "reorder" in given)


def _delay(found: re.Match[str]) -> tuple[int, int]:
    """The shortest and the longest delay, in ns; in a range, the first bound may leave out the unit."""
    first, dots, last = (found["value"] or "").partition("..")
    ends = [_MOMENT.fullmatch(item) for item in ((first, last) if dots else (first,))]
    unit = ends[-1][2] if ends[-1] is not None else None
    if unit is None:
        raise _wrong(found, problems.WrongDelay(found["value"]))
    times = [int(Decimal(item[1]) * UNITS[item[2] or unit]) for item in ends if item is not None]
    if len(times) < len(ends) or max(times) > _LONGEST:
        raise _wrong(found, problems.WrongDelay(found["value"]))
    if times[0] > times[-1]:
        raise _wrong(found, problems.DelayReversed(first, last))
    return times[0], times[-1]


def _loss(found: re.Match[str]) -> float:
    """The probability that a transmission is lost."""
    share = _SHARE.fullmatch(found["value"] or "")
    if share is None or Decimal(share[1]) >= 100:
        raise _wrong(found, problems.WrongLoss(found["value"]))
    return float(Decimal(share[1]) / 100)


def _wrong(found: re.Match[str], problem: Problem) -> NetworkWordsError:
    return NetworkWordsError(problem, *found.span("value" if found["value"] else "word"))
