"""Cases: with which seeds and inputs the scripts of a scenario are played."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from random import Random

from aseme_dsl.amola.expression import ParameterValue, Value, walk
from aseme_dsl.play.scenario import Given, Holds, Receives, Says, Scenario, Script
from aseme_dsl.records import dataclass

GIVEN = 100
"""With so many values of its inputs a scenario is played, if they are generated."""


@dataclass(frozen=True, slots=True)
class Case:
    """One run: the number of the script, the seed, the values of the inputs."""

    script: int
    seed: int
    inputs: Mapping[str, object]


def cases_of(scenario: Scenario, seeds: Sequence[int]) -> tuple[Case, ...]:
    """The runs of a scenario. `seeds` are those for which nothing else is said."""
    shares = [
        item.share.seeds
        for script in scenario.scripts
        for item in script.expectations
        if item.share is not None
    ]
    if scenario.refused is not None:
        return (Case(0, seeds[0], {}),)
    chosen = range(1, max(shares) + 1) if shares else seeds
    return tuple(
        Case(number, seed, inputs)
        for seed in chosen
        for number, script in enumerate(scenario.scripts)
        for inputs in inputs_of(script, seed, 1 if shares else GIVEN)
    )


def inputs_of(script: Script, seed: int, count: int) -> Iterator[Mapping[str, object]]:
    """So many values of the inputs of a script: the ends and 0 first, then what the seed gives."""
    if not script.inputs:
        yield {}
        return
    names = [item.name for item in script.inputs]
    first = [dict(zip(names, values, strict=True)) for values in zip(*map(_ends, script.inputs), strict=True)]
    chance = Random(f"given/{seed}")
    if count == 1:  # one for each seed: these first
        yield first[seed - 1] if 1 <= seed <= len(first) else _drawn(script, chance)
        return
    if not _read(script) & set(names):
        yield first[0]  # each value would give the same run
        return
    yield from first
    for _ in range(count - len(first)):
        yield _drawn(script, chance)


def _read(script: Script) -> set[str]:
    """The inputs that something in a script reads."""
    acts = [item.act for item in script.stimuli]
    contents = [act.content for act in acts if isinstance(act, Receives)]
    values: list[Value | None] = []
    for acting in script.activities:
        contents += [item.content for item in acting.writes] + list(acting.sends)
        values += [value for _, value in acting.sets]
    for condition in script.conditions:
        if isinstance(condition, Holds):
            values.append(condition.value)
        elif isinstance(condition, Says):
            values.append(condition.condition)
    values += [value for content in contents for _, value in content.members]
    parts = (part for value in values if value is not None for part in walk(value))
    return {part.name for part in parts if isinstance(part, ParameterValue)}


def _drawn(script: Script, chance: Random) -> Mapping[str, object]:
    return {
        item.name: chance.randint(int(item.least), int(item.most))
        if item.is_whole
        else chance.uniform(item.least, item.most)
        for item in script.inputs
    }


def _ends(item: Given) -> tuple[float, ...]:
    """The least and the greatest value, and the one next to 0."""
    ends = item.least, item.most, min(max(0, item.least), item.most)
    return tuple(int(value) if item.is_whole else float(value) for value in ends)


__all__ = ["Case", "cases_of", "inputs_of"]
