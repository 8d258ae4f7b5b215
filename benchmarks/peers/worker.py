"""A process that runs one contender: a JSON line of what to do in, a JSON line of what came of it out.

Run as `python -m benchmarks.peers.worker MODULE`, where MODULE is one of `benchmarks.peers.adapters` with
`maker(behaviour, bb)`, or with `running(behaviour, **how)` that makes more of it. Needs nothing but the
library of that adapter: the environment of the peers does not have this project's package.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import json
import logging
import platform
import sys
import time
import tracemalloc
from collections.abc import Callable
from importlib import metadata
from typing import Any

from benchmarks.behaviours.description import Behaviour, from_json
from benchmarks.peers.adapters.python_code import know_functions
from benchmarks.peers.driving import Running, blackboard, driver, follow, with_dictionary


class Worker:
    """An adapter and the machines that it has made."""

    def __init__(self, module: str) -> None:
        self.adapter = importlib.import_module(f"benchmarks.peers.adapters.{module}")
        self.drivers: dict[str, Callable[[int], None]] = {}

    def make(self, behaviour: Behaviour, order: dict[str, Any]) -> Running:
        """A running machine, compiled or of a library."""
        if hasattr(self.adapter, "running"):
            found: Running = self.adapter.running(behaviour, **order.get("how", {}))
            return found
        bb = blackboard(behaviour)
        return with_dictionary(self.adapter.maker(behaviour, bb, **order.get("how", {}))(), bb)

    def answer(self, order: dict[str, Any]) -> dict[str, Any]:
        """Do what is asked for.

        Raises:
            Exception: whatever the contender raises.
        """
        behaviour = from_json(order["behaviour"]) if "behaviour" in order else None
        if behaviour is not None:
            know_functions(behaviour)
        match order["do"]:
            case "version":
                distribution = getattr(self.adapter, "DISTRIBUTION", None)
                runtime = f"{platform.python_implementation()} {platform.python_version()}"
                version = metadata.version(distribution) if distribution is not None else ""
                return {"version": version, "runtime": runtime}
            case "check":
                assert behaviour is not None
                return follow(self.make(behaviour, order), behaviour, order["steps"])
            case "load":
                assert behaviour is not None
                begun = time.process_time()
                running = self.make(behaviour, order)
                seconds = time.process_time() - begun
                self.drivers[behaviour.name] = driver(running, behaviour)
                return {"seconds": seconds}
            case "time" if behaviour is not None:
                # Machines that have not made a step yet: the steps are not to be made again and again.
                drives = [driver(self.make(behaviour, order), behaviour) for _ in range(order["times"])]
                gc.collect()
                begun = time.process_time()
                for drive in drives:
                    drive(1)
                return {"seconds": time.process_time() - begun}
            case "time":
                drive = self.drivers[order["name"]]
                gc.collect()
                begun = time.process_time()
                drive(order["times"])
                return {"seconds": time.process_time() - begun}
            case "memory":
                assert behaviour is not None
                return self.memory(behaviour, order)
        raise ValueError(order["do"])

    def memory(self, behaviour: Behaviour, order: dict[str, Any]) -> dict[str, Any]:
        """Bytes and seconds an instance, without its blackboard."""
        instances = order["instances"]
        if hasattr(self.adapter, "instances"):
            boards, make = self.adapter.instances(behaviour, instances, **order.get("how", {}))
        else:
            # What the instances of a library have in common knows one blackboard.
            boards = [blackboard(behaviour)] * instances
            start = self.adapter.maker(behaviour, boards[0], **order.get("how", {}))

            def make(bb: Any) -> object:
                return start()

        kept = [make(bb) for bb in boards[:2]]  # what is made once for all
        gc.collect()
        begun = time.process_time()
        for bb in boards:
            make(bb)
        seconds = time.process_time() - begun
        kept = [None] * instances
        gc.collect()
        tracemalloc.start()
        before, _ = tracemalloc.get_traced_memory()
        for number, bb in enumerate(boards):
            kept[number] = make(bb)
        gc.collect()
        after, _ = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return {"bytes": (after - before) / instances, "seconds": seconds / instances}


def main(module: str) -> None:
    """Answer orders until there are no more."""
    logging.disable()
    answers = sys.stdout
    with contextlib.redirect_stdout(sys.stderr):
        worker = Worker(module)
        for line in sys.stdin:
            try:
                found = worker.answer(json.loads(line))
            except Exception as error:
                found = {"error": f"{type(error).__name__}: {error}"}
            answers.write(json.dumps(found) + "\n")
            answers.flush()


if __name__ == "__main__":
    main(sys.argv[1])
