"""From a text to the generated package, imported: for tests that run what the compiler makes."""

from __future__ import annotations

import atexit
import importlib
import itertools
import shutil
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Backend, BackendOptions
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.compiler import Analysis, analyse
from aseme_dsl.diagnostics import has_errors, render_text
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.source import Source
from tests.support.forgetting import forget_folders, forget_with

_numbers = itertools.count(1)


@dataclass(frozen=True)
class Generated:
    """A compiled system with its generated package."""

    system: System
    package: ModuleType
    folder: Path

    @property
    def messages(self) -> ModuleType:
        return importlib.import_module(f"{self.package.__name__}.messages")

    def plan(self, role: str) -> Plan:
        return self.charts[role].PLAN

    @property
    def charts(self) -> dict[str, type[Chart]]:
        return self.package.CHARTS  # type: ignore[no-any-return]

    def chart(self, role: str, agent: str = "robot") -> Chart:
        """A new instance of the step class of a role."""
        return self.charts[role](agent)

    def message(self, name: str, **members: Any) -> Any:
        return getattr(self.messages, name)(**members)


def system_of(text: str, sources: Mapping[str, str] | None = None) -> System:
    """The system of a text that must compile."""
    analysis = analysis_of(text, sources)
    assert not has_errors(analysis.diagnostics), "\n" + render_text(analysis.diagnostics)
    assert analysis.system is not None
    return analysis.system


def analysis_of(text: str, sources: Mapping[str, str] | None = None) -> Analysis:
    """What the compiler says of a text."""
    return _analysis_of(text, frozenset((sources or {}).items()))


@lru_cache(maxsize=1000)
def _analysis_of(text: str, sources: frozenset[tuple[str, str]]) -> Analysis:
    """It does not change, and many tests, those of random charts above all, play the same texts."""
    return analyse(Source("test.aseme", text), sources=dict(sources) or None)


def generate(text: str, sources: Mapping[str, str] | None = None, backend: Backend = BACKEND) -> Generated:
    """Compile a text, write its package into a temporary folder and import it."""
    return imported(system_of(text, sources), backend)


def imported(system: System, backend: Backend = BACKEND) -> Generated:
    """Write the package of a system into a temporary folder and import it under a name of its own."""
    root = Path(tempfile.mkdtemp(prefix="aseme-test-"))
    atexit.register(shutil.rmtree, root, ignore_errors=True)
    name = f"generated_{next(_numbers)}"
    for artefact in backend.generate(system, BackendOptions()):
        top, _, rest = artefact.path.partition("/")
        folder = name if top == system.name else top
        path = root / folder / rest
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
    sys.path.insert(0, str(root))
    try:
        package = importlib.import_module(name)
    finally:
        sys.path.remove(str(root))
        forget_folders(root)
    made = Generated(system, package, root)
    forget_with(made, name)
    return made
