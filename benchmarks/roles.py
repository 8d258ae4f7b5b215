"""How long it takes to explore each role: `python -m benchmarks.roles [TARGET …] [--seconds S] [--team]`.

A team of one agent of the role is explored, with nothing asked, and regions that do not meet apart. With
`--team`, it is the first agent of the role in the team, among the others, which may do anything. A line has
the states that were found, the moves that were made, and the seconds of the processor's time. A search is cut
after so many seconds; then the line says of how many states all moves were made. Default: all examples.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from aseme_dsl.project.building.build import choose  # noqa: E402
from aseme_dsl.project.building.project import compile_root  # noqa: E402
from aseme_dsl.project.playing.operate import generate_version, loaded_for  # noqa: E402
from aseme_dsl.proofs.explore.explored import Assumed, Explored  # noqa: E402
from aseme_dsl.proofs.explore.needed import Needed  # noqa: E402
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search  # noqa: E402
from aseme_dsl.runtime.version.loading import Loaded  # noqa: E402


def roots(targets: list[Path]) -> Iterator[Path]:
    """The files of the targets: files, or the first ones of projects, which import the others."""
    for target in targets:
        yield from [target] if target.is_file() else sorted(target.glob("*.aseme"))[:1]


def explored(loaded: Loaded, team: Sequence[tuple[str, str]], role: str, seconds: float) -> str:
    """What the search of one role has found."""
    others = frozenset(name for name, _ in team) - {next(name for name, other in team if other == role)}
    begun = process_time()
    graphs: list[Graph] = []
    group, apart = 0, tuple[Needed, ...]()
    while group == 0 or group < len(apart):
        eyes = Eyes()
        agent = Explored(loaded, team, Assumed(), [eyes], others=others, group=group, apart=apart)
        agent.judged.clear()
        graphs.append(search(agent, eyes, None, Limits(states=1_000_000, seconds=seconds)))
        group, apart = group + 1, agent.apart
    took = process_time() - begun
    states = sum(len(graph.parents) for graph in graphs)
    moves = sum(graph.moves for graph in graphs)
    done = sum(len(graph.edges) for graph in graphs)
    end = "whole" if all(graph.cut is None for graph in graphs) else f"cut, {done} states done"
    end += f", {len(apart)} groups of regions" if len(apart) > 1 else ""
    end += f"; left out: {agent.left_out}" if agent.left_out else ""
    return f"{states:7} states {moves:8} moves {took:7.2f} s  {end}"


def main() -> int:
    """Print a line for each role."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("target", nargs="*", type=Path, default=sorted((ROOT / "examples").iterdir()))
    parser.add_argument("--seconds", type=float, default=8.0, help="a search of a role is cut after so many")
    parser.add_argument("--team", action="store_true", help="explore a role among the others of its team")
    options = parser.parse_args()
    for root in roots(options.target):
        compiled = compile_root(root)
        if compiled.system is None:
            print(f"{root}: it does not compile", file=sys.stderr)
            return 1
        with TemporaryDirectory(prefix="roles-") as folder:
            package, _ = generate_version(compiled.system, Path(folder), choose(compiled.configuration))
            loaded = loaded_for(package, compiled.configuration.folder.resolve())
            agents = [(agent.name, agent.role) for item in compiled.system.teams[:1] for agent in item.agents]
            for role in loaded.charts:
                team = agents if options.team and role in dict(agents).values() else [(role, role)]
                found = explored(loaded, team, role, options.seconds)
                print(f"{root.stem:14} {role:14} {found}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
