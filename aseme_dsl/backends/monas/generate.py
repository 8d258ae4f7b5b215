"""The monas backend: what the agents of every backend are made of, and nothing else."""

from __future__ import annotations

from typing import TYPE_CHECKING

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
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import usable

if TYPE_CHECKING:
    from jinja2 import Environment


@dataclass(frozen=True, slots=True)
class MonasBackend:
    """Emits per role `plan.py` and `step.py`, one `messages.py`, and a class template per activity."""

    name: str = "monas"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system, and the activities under `activities/`."""
        templates = environment(options)
        messages = messages_file(system, options.known)
        roles = role_files(templates, system, options)
        artefacts = [system_file(templates, system, roles), messages]
        seen = [(system if options.templates else role.seen, role.seen) for role in roles]
        packages = options.known.each(_package, seen, templates, source_of(system))
        for package, role in zip(packages, roles, strict=True):
            artefacts += [package, *role.files]
        return (*artefacts, *activity_files(templates, system, options))


def _package(system: System, seen: System, templates: Environment, source: str) -> Artefact:
    """What is imported of a role."""
    chart = seen.iacs[0]
    known = {"system": system, "chart": chart, "source": source, "shown": False}
    return rendered(templates, "role.py.j2", f"{system.name}/{usable(chart.name)}/__init__.py", known)


BACKEND = MonasBackend()
