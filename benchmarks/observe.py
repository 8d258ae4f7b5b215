"""How many events a second `asemec observe` checks: a log of agent messages, and a full trace.

The log is that of the warehouse of the examples, many times over with conversations of other names. Beside
the figure stands how long it takes to read the same lines with Python's parser of JSON and do nothing with
them. The start, in which the model is compiled, is shown by itself. Times are those of the processor.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.observing.model import model_of
from aseme_dsl.project.observing.observe import observe
from aseme_dsl.project.observing.session import Observed, Session
from aseme_dsl.runtime.trace.trace_reading import TraceReader

EXAMPLE = Path(__file__).parent.parent / "examples" / "warehouse"
LINES = 100_000


def main() -> int:
    """Print the figures."""
    with tempfile.TemporaryDirectory(prefix="asemec-observe-") as folder:
        trace = Path(sys.argv[1]) if len(sys.argv) > 1 else recorded(Path(folder))
        log = Path(folder) / "log.jsonl"
        write_log(trace, log)
        compiled = compile_root(EXAMPLE / "warehouse.aseme")
        read = seconds(lambda: deque((json.loads(line) for line in log.open("rb")), maxlen=0) and None)
        empty = Path(folder) / "empty.jsonl"
        empty.write_text("")
        _, start = observed(empty, Session(model_of(compiled)))
        found, spent = observed(log, Session(model_of(compiled)))
        assert not found.is_broken, "the log of the example keeps its protocols"
        show("log of messages", found.events, spent, start, read)
        header = Path(folder) / "header.jsonl"
        header.write_text(TraceReader(trace).header().text + "\n")
        for path in (trace, *(packed(trace, folder, suffix) for suffix in ("jsonl.gz", "mcap"))):
            whole = seconds(lambda: deque((line.record for line in TraceReader(path)), maxlen=0) and None)  # noqa: B023
            _, start = observed(header, Session(None))
            found, spent = observed(path, Session(None))
            show(f"full trace, {path.suffix}", found.events, spent, start, whole)
    return 0


def recorded(folder: Path) -> Path:
    """A trace of the example."""
    trace = folder / "trace.jsonl"
    command = [sys.executable, "-m", "aseme_dsl", "run", str(EXAMPLE), "--quiet", "--trace", str(trace)]
    subprocess.run([*command, "-o", str(folder / "out")], check=False, stdout=subprocess.DEVNULL)
    return trace


def write_log(trace: Path, log: Path) -> None:
    """The agent messages of a trace as a log of another program, many times over."""
    messages = [item.record for item in TraceReader(trace) if item.record["kind"] == "agent_message"]
    end = messages[-1]["time"] * 1e-9
    with log.open("w") as file:
        written = 0
        for turn in range(LINES):
            for record in messages:
                line = {
                    "time": record["time"] * 1e-9 + turn * end,
                    "sender": record["agent"],
                    "receiver": record["to"],
                    "performative": record["performative"],
                    "message": record["message"],
                    "content": record["content"],
                    "protocol": record["protocol"],
                    "conversation": f"{record['conversation']}-{turn}",
                }
                file.write(json.dumps(line) + "\n")
                written += 1
            if written >= LINES:
                return


def observed(path: Path, session: Session) -> tuple[Observed, float]:
    """What came of a log, and the seconds that it took."""
    before = time.process_time()
    found, _ = observe([path], session)
    return found, time.process_time() - before


def seconds(call: Callable[[], object]) -> float:
    """The processor time of a call."""
    before = time.process_time()
    call()
    return time.process_time() - before


def packed(trace: Path, folder: str, suffix: str) -> Path:
    """The same as another kind of file."""
    path = Path(folder) / f"trace.{suffix}"
    command = [sys.executable, "-m", "aseme_dsl", "trace", str(trace), "-o", str(path)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def show(what: str, events: int, spent: float, start: float, read: float) -> None:
    """One line of the report."""
    rest = max(spent - start, 1e-9)
    print(
        f"{what}: {events} events in {spent:.2f} s, of which {start:.2f} s are the start:"
        f" {events / rest:,.0f} a second, {rest / read:.2f} times as long as reading them"
    )


if __name__ == "__main__":
    raise SystemExit(main())
