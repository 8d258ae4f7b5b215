"""Whether `asemec prove` refutes mistakes: `python -m benchmarks.protocol_mutants [NUMBER] [SEED]`.

The models are protocols of the library, and small ones of the tests. Mutants of them
(`tests/support/model_mutants.py`) are drawn with a seed until NUMBER of them compile. Each is played many
times on the runtime, with random durations, delays and decisions. A run shows a fault if an agent waits for
ever, an agent fails, a clause is broken, or a message is taken by nobody although nothing was late. One of
the questions that such runs answer has to be refuted. If all are proved, that is an error; a mutant of which
none is refuted and some are undecided is counted.

SPIN says nothing of these: its models have no timers, variables or contents (`tests/interop/exports`).
"""

from __future__ import annotations

import argparse
import random
import re
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from aseme_dsl.amola.aip import Aip  # noqa: E402
from aseme_dsl.compiler.phases import inspect_files, scenarios_of  # noqa: E402
from aseme_dsl.play.run import play  # noqa: E402
from aseme_dsl.project.building.build import choose  # noqa: E402
from aseme_dsl.project.building.project import Compiled, compile_root, options_of  # noqa: E402
from aseme_dsl.project.playing.operate import generate_version  # noqa: E402
from aseme_dsl.project.proving.prove import prove_alone  # noqa: E402
from aseme_dsl.project.proving.results import Result, Verdict  # noqa: E402
from aseme_dsl.project.proving.scopes import Scope, scope_of  # noqa: E402
from aseme_dsl.proofs.explore.search import Limits  # noqa: E402
from aseme_dsl.runtime.monitor import rules  # noqa: E402
from aseme_dsl.runtime.trace.records import Record  # noqa: E402
from aseme_dsl.runtime.version.loading import Loaded, load_system  # noqa: E402
from aseme_dsl.source import Source  # noqa: E402
from tests.cli.test_prove import BUY, LATE  # noqa: E402
from tests.support.model_mutants import KINDS, ModelMutant, in_turns, model_mutants, shuffled  # noqa: E402

LIBRARY = ("propose", "request", "query")
OWN = {"buy": BUY, "ask": LATE}
_TOGETHER = 200
"""So many scenarios are in a file."""
LENGTH = 600
"""So many seconds a run lasts: more than all durations and delays of a conversation together."""
RUNS = 60
"""So many runs with each of the two ways to draw durations."""


@dataclass(frozen=True)
class Candidate:
    """A mutant of a protocol."""

    protocol: str
    mutant: ModelMutant


@dataclass
class Faults:
    """What shows in the runs of a mutant: by the name of the question, in how many."""

    runs: int = 0
    found: Counter[str] = field(default_factory=Counter)


def texts() -> Mapping[str, str]:
    """The text of each protocol."""
    found = {name: text for name, text in OWN.items()}
    library = (ROOT / "stdlib" / "protocols.aseme").read_text("utf-8")
    for name in LIBRARY:
        alone = re.sub(rf"(?ms)^aip (?!{name} ).*?^}}\n", "", library)
        found[name] = f"system Mutant\n{alone}"
    return found


def candidates(seed: int) -> Iterator[Candidate]:
    """All mutants of what stands in the protocols, in the order in which they are drawn."""
    queues = []
    for name, text in texts().items():
        chance = random.Random(f"{name}/{seed}")
        first = text[: text.index(f"aip {name} ")].count("\n") + 1
        last = first + re.split(r"(?m)^}", text[text.index(f"aip {name} ") :])[0].count("\n")
        by_kind: dict[str, list[Candidate]] = {kind: [] for kind in KINDS}
        for mutant in model_mutants(text):
            if first < mutant.line <= last:
                by_kind[mutant.kind].append(Candidate(name, mutant))
        queues.append(shuffled(by_kind.values(), chance))
    yield from in_turns(queues)


def scope_for(name: str, text: str) -> tuple[Scope, Compiled] | None:
    """A protocol alone, with one agent a participant; None if it does not compile."""
    source = Source("mutant.aseme", text)
    compiled = compile_root(source)
    if compiled.system is None:
        return None
    aip = next((item for item in compiled.system.aips if item.name == name), None)
    if aip is None:
        return None
    scope = scope_of(source, aip, 1)
    assert isinstance(scope.root, Source)
    return None if compile_root(scope.root).system is None else (scope, compiled)


