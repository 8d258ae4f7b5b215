"""No run breaks what was proved of times, whatever the durations and delays; what is refuted was played."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path
from random import Random

import pytest

from aseme_dsl.compiler.phases import inspect_files, scenarios_of
from aseme_dsl.play.run import play
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root, options_of
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.project.proving.prove import prove
from aseme_dsl.project.proving.results import Verdict
from aseme_dsl.proofs.explore.search import Limits
from aseme_dsl.runtime.monitor import rules
from aseme_dsl.runtime.version.loading import load_system

TEAMS = int(os.environ.get("TIMED_TEAMS", "3"))
RUNS = 12
"""So many seeds a team is played with, in each of the ways."""
LASTS = (50, 100, 150, 200, 300)


def team_of(seed: int) -> tuple[str, tuple[str, ...]]:
    """A team of a sender and a reader, with a property; and the ways to play it."""
    chance = Random(seed)

    def duration() -> str:
        return f"{chance.choice(LASTS)}ms"

    kind = chance.choice(("signal", "state"))
    least, most = sorted(chance.sample((0, 50, 100, 150, 250), 2))
    delay = chance.choice((0, 100, 250))
    lines: list[str] = []
    states = [f"A{number}" for number in range(chance.choice((2, 3)))]
    works = chance.sample(states, chance.choice((0, 1, 1)))
    fails = [name for name in works if chance.random() < 0.4]
    ends = [f"B{number}" for number in range(chance.choice((2, 3)))]
    is_loop = chance.random() < 0.6
    sends = chance.choice(states[1:])
    timer = chance.choice((None, chance.choice(states)))

    def act(name: str) -> str:
        found = []
        if name == sends:
            found.append(f"t.{kind}.Ping.n = 1; write_messages.t.{kind}.Ping")
        if name == timer:
            found.append(f"start_timer(clock, {duration()})")
        return f" / {'; '.join(found)}" if found else ""

    for before, name in zip((None, *states), (*states, None), strict=True):
        way = f"enter {name}" if name is not None else f"leave {before}"
        if before is None:
            event = ""
        elif before in works:
            event = ""
            if before in fails:
                lines.append(f"    {way} : error{act(name or '')}")
        elif timer is not None and chance.random() < 0.5:
            event = "when [expired(clock)]"
        else:
            event = f"after({duration()})"
        lines.append(f"    {way} : {event}{act(name or '')}")
    sender = " . ".join(states)
    declared = [f"{name} waits" for name in states if name not in works]
    for name in works:
        words = [f"every {duration()}"] if chance.random() < 0.5 else []
        words += [f"within {duration()}"] if name in fails else []
        declared += [f"{name} {' '.join(words)}"] if words else []
    read = []
    for before, name in zip(ends, (*ends[1:], None), strict=True):
        way = f"enter {name}" if name is not None else f"leave {before}"
        age = chance.choice(("<", ">=", ">", "<="))
        condition = f"t.{kind}.Ping.n == 1" if kind == "signal" else f"age(t.state.Ping) {age} {duration()}"
        event = chance.choice((f"when [{condition}]", f"when [{condition}]", f"after({duration()})"))
        read.append(f"    {way} : {event}")
    reader = " . ".join(ends)
    x = chance.choice([f"s in {name}" for name in states] + [f"r in {name}" for name in ends])
    y = chance.choice([f"r in {name}" for name in ends] + [f"s in {name}" for name in states])
    bound = f"{chance.choice((50, 100, 150, 200, 250, 300, 400, 500, 750))}ms"
    body = chance.choice(
        (
            f"every {x} leads to {y} within {bound}",
            f"no {y} within {bound} after {x}",
            f"eventually {y} within {bound}",
            f"no {y} before {bound}",
            f"{x} before {y}",
            f"never ({x} and {y})",
        )
    )
    takes = "".join(f"  assume {name} takes {least}ms..{most}ms\n" for name in works)
    network = f"  assume network delay 0ms..{delay}ms\n"
    text = f"""\
system Timed
message Ping {{ int n }}
topic t {{ {kind} Ping }}
srm sender {{
  liveness {{ sender = {f"({sender})~" if is_loop else sender} }}
  activities {{ {"  ".join(declared)} }}
  control sender {{
{chr(10).join(lines)}
  }}
}}
srm reader {{
  liveness {{ reader = {f"({reader})~" if is_loop else reader} }}
  activities {{ {"  ".join(f"{name} waits" for name in ends)} }}
  control reader {{
{chr(10).join(read)}
  }}
}}
team T {{ s : sender  r : reader }}
property "it" {{
{takes}{network}  {body}
}}
"""
    ways = []
    for (first, last), (soon, late) in (
        ((least, most), (0, delay)),
        ((least, least), (delay, delay)),
        ((most, most), (0, 0)),
        ((least, most), (delay, delay)),
    ):
        lasting = "".join(f"  activity {name} takes {first}ms..{last}ms\n" for name in works)
        ways.append(f'scenario "{len(ways)}" {{\n  network delay {soon}ms..{late}ms\n{lasting}  for 3s\n}}\n')
    return text, tuple(ways)


def outcome(seed: int, folder: Path) -> str:
    """The verdict about a team; it is compared with its runs."""
    text, ways = team_of(seed)
    folder.mkdir(exist_ok=True)
    file = folder / "it.aseme"
    file.write_text(text + "".join(ways))
    compiled = compile_root(file)
    if compiled.system is None:
        return "not a team"
    (found,) = prove(compiled, ["it"], 2, Limits(4000, 20.0))
    if found.verdict is not Verdict.PROVED:
        return f"{found.verdict} {found.reason.partition(':')[0]}"
    package, _ = generate_version(compiled.system, folder / "made", choose(compiled.configuration))
    loaded = load_system(package)
    for scenario in scenarios_of(inspect_files(file, None, options_of(compiled.configuration)), {}):
        (script,) = scenario.scripts
        for number in range(1, RUNS + 1):
            played = play(loaded, script, number, {}, lambda name: None, script.until)
            wrong = [
                state
                for state, item in zip(played.states, script.expectations, strict=True)
                if item.of and state.verdict is rules.Verdict.BROKEN
                if state.due is None or state.at >= state.due  # else the run has ended before
            ]
            assert not wrong or played.assumption is not None, (seed, scenario.name, number, played, text)
    return str(found.verdict)


@pytest.mark.parametrize("first", range(0, TEAMS, 6))
def test_no_run_breaks_what_is_proved(first: int, tmp_path: Path) -> None:
    found: Counter[str] = Counter()
    for seed in range(first, min(first + 6, TEAMS)):
        found[outcome(seed, tmp_path / str(seed))] += 1
    assert found["PROVED"] or found["REFUTED "] or TEAMS < 6, found
