"""Project: roots compiled with the configuration that applies to them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.compiler import Options
from aseme_dsl.compiler.checks.consequences import without_told
from aseme_dsl.compiler.formula.holes import as_notes
from aseme_dsl.compiler.phases import Inspection, inspect_files
from aseme_dsl.diagnostics import Diagnostic, Problem, Suppressed, has_errors, in_order
from aseme_dsl.diagnostics.problems.files import NoSystem
from aseme_dsl.diagnostics.problems.settings import NothingToAllow
from aseme_dsl.diagnostics.problems.use import ResultNotTaken, VariableNotRead
from aseme_dsl.grammar.parsing.parts import NO_PARTS, Layout
from aseme_dsl.project.code.function_code import check_configured, check_functions, function_files
from aseme_dsl.project.files.inputs import Inputs
from aseme_dsl.project.files.stamp import Look, stamp_of
from aseme_dsl.project.settings.configuration import (
    OUTPUT,
    Configuration,
    find_configuration,
    place_of,
    unknown_roles,
)
from aseme_dsl.project.settings.target import project_here, sources_of
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.compiler.read.memory import Memory
    from aseme_dsl.project.building.workshop import Workshop
    from aseme_dsl.project.code.activity_files import Required
    from aseme_dsl.proofs.certificate.certify import Certificate


@dataclass(frozen=True, slots=True)
class Compiled:
    """A root with what is known of it; `system` is None if anything is an error, in its configuration too."""

    root: Path | Source
    configuration: Configuration
    system: System | None
    diagnostics: tuple[Diagnostic, ...]
    files: tuple[str, ...] = ()
    """The paths of what was read."""
    is_library: bool = False
    """Whether the file declares no system, only what other files import."""
    suppressed: tuple[Suppressed, ...] = ()
    """What comments in the sources allow."""
    unchecked: int = 0
    """How many choices' conditions were not compared, because z3 is not installed."""
    depends: tuple[str, ...] = ()
    """Where all that was read or looked for really is."""
    certificates: tuple[Certificate, ...] = ()
    """What was proved of each statechart of the system."""
    layout: Layout = NO_PARTS
    """Where the parts lie in which the models' places are; those of diagnostics are in the files."""
    inspected: Inspection | None = field(default=None, repr=False, compare=False)
    """What the phases have found, if its places are in the files: not in a workshop."""

    @property
    def inspection(self) -> Inspection:
        """What the phases find in the root, with places in the files."""
        return self.inspected or inspect_files(self.root, None, options_of(self.configuration))


@dataclass(frozen=True, slots=True)
class Checked:
    """What is to be said of files: every diagnostic, in order, and what comments in the sources allow.

    `files` are the paths of all that was looked at; `unchecked` is how many choices' conditions were not
    compared, because z3 is not installed.
    """

    diagnostics: tuple[Diagnostic, ...]
    files: tuple[str, ...]
    suppressed: tuple[Suppressed, ...]
    unchecked: int = 0
    compiled: tuple[Compiled, ...] = ()
    """The compiled roots, for a command that watches."""


def inputs_of(targets: Sequence[str], read_standard_input: Callable[[], bytes]) -> Inputs:
    """The files that targets mean (`project/settings/target.py`); without any, those of the project here."""
    return sources_of(targets or [project_here()], read_standard_input)


def options_of(configuration: Configuration, max_states: int | None = None) -> Options:
    """How the project wants to be compiled; `max_states` goes before what it says."""
    largest = max_states or configuration.max_states or Options().largest
    return Options(largest, configuration.diagnostics)


