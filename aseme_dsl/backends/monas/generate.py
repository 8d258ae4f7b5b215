"""The monas backend: what the agents of every backend are made of, and nothing else."""

from __future__ import annotations

from dataclasses import dataclass

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions
from aseme_dsl.backends.shared.generate import (
    activity_files,
    environment,
    messages_file,
    rendered,
    role_files,
    source_of,
    system_file,
)
from aseme_dsl.runtime.naming import usable


@dataclass(frozen=True, slots=True)
class MonasBackend:
    """Emits per role `plan.py` and `step.py`, one `messages.py`, and a class template per activity."""

    name: str = "monas"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system, and the activities under `activities/`."""
        templates = environment(options)
        messages = messages_file(system)
        roles = role_files(templates, system, messages, options)
        artefacts = [system_file(templates, system, roles), messages]
        for chart, role in zip(system.iacs, roles, strict=True):
            path = f"{system.name}/{usable(chart.name)}/__init__.py"
            known = {"system": system, "chart": chart, "source": source_of(system), "shown": False}
            artefacts += [rendered(templates, "role.py.j2", path, known), *role.files]
        return (*artefacts, *activity_files(templates, system, options))


BACKEND = MonasBackend()