# ---- runs ----------------------------------------------------------------------------------------


def decided(aip: Aip, text: str) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """The variables that activities decide: the participant, the variable, and values to try."""
    for part in aip.participants:
        for variable in part.variables:
            rest = re.search(rf"(?m)^ *var {variable.name} *:.*?//.*", text)
            if rest is not None and str(variable.type) in ("bool", "int"):
                yield (
                    part.name,
                    variable.name,
                    ("true", "false") if str(variable.type) == "bool" else ("0", "2"),
                )


def scenario(chance: random.Random, scope: Scope, plans: Loaded, aip: Aip, text: str, turn: int) -> str:
    """A way to play a protocol, by chance; every other one has short durations and no delay."""
    is_calm = turn % 2 == 0
    lines = [f"  {name} : {role}" for name, role in scope.team]
    lines.append(f"  network delay 0ms..{0 if is_calm else chance.choice((0, 500, 20_000))}ms")
    wanted = list(decided(aip, text))
    for name, role in scope.team:
        plan = plans.charts[role].PLAN
        activities = sorted({state.activity for state in plan.states if state.activity})
        part = aip_part(name, aip)
        most = {item: 1 if is_calm else chance.choice((1, 300, 9000, 40_000)) for item in activities}
        for activity in activities:
            sets = "".join(
                f" sets {variable} = {chance.choice(values)}"
                for other, variable, values in wanted
                if other == part and re.search(rf"var {variable} *:.*// {activity}\b", text)
            )
            lines.append(f"  activity {activity} takes 0ms..{most[activity]}ms{sets}")
    return f'scenario "{turn}" {{\n' + "\n".join(dict.fromkeys(lines)) + f"\n  for {LENGTH}s\n}}\n"


def aip_part(agent: str, aip: Aip) -> str:
    """The participant that an agent plays."""
    return next(part.name for part in aip.participants if agent.rstrip("0123456789") == part.name)


def faults_of(name: str, text: str, seed: int, number: int = RUNS) -> Faults:
    """What shows in runs."""
    found = Faults()
    made = scope_for(name, text)
    if made is None:
        return found
    scope, compiled = made
    assert compiled.system is not None and isinstance(scope.root, Source)
    aip = next(item for item in compiled.system.aips if item.name == name)
    with TemporaryDirectory(prefix="mutant-") as folder:
        file = Path(folder) / "mutant.aseme"
        file.write_text(scope.root.text)
        whole = compile_root(file)
        assert whole.system is not None
        package, _ = generate_version(whole.system, Path(folder) / "made", choose(whole.configuration))
        loaded = load_system(package)
        turns = range(2 * number)
        for first in turns[::_TOGETHER]:
            some = turns[first : first + _TOGETHER]
            ways = [
                scenario(random.Random(f"{name}/{seed}/{turn}"), scope, loaded, aip, text, turn)
                for turn in some
            ]
            file.write_text("\n".join((scope.root.text, *ways)))
            scenarios = scenarios_of(inspect_files(file, None, options_of(whole.configuration)), {})
            assert len(scenarios) == len(ways), "each scenario can be played"
            for turn, item in zip(some, scenarios, strict=True):
                found.runs += 1
                found.found.update(seen_in(loaded, item.scripts[0], turn, is_calm=turn % 2 == 0))
    return found