def compile_root(
    root: Path | Source,
    *,
    max_states: int | None = None,
    sources: Mapping[str, str] | None = None,
    activities: Path | None = None,
    output: Path | None = None,
    workshop: Workshop | None = None,
) -> Compiled:
    """Compile a root, and compare the code of its activities with what it says of them.

    `max_states`, the folder of the `activities` and the `output` folder go before the configuration.
    Without activities, the code is looked for where a build would put it. Texts in `sources` (by path) are
    taken instead of the files on disk. In a `workshop`, what is known of the root from before is not found
    out again.

    Raises:
        NotCertified: a statechart is not what its source says, which is a bug of the compiler.
    """
    configuration, problems = configuration_for(Path(path_of(root)))
    if output is not None:
        configuration = replace(configuration, output=output)
    options = options_of(configuration, max_states)
    known = None if workshop is None else workshop.about(path_of(root))
    if workshop is None or known is None:
        inspection, layout = inspect_files(root, sources, options), NO_PARTS
    else:
        inspection = inspect_files(root, sources, options, known.memory, workshop.read)
        layout = inspection.loaded.layout
    analysis = inspection.analysis
    diagnostics = in_order((*problems, *analysis.diagnostics))
    system = None if has_errors(diagnostics) else analysis.system
    if system is not None and len(configuration.files) < 2:  # else a role may be of another system
        diagnostics = in_order((*diagnostics, *unknown_roles(configuration, [c.name for c in system.iacs])))
        system = None if has_errors(diagnostics) else system
    suppressed = analysis.suppressed
    certificates: tuple[Certificate, ...] = ()
    if system is not None:
        from aseme_dsl.project.building.certified import certificates_of

        certificates = certificates_of(inspection)
        memory, look = (None, stamp_of) if workshop is None or known is None else (known.code, workshop.look)
        problems, allowed = code_problems(system, configuration, activities, memory, look)
        problems += check_functions(system, configuration.folder, look)
        problems += check_configured(configuration, look)
        problems = tuple(map(layout.diagnostic, problems))
        diagnostics = without_read(diagnostics, system, configuration, activities, memory, look)
        problems = configuration.diagnostics.apply(problems)
        diagnostics = in_order((*without_told(diagnostics, problems), *problems))
        suppressed += allowed
    files = tuple(source.path for source in system.sources) if system else ()
    return Compiled(
        root,
        configuration,
        system,
        diagnostics,
        files,
        analysis.is_library,
        suppressed,
        analysis.unchecked,
        analysis.files,
        certificates,
        layout,
        inspection if layout is NO_PARTS and sources is None else None,
    )


def configuration_for(root: Path) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    """The configuration that applies to a root, and what is wrong with it."""
    configuration, problems = find_configuration(root.parent)
    if configuration.files and os.path.realpath(root) not in map(os.path.realpath, configuration.files):
        # The project plays its own files; this one is a neighbour.
        configuration = replace(configuration, run=None)
    return configuration, problems


def code_problems(
    system: System,
    configuration: Configuration,
    activities: Path | None,
    memory: Memory | None = None,
    look: Look = stamp_of,
) -> tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]:
    """What the code of the activities gets wrong, where there is some; several systems may share it."""
    folder = code_folder(configuration, activities)
    if folder is None and not system.aips:
        return (), ()  # and nothing is imported that looks at code
    from aseme_dsl.project.code.activity_code import check_code, check_silence

    alone = len(configuration.files) < 2
    if folder is None:
        return check_silence(system, alone=alone, memory=memory)
    required = None
    if activities is not None or configuration.activities is not None:
        required = _required(system, configuration, from_option=activities is not None)
    return check_code(
        system,
        folder,
        alone=alone,
        project=configuration.folder,
        memory=memory,
        look=look,
        required=required,
    )


def _required(system: System, configuration: Configuration, *, from_option: bool) -> Required:
    """Who says that the code has to be there, and who else may use what is in its folder."""
    from aseme_dsl.project.code.activity_files import Required

    root = Path(system.span.source.path).parent if system.span is not None else configuration.folder
    folders = {os.path.realpath(folder): folder for folder in (configuration.folder, root)}.values()
    users = function_files(system, configuration.folder)
    users += [str(path) for folder in folders for path in sorted(folder.glob("*.py"))]
    if configuration.run is not None:
        functions = (configuration.run.world, configuration.run.progress, configuration.run.summary)
        modules = [function.partition(":")[0] for function in functions if function is not None]
        users += [f"{configuration.folder.joinpath(*module.split('.'))}.py" for module in modules]
    others = [path for folder in folders for path in sorted(folder.glob("*.aseme"))]
    place = None if from_option else place_of(configuration, "activities")
    return Required(place, tuple(users), (*configuration.files, *others))


