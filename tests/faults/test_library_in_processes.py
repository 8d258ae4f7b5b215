"""The protocols of the library among real processes: the same arrivals in the same order, the same events.

`PROCESS_RUNS` is how often each is played: by `python3 dev.py long` each one 20 times; without it two of them
are, once.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.faults.team import started
from tests.runtime.playing import make
from tests.stdlib.hostile import LIMIT, ended, finish
from tests.stdlib.library import PROTOCOLS, Act, Protocol, disagreement, generated, kind_of, protocol
from tests.support.network import own_name
from tests.support.waiting import LONG

pytest.importorskip("zenoh")

RUNS = int(os.environ.get("PROCESS_RUNS", "1"))
PLAYED = PROTOCOLS if "PROCESS_RUNS" in os.environ else (protocol("contract_net"),)
QUICKER = 10
"""The activities last so much less than in virtual time."""

CODE = """
import importlib

from tests.faults.test_library_in_processes import activity

{activity} = activity("{protocol}", "{activity}", importlib.import_module("monas.{system}.messages"))
"""

Record = Mapping[str, Any]


class _Messages:
    """The messages of a package, made as the library's tests make them."""

    def __init__(self, module: Any) -> None:
        self._module = module

    def message(self, name: str, **members: Any) -> Any:
        return getattr(self._module, name)(**members)


def activity(name: str, what: str, module: Any) -> type[Any]:
    """The class of an activity, for a robot's process."""
    return kind_of(_Messages(module), what, quicker(protocol(name))[what])  # type: ignore[arg-type]


def quicker(item: Protocol) -> dict[str, Act]:
    """The activities, but quicker; who begins waits until all others are there."""

    def less(takes: Any) -> Any:
        if isinstance(takes, Mapping):
            return {agent: less(value) for agent, value in takes.items()}
        return takes / QUICKER

    acts = {name: replace(what, takes=less(what.takes)) for name, what in item.acts.items()}
    return {**acts, item.first: replace(acts[item.first], takes=0.2)}


def project(folder: Path, item: Protocol) -> Path:
    system = item.text().split()[1]
    name = own_name(system)
    (folder / "activities").mkdir(parents=True)
    (folder / "pyproject.toml").write_text(
        f'[tool.asemec]\nfiles = ["t.aseme"]\noutput = "out"\nactivities = "activities"\n'
        f'[tool.asemec.deploy]\nlease = "{LONG:g}s"\n'
    )
    (folder / "t.aseme").write_text(item.text().replace(f"system {system}", f"system {name}"))
    for what in item.acts:
        file = "".join(f"_{letter.lower()}" if letter.isupper() else letter for letter in what).lstrip("_")
        code = CODE.format(activity=what, protocol=item.name, system=name)
        (folder / "activities" / f"{file}.py").write_text(code)
    return folder


def played(folder: Path, item: Protocol) -> list[Record]:
    """The records of a run among processes, of one agent after the other."""
    with started(project(folder, item), "--for", "15s") as run:
        run.process.wait(LONG)
        run.end()
    records = [record for agent in item.parts for record in run.trace(agent)]
    assert {record["agent"] for record in records if record["kind"] == "step"} == set(item.parts), run.lines
    return records


def inputs_of(records: Iterable[Record]) -> dict[tuple[str, int], str]:
    """What each input was, by its identity."""
    found = {}
    for record in records:
        match record["kind"]:
            case "agent_message":
                text = f"{record['performative']} {record['message']} of {record['agent']}"
            case "variable":
                text = f"{record['variable']} = {record['value']}"
            case "activity" if "sequence" in record:
                text = f"{record['activity']} {record['what']}"
            case _:
                continue
        found[record["agent"], record["sequence"]] = text
    return found


def courses(records: list[Record]) -> dict[str, tuple[list[list[str]], list[list[str]]]]:
    """What came to each agent, step by step, and what it did then."""
    known = inputs_of(records)
    found: dict[str, tuple[list[list[str]], list[list[str]]]] = {}
    for record in records:
        if record["kind"] == "step":
            came, done = found.setdefault(record["agent"], ([], []))
            came.append([known.get((who, number), "lost") for who, number in record["inputs"]])
            done.append([item["text"] for item in record["taken"]])
    return found


@pytest.mark.parametrize("item", PLAYED, ids=str)
def test_what_arrives_in_one_order_has_one_effect(item: Protocol, tmp_path: Path) -> None:
    """Among the runs in processes, and the one in virtual time; and each of them ends well."""
    made = generated(item.name)
    classes = {name: kind_of(made, name, what) for name, what in quicker(item).items()}
    agents = [(agent, f"{part}_role") for agent, part in item.parts.items()]
    runs: list[list[Record]] = [finish(*make(made, classes, agents=agents, until=LIMIT)).records]
    runs += [played(tmp_path / str(number), item) for number in range(RUNS)]
    effects: dict[str, list[tuple[list[list[str]], list[list[str]]]]] = {agent: [] for agent in item.parts}
    for records in runs:
        said = ended(records)
        assert disagreement(item, said) == "", said
        assert "NONE" not in said.values() and said, said
        for agent, (came, done) in courses(records).items():
            for other_came, other_done in effects[agent]:
                assert came != other_came or done == other_done, (agent, came)
            effects[agent].append((came, done))
    print(
        {
            agent: f"{len(found)} runs, {len({str(came) for came, _ in found})} orders"
            for agent, found in effects.items()
        }
    )
