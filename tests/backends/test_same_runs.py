"""Agents of monas and of jade_like do the same: in random charts, and in every protocol of the library."""

from __future__ import annotations

from functools import cache

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.chart import chart
from tests.oracle.charts import EVENTS, text
from tests.oracle.choices import Choices
from tests.oracle.test_agreement import ROUNDS, forget
from tests.runtime.playing import MS, Played, play
from tests.stdlib.test_protocols import ENDS, LIMIT, End, generated, kind_of, protocol
from tests.support.generated import Generated, generate
from tests.support.lanes import kept

RANDOM = 12


def told(run: Played) -> list[object]:
    """What happened, but for the lines of generated modules."""
    return [{key: value for key, value in record.items() if key != "traceback"} for record in run.records]


@pytest.mark.parametrize("seed", kept(range(RANDOM), lambda seed: seed < 6))
def test_random_charts(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    written = text(Choices(f"both {seed}"))
    made = [generate(written), generate(written, backend=BACKEND)]
    script = [{"at": f"{n * 20}ms", "event": EVENTS[n % len(EVENTS)]} for n in range(20)]
    try:
        one, other = (told(play(item, until=1000 * MS, script=script)) for item in made)
    finally:
        for item in made:
            forget(item)
    assert one == other


@cache
def shown(name: str) -> Generated:
    return generate(protocol(name).text(), backend=BACKEND)


@pytest.mark.parametrize("end", ENDS, ids=str)
def test_protocols_of_the_library(end: End) -> None:
    item = protocol(end.protocol)
    acts = {**item.acts, **end.acts}

    def played(made: Generated) -> list[object]:
        return told(play(made, {name: kind_of(made, name, what) for name, what in acts.items()}, until=LIMIT))

    assert played(generated(end.protocol)) == played(shown(end.protocol))
