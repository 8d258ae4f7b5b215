"""The batch of a system's role beside its plain class, both imported."""

from __future__ import annotations

import importlib
import itertools
import sys
import types
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.batch import BACKEND as BATCH
from aseme_dsl.backends.plain import BACKEND as PLAIN
from aseme_dsl.runtime.plain.batch import Batch
from tests.support.forgetting import forget_folders

_numbers = itertools.count(1)


def made(system: System, folder: Path, role: str) -> tuple[Any, type[Batch]]:
    """The plain class of a role and its batch class."""
    name = f"batched_{next(_numbers)}"
    for backend in (PLAIN, BATCH):
        for artefact in backend.generate(system, BackendOptions()):
            path = folder / name / backend.name / artefact.path
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(artefact.text, encoding="utf-8")
    sys.path.insert(0, str(folder))
    try:
        forget_folders(folder)
        plain = importlib.import_module(f"{name}.plain.{system.name}.{role}")
        batch = importlib.import_module(f"{name}.batch.{system.name}.{role}")
    finally:
        sys.path.remove(str(folder))
    found = [kind for kind in vars(batch).values() if isinstance(kind, type) and issubclass(kind, Batch)]
    (kind,) = [kind for kind in found if kind is not Batch]
    return getattr(plain, kind.__name__.removesuffix("Batch")), kind


@contextmanager
def without_compiling() -> Iterator[None]:
    """Inside, numba compiles nothing: its functions are run as they are, which is slow and soon begun."""
    stand_in = types.ModuleType("numba")
    stand_in.njit = lambda **options: lambda function: function  # type: ignore[attr-defined]
    before = sys.modules.get("numba")
    sys.modules["numba"] = stand_in
    try:
        yield
    finally:
        if before is None:
            del sys.modules["numba"]
        else:
            sys.modules["numba"] = before


class Together:
    """Plain charts, one an instance, and batches of the same, which are given the same."""

    def __init__(self, plain: Any, batch: type[Batch], size: int, engines: tuple[str, ...]) -> None:
        self.scalars = [plain() for _ in range(size)]
        self.batches = {engine: batch(size, engine) for engine in engines}
        self.values = [name for name, _, _, is_seen in batch.ARRAYS if is_seen]
        self.events = [*batch.EVENTS, "nothing of the kind"]

    def start(self) -> None:
        for chart in self.scalars:
            chart.start()
        for batch in self.batches.values():
            batch.start()
        self.compare("start")

    def set(self, instance: int, name: str, value: Any) -> None:
        setattr(self.scalars[instance].bb, name, value)
        for batch in self.batches.values():
            getattr(batch.bb, name)[instance] = value

    def time(self, now: int) -> None:
        for chart in self.scalars:
            if hasattr(type(chart), "now"):
                chart.now = now
        for batch in self.batches.values():
            batch.now = now

    def send(self, event: str, which: list[bool] | None = None) -> None:
        """One step of these instances, or of all; the others must stay entirely as they are."""
        chosen = [True] * len(self.scalars) if which is None else which
        moved = [yes and chart.send(event) for chart, yes in zip(self.scalars, chosen, strict=True)]
        for engine, batch in self.batches.items():
            before = [table.copy() for table in batch._tables]
            found = batch.send(event) if which is None else batch.send(event, which)
            assert found.tolist() == moved, f"{engine}: {event}"
            self.same_but(engine, before, chosen)
        self.compare(event)

    def step(self, which: list[bool]) -> None:
        moved = [yes and chart.step() for chart, yes in zip(self.scalars, which, strict=True)]
        for engine, batch in self.batches.items():
            before = [table.copy() for table in batch._tables]
            assert batch.step(which).tolist() == moved, engine
            self.same_but(engine, before, which)
        self.compare("step")

    def same_but(self, engine: str, before: list[Any], which: list[bool]) -> None:
        for old, new in zip(before, self.batches[engine]._tables, strict=True):
            rows = (old, new) if engine == "numba" else (old.T, new.T)
            for one, other, may_change in zip(*rows, which, strict=True):
                assert may_change or (one == other).all(), f"{engine}: it has changed, and made no step"

    def done(self, label: str, which: list[bool]) -> None:
        import numpy as np

        for chart, ended in zip(self.scalars, which, strict=True):
            if ended:
                chart.done(label)
        for engine, batch in self.batches.items():
            before = [table.copy() for table in batch._tables]
            batch.done(label, np.array(which))
            self.same_but(engine, before, which)
        self.compare(f"done {label}")

    def compare(self, what: str) -> None:
        for engine, batch in self.batches.items():
            for instance, chart in enumerate(self.scalars):
                where = f"{engine}, instance {instance}, {what}"
                assert batch.configuration(instance) == chart.configuration(), where
                for name in self.values:
                    assert getattr(batch.bb, name)[instance] == getattr(chart.bb, name), f"{where}: {name}"
