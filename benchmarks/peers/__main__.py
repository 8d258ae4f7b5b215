"""How fast generated statecharts are: `python -m benchmarks.peers`, with a report and a plot at the end.

Every contender has to reproduce the entries and exits of the reference interpreter before it is timed. The
peers are installed into an environment of their own below `build/peers`, where the report is written, too.

    python -m benchmarks.peers                  all that is measured (about ten minutes)
    python -m benchmarks.peers --without-peers  ours and the code by hand
    python -m benchmarks.peers --only player idle
    python -m benchmarks.peers --file FILE [--role ROLE] [--inputs TRACE]   the roles of anybody's file
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from benchmarks.behaviours.catalogue import BEHAVIOURS, MANY
from benchmarks.behaviours.counts import Course, course_of
from benchmarks.behaviours.description import Behaviour, as_json
from benchmarks.peers.compiling import compiled_into, compiled_natively
from benchmarks.peers.contenders import (
    BY_HAND,
    BY_HAND_SLOTS,
    OURS,
    PEERS,
    SEND,
    SEND_DICT,
    Contender,
    Failed,
    Process,
)
from benchmarks.peers.environment import CACHE, Environment, prepare
from benchmarks.peers.loading import SIMPLE, loadings
from benchmarks.peers.measuring import Results, check_all, time_in_rounds
from benchmarks.peers.report import into_page, missed, written, wrongs
from benchmarks.peers.single import single_figures

CHECKED = 600
"""Steps that are compared with the reference interpreter: more than one turn."""

CHECKED_LARGE = 64
"""The same for the largest behaviour, with which the interpreter is very slow."""

GENERATIONS = 5
"""How often the processes of ours are started anew: where things lie in memory is luck."""

INSTANCES = 10_000

LARGE = 100
"""A C compiler takes long for so many states: they are measured as Python only."""


def main(arguments: Sequence[str]) -> int:
    """Measure, write the report, and say what misses its target; 1 if something of ours does otherwise."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__.splitlines()[0])
    parser.add_argument("--without-peers", action="store_true", help="ours and the code by hand")
    parser.add_argument("--only", nargs="+", choices=list(BEHAVIOURS), help="these behaviours")
    parser.add_argument(
        "--rounds", type=int, default=6, help="rounds of ours in each generation of processes"
    )
    parser.add_argument("--peer-rounds", type=int, default=7, help="rounds with the peers")
    parser.add_argument("--write", type=Path, metavar="PAGE", help="put the figures into a page, too")
    parser.add_argument("--file", type=Path, help="the roles of this .aseme file, instead of the behaviours")
    parser.add_argument("--role", action="append", default=[], help="of the file only this role")
    parser.add_argument(
        "--inputs", action="append", default=[], type=Path, metavar="TRACE", help="what an agent got in a run"
    )
    parser.add_argument("--into", type=Path, default=CACHE, help="the folder of the report")
    options = parser.parse_args(arguments)
    if options.file is not None:
        return of_file(options)
    if options.role or options.inputs:
        parser.error("--role and --inputs go with --file")

    chosen = [behaviour for name, behaviour in BEHAVIOURS.items() if not options.only or name in options.only]
    results = Results()
    say("what the reference interpreter does")
    courses = {behaviour.name: course_of(behaviour, steps_checked(behaviour)) for behaviour in chosen}
    folder = Path(tempfile.mkdtemp(prefix="aseme-peers-"))
    try:
        say("compiling the behaviours")
        compiled_into(folder, [*chosen, *(item for item in many_of(chosen) if item not in chosen)])
        reason = compiled_natively(folder, [item for item in chosen if len(item.states) < LARGE])
        if reason:
            say(f"no machine code: {reason}")
        contenders = [replace(item, how=(*item.how, ("folder", str(folder)))) for item in OURS]
        for generation in range(GENERATIONS):
            say(f"ours, generation {generation + 1} of {GENERATIONS}")
            measure_ours(contenders, chosen, courses, options.rounds, generation, results)
        single_figures(folder, chosen, results)
        if any(behaviour.name == SIMPLE for behaviour in chosen):
            say("loading")
            results.loadings = loadings(folder)
        if not options.without_peers:
            environment = prepare()
            for name, reason in environment.missing.items():
                say(f"not installed: {name} ({reason})")
            sends = [item for item in contenders if item.key in (SEND.key, SEND_DICT.key)]
            measure_peers(sends, environment, chosen, courses, options.peer_rounds, results)
            results.missing = sorted(environment.missing)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    report = written(results, options.into)
    if options.write:
        into_page(results, options.write)
    say(report.read_text("utf-8"))
    say(f"report: {report}")
    for line in missed(results):
        say(f"missed: {line}")
    wrong = wrongs(results)
    for line in wrong:
        say(f"wrong: {line}")
    return 1 if wrong else 0