def seen_in(loaded: Loaded, script: object, seed: int, *, is_calm: bool) -> set[str]:
    """The questions that a run answers with a fault."""
    found: set[str] = set()
    first: dict[str, frozenset[str]] = {}
    now: dict[str, frozenset[str]] = {}
    over: set[str] = set()
    passed: set[str] = set()
    talked: set[str] = set()
    """The agents that have taken part in a conversation: others still wait for one."""

    def listen(record: Record) -> None:
        match record["kind"]:
            case "step":
                if record["time"] > 500_000_000:
                    passed.add(record["agent"])
                if record.get("finished"):
                    over.add(record["agent"])
                if "configuration" in record:
                    now[record["agent"]] = frozenset(record["configuration"])
                    first.setdefault(record["agent"], now[record["agent"]])
            case "conversation" if record["what"] in ("open", "join"):
                talked.add(record["agent"])
            case "error":
                found.add("failures")
                over.add(record["agent"])
            case "unexpected" if is_calm and not passed and record.get("performative") != "not_understood":
                found.add("orphan messages")

    most = LENGTH * 1_000_000_000
    played = play(loaded, script, seed, {}, lambda name: None, most, listeners=[listen])  # type: ignore[arg-type]
    for state, item in zip(played.states, script.expectations, strict=True):  # type: ignore[attr-defined]
        if item.of and state.verdict is rules.Verdict.BROKEN:
            found.add(" ".join(item.span.text.split()).removeprefix("clause "))
    if any(name in talked - over and where != first[name] for name, where in now.items()):
        found.add("deadlock")
    return found


# ---- verdicts ------------------------------------------------------------------------------------


def answers(name: str, text: str, states: int, seconds: float) -> Mapping[str, Result]:
    """What `asemec prove` says of a protocol, by the names of the questions."""
    made = scope_for(name, text)
    assert made is not None
    scope, compiled = made
    return {item.name: item for item in prove_alone(scope, compiled, Limits(states, seconds))}


def main() -> int:
    """Print the tables; 1 if a fault that shows in a run is proved not to be there."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("number", nargs="?", type=int, default=100, help="mutants that compile")
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("--only", metavar="NAME", help="only protocols whose name contains NAME")
    parser.add_argument("--first", type=int, default=1, help="leave out the mutants before this one")
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--states", type=int, default=20_000)
    parser.add_argument("--seconds", type=float, default=120.0)
    parser.add_argument("--for", dest="minutes", type=float, default=240, help="stop after so many minutes")
    options = parser.parse_args()
    until = time.monotonic() + 60 * options.minutes
    counts: Counter[str] = Counter()
    usual: dict[str, Counter[str]] = {}
    for candidate in candidates(options.seed):
        if options.only is not None and options.only not in candidate.protocol:
            continue
        if counts["mutants"] == options.number or time.monotonic() > until:
            break
        mutant = candidate.mutant
        if counts["mutants"] + 1 < options.first:
            counts["mutants" if scope_for(candidate.protocol, mutant.text) else "not compiled"] += 1
            continue
        shown = faults_of(candidate.protocol, mutant.text, options.seed, options.runs)
        if not shown.runs:
            counts["not compiled"] += 1
            continue
        counts["mutants"] += 1
        if shown.found and candidate.protocol not in usual:
            text = texts()[candidate.protocol]
            usual[candidate.protocol] = faults_of(candidate.protocol, text, options.seed, options.runs).found
            print(f"{candidate.protocol} as it is: {dict(usual[candidate.protocol])}", flush=True)
        wanted = [item for item in shown.found if item not in usual.get(candidate.protocol, ())]
        if not wanted:
            counts["nothing shows"] += 1
            print(f"{counts['mutants']}: {candidate.protocol}:{mutant.line}: nothing shows", flush=True)
            continue
        found = answers(candidate.protocol, mutant.text, options.states, options.seconds)
        verdicts = {item: found[item].verdict for item in wanted if item in found}
        counts[f"shows in {candidate.protocol}"] += 1
        said_so = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.PROVED)
        worst = next((item for item in said_so if item in verdicts.values()), Verdict.PROVED)
        counts[f"shows, {worst}"] += 1
        where = f"{candidate.protocol}:{mutant.line}"
        print(f"{counts['mutants']}: {where}: {mutant.kind}: {worst}", flush=True)
        print(f"    - {mutant.before}\n    + {mutant.after}")
        for item in wanted:
            said = found[item].text[:200] if item in found else "is not asked"
            print(f"    {item} in {shown.found[item]} of {shown.runs} runs: {said}", flush=True)
    for word, count in counts.items():
        print(f"{count:5} {word}")
    return int(counts[f"shows, {Verdict.PROVED}"] > 0)


if __name__ == "__main__":
    sys.exit(main())
