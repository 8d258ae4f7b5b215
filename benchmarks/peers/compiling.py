"""The behaviours compiled by this project in all forms that are measured, for the processes that run them."""

from __future__ import annotations

import compileall
from collections.abc import Iterable
from pathlib import Path

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions
from aseme_dsl.backends.monas import BACKEND as MONAS
from aseme_dsl.backends.plain import BACKEND as PLAIN
from aseme_dsl.backends.plain.generate import module_text
from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import has_errors, render_text
from aseme_dsl.project.building.native import NativeError, compiled
from aseme_dsl.project.files.write import Planned
from aseme_dsl.source import Source
from benchmarks.behaviours.aseme import text_of
from benchmarks.behaviours.description import Behaviour


def compiled_into(folder: Path, behaviours: Iterable[Behaviour]) -> None:
    """Write the generated code of each behaviour into a folder of its own: `FOLDER/player/agent/Player/…`."""
    for behaviour in behaviours:
        system = system_of(behaviour)
        options = BackendOptions()
        write(folder / behaviour.name / "agent", MONAS.generate(system, options))
        typed = PLAIN.generate(system, options)
        write(folder / behaviour.name / "typed", typed)
        text = module_text(system, system.iacs[-1], options, PlainOptions(mapping=True))
        module = f"{system.name}/{behaviour.name}.py"
        assert module in [artefact.path for artefact in typed]
        write(folder / behaviour.name / "dict", [*typed, Artefact(module, text)])
        for form in ("typed", "dict"):  # as Python keeps them once they were imported
            compileall.compile_dir(folder / behaviour.name / form, quiet=1)


def compiled_natively(folder: Path, behaviours: Iterable[Behaviour]) -> str:
    """Compile the class of each behaviour to machine code, too; why not, if that cannot be."""
    for behaviour in behaviours:
        files = [
            Planned(artefact.path, artefact.text.encode(), "plain")
            for artefact in PLAIN.generate(system_of(behaviour), BackendOptions())
        ]
        try:
            made = list(compiled(files))
        except NativeError as problem:
            return str(problem)
        for file in (*files, *made):
            path = folder / behaviour.name / "native" / file.path
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.content)
    return ""


def system_of(behaviour: Behaviour) -> System:
    """The system of a behaviour's text.

    Raises:
        ValueError: it does not compile, which the text of a behaviour always should.
    """
    return system_in(behaviour.name, text_of(behaviour))


def system_in(name: str, text: str) -> System:
    """The system in a text.

    Raises:
        ValueError: it does not compile.
    """
    analysis = analyse(Source(f"{name}.aseme", text))
    if has_errors(analysis.diagnostics) or analysis.system is None:
        raise ValueError(render_text(analysis.diagnostics))
    return analysis.system


def write(folder: Path, artefacts: Iterable[Artefact]) -> None:
    """Write generated files."""
    for artefact in artefacts:
        path = folder / artefact.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
