"""How long z3 takes to compare the conditions of one choice: on real files and on random choices.

Run by hand: `python benchmarks/conditions.py`. Times are CPU ms a choice, with its examples. A choice
that is not asked about, as its conditions plainly have nothing to do with each other, is not counted.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.amola.system import System
from aseme_dsl.compiler import analyse
from aseme_dsl.compiler.checks.conditions import prover_of
from aseme_dsl.proofs.choice import Seen, judge
from aseme_dsl.source import Source

ROOT = Path(__file__).parents[1]
FILES = [
    *sorted((ROOT / "tests" / "acceptance").glob("*.aseme")),
    ROOT / "examples" / "robocup" / "kouretes.aseme",
    *sorted((ROOT / "tests" / "proofs" / "cases").glob("*.aseme")),
]
RANDOM = 200
MEMBERS = ("m.state.M.a", "m.state.M.b", "m.state.M.x", "n.state.N.a", "v")


def random_choice(random: Random) -> str:
    """A system with a choice of two to five branches, each a condition of up to eight comparisons."""

    def condition(depth: int) -> str:
        match random.randrange(5) if depth else 0:
            case 0 | 1:
                operator = random.choice(("<", "<=", ">", ">=", "==", "!="))
                other = random.choice((*MEMBERS, *(str(number) for number in range(-20, 100, 7))))
                left = random.choice(MEMBERS)
                return (
                    f"{left} + {random.choice(MEMBERS)} {operator} {other}" if depth else f"{left} < {other}"
                )
            case 2:
                return random.choice(("m.state.M.seen", "!m.state.M.seen", "has(n.state.N)"))
            case _:
                word = random.choice(("&&", "||"))
                return f"({condition(depth - 1)} {word} {condition(depth - 1)})"

    count = random.randint(2, 5)
    branches = [f"A{place}" for place in range(count)]
    lines = "\n".join(f"enter {branch} : [{condition(3)}]" for branch in branches)
    return f"""system Random
      message M {{ bool seen  int a  int b  double x }}
      message N {{ int a }}
      topic m {{ state M }}
      topic n {{ state N }}
      srm r {{
        var v : int = 0
        liveness {{ r = ({" | ".join(branches)})~ }}
        control r {{ {lines} }}
      }}"""


def measured(systems: Sequence[System]) -> list[tuple[float, int]]:
    """For each system the CPU ms that its choices took, and how many were asked about.

    The systems share a prover, as all choices of one run do: they declare the same enums and messages.
    """
    prover = prover_of(systems[0].enums, systems[0].messages)
    assert prover.is_there, "install z3: pip install 'aseme-dsl[check]'"
    prover.is_possible([], [])
    found = []
    for system in systems:
        seen: Seen = set()
        begun = time.process_time()
        for chart in system.statecharts:
            judge(chart, prover, seen)
        found.append((1000 * (time.process_time() - begun), len(seen)))
    return found


def compiled(source: Source) -> System:
    """The system of a text without errors."""
    system = analyse(source).system
    assert system is not None, source.path
    return system


def main() -> None:
    """Print one line a file, and how random choices are spread."""
    begun = time.process_time()
    import z3

    print(f"{1000 * (time.process_time() - begun):7.2f} ms to load z3 {z3.get_version_string()}")
    for path in FILES:
        name = str(path.relative_to(ROOT))
        ((spent, number),) = measured([compiled(Source(name, path.read_text("utf-8")))])
        if number:
            print(f"{spent / number:7.2f} ms a choice, {number:3} choices  {name}")
    random = Random(1)
    systems = [compiled(Source(f"random {number}", random_choice(random))) for number in range(RANDOM)]
    times = sorted(spent for spent, number in measured(systems) if number)
    nine_tenths = statistics.quantiles(times, n=10)[-1]
    print(
        f"{statistics.median(times):7.2f} ms, {len(times)} random choices: 9 of 10 below {nine_tenths:.2f} ms"
    )


if __name__ == "__main__":
    main()