def code_folder(configuration: Configuration, activities: Path | None) -> Path | None:
    """Where the code of the activities may be."""
    output = configuration.output or Path(OUTPUT)
    if activities is None and configuration.activities is None and not output.is_dir():
        return None
    from aseme_dsl.project.building.build import activities_folder, choose

    return activities_folder(output, choose(configuration, activities=activities))


def without_read(
    diagnostics: tuple[Diagnostic, ...],
    system: System,
    configuration: Configuration,
    activities: Path | None,
    memory: Memory | None,
    look: Look = stamp_of,
) -> tuple[Diagnostic, ...]:
    """Without the notes on variables that nothing reads (N725), where the code of an activity does."""
    if not any(isinstance(item.problem, VariableNotRead | ResultNotTaken) for item in diagnostics):
        return diagnostics
    folder = code_folder(configuration, activities)
    if folder is None or not folder.is_dir():
        return diagnostics
    from aseme_dsl.project.code.activity_code import variables_read

    read = variables_read(system, folder, configuration.folder, memory, look)

    def is_read(problem: Problem) -> bool:
        return isinstance(problem, VariableNotRead | ResultNotTaken) and problem.variable in read

    return tuple(item for item in diagnostics if not is_read(item.problem))


def check(
    inputs: Inputs, sources: Mapping[str, str] | None = None, workshop: Workshop | None = None
) -> Checked:
    """All diagnostics of all inputs.

    A file of a folder that declares no system is checked through the files that import it, or else by itself.
    It need not declare a system. Nor need a file with nothing but declarations for other files. Holes are
    notes: nothing is generated. Texts in `sources` (by path) are taken instead of the files on disk.
    """
    found = list(inputs.diagnostics)
    compiled = [
        compile_root(root, sources=sources, output=inputs.output_of(root), workshop=workshop)
        for root in inputs.roots
    ]
    for item in compiled:
        found += [
            one for one in item.diagnostics if not (item.is_library and isinstance(one.problem, NoSystem))
        ]
    seen = {os.path.realpath(path) for item in compiled for path in item.files}
    files = {path_of(root) for root in inputs.roots}
    files |= {item.span.source.path for item in found if item.span is not None}
    for path in inputs.others:
        files.add(str(path))
        if os.path.realpath(path) not in seen:
            alone = compile_root(path, sources=sources, workshop=workshop)
            compiled.append(alone)
            found += [item for item in alone.diagnostics if not isinstance(item.problem, NoSystem)]
    suppressed = once(item for other in compiled for item in other.suppressed)
    unchecked = sum(item.unchecked for item in compiled)
    diagnostics = as_notes(in_order(_without_used(found, suppressed)))
    return Checked(diagnostics, tuple(sorted(files)), suppressed, unchecked, tuple(compiled))


def once(suppressed: Iterable[Suppressed]) -> tuple[Suppressed, ...]:
    """By place, each once: several systems may have read one file."""
    found: dict[tuple[str, int, str, str], Suppressed] = {}
    for item in suppressed:
        assert item.diagnostic.span is not None  # else no comment would be about it
        span = item.diagnostic.span
        key = (span.source.path, span.start, item.diagnostic.code, item.diagnostic.message)
        found.setdefault(key, item)
    return tuple(found[key] for key in sorted(found))


def _without_used(found: Sequence[Diagnostic], suppressed: Iterable[Suppressed]) -> Iterable[Diagnostic]:
    """A comment in a file that several systems share has its use if it allows something in one of them."""
    used = {(item.allow.source.path, item.allow.start) for item in suppressed}
    wrong = has_errors(found)
    for item in found:
        place = (item.span.source.path, item.span.start) if item.span is not None else None
        if not isinstance(item.problem, NothingToAllow) or not (wrong or place in used):
            yield item


def path_of(root: Path | Source) -> str:
    """The path by which people know a root."""
    return root.path if isinstance(root, Source) else str(root)
