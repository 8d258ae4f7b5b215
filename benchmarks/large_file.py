"""How long a file of 10 000 lines takes to be laid out, to become models and code, and how much memory.

Run by hand: `python3 dev.py long`, or `python benchmarks/large_file.py [LINES]`. Times are CPU seconds of one
process, each phase also as a multiple of parsing, which is what other tools' figures compare with.
"""

from __future__ import annotations

import resource
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.compiler import analyse
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source
from tests.support.large import large_file


def main(lines: int) -> None:
    """Print one line a phase."""
    text = large_file(lines)
    parse(Source("warm.aseme", large_file(100)))
    begun = time.process_time()
    parse(Source("large.aseme", text))
    parsing = time.process_time() - begun
    begun = time.process_time()
    system = analyse(Source("large.aseme", text)).system
    compiling = time.process_time() - begun
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    assert system is not None
    begun = time.process_time()
    artefacts = BACKEND.generate(system, BackendOptions())
    generating = time.process_time() - begun
    begun = time.process_time()
    format_source(Source("large.aseme", text))
    formatting = time.process_time() - begun
    states = sum(len(chart.states) for chart in system.statecharts)
    size = sum(len(artefact.text) for artefact in artefacts) / 1e6
    print(f"{text.count(chr(10))} lines, {len(system.statecharts)} statecharts, {states} states")
    print(f"parse     {parsing:6.2f} s")
    print(f"fmt       {formatting:6.2f} s  {formatting / parsing:5.2f} x parsing  (with parsing)")
    print(f"compile   {compiling:6.2f} s  {compiling / parsing:5.2f} x parsing  (at most {memory:.0f} MB)")
    print(f"generate  {generating:6.2f} s  {generating / parsing:5.2f} x parsing  ({size:.1f} MB of Python)")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