def of_file(options: argparse.Namespace) -> int:
    """Compare the roles of a file; 1 if it cannot be done."""
    from benchmarks.peers import own, own_report

    try:
        found = own.measured(options.file, options.role, options.inputs, options.peer_rounds, say)
    except ValueError as problem:
        say(str(problem).rstrip())
        return 1
    report = own_report.written(found, options.into)
    say(report.read_text("utf-8"))
    say(f"report: {report}")
    return 0


def steps_checked(behaviour: Behaviour) -> int:
    """How many steps of a behaviour are compared."""
    return CHECKED if len(behaviour.states) < 1000 else CHECKED_LARGE


def measure_ours(
    contenders: Sequence[Contender],
    behaviours: Sequence[Behaviour],
    courses: dict[str, Course],
    rounds: int,
    generation: int,
    results: Results,
) -> None:
    """Time ours and the code by hand, in processes that are started for this."""
    processes = [
        Process(contender, Environment(), generation) for contender in (BY_HAND, BY_HAND_SLOTS, *contenders)
    ]
    try:
        for behaviour in behaviours:
            if generation == 0:
                check_all(processes, behaviour, courses[behaviour.name], steps_checked(behaviour), results)
            time_in_rounds("ours", processes, behaviour, rounds, results)
            say(f"  {behaviour.name}")
        if generation == 0:
            measure_memory(processes, many_of(behaviours), results)
    finally:
        for process in processes:
            process.end()


def measure_peers(
    sends: Sequence[Contender],
    environment: Environment,
    behaviours: Sequence[Behaviour],
    courses: dict[str, Course],
    rounds: int,
    results: Results,
) -> None:
    """Time the peers that could be installed, beside our runtime and the code by hand."""
    there = [peer for peer in PEERS if peer.distribution not in environment.missing]
    beside = (BY_HAND, BY_HAND_SLOTS, *sends)
    processes = [Process(contender, environment) for contender in (*beside, *there)]
    peers = processes[len(beside) :]
    try:
        for process in peers:
            said = process.ask("version")
            results.versions[process.contender.key] = said["version"]
            results.runtimes[process.contender.key] = said["runtime"]
        say("the peers")
        for behaviour in behaviours:
            check_all(peers, behaviour, courses[behaviour.name], steps_checked(behaviour), results)
            time_in_rounds("peers", processes, behaviour, rounds, results)
            say(f"  {behaviour.name}")
        measure_memory(peers, many_of(behaviours)[:1], results)
    finally:
        for process in processes:
            process.end()


def many_of(behaviours: Sequence[Behaviour]) -> Sequence[Behaviour]:
    """Those of which many instances are made, if the small machine is among what is measured."""
    return tuple(MANY.values()) if MANY[1] in behaviours else ()


def measure_memory(processes: Sequence[Process], behaviours: Sequence[Behaviour], results: Results) -> None:
    """What one of many instances costs."""
    for regions, behaviour in MANY.items():
        for process in processes if behaviour in behaviours else ():
            # A library that needs long for one is asked for fewer.
            instances = INSTANCES if process.contender.group != "peer" else INSTANCES // 10
            try:
                found = process.ask("memory", behaviour=as_json(behaviour), instances=instances)
            except Failed:
                continue
            results.memory[regions, process.contender.key] = found["bytes"], found["seconds"]


def say(text: str) -> None:
    """Print at once."""
    print(text, flush=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
