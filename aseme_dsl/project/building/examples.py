"""Examples: what the compiler says to the example of a diagnostic's page."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic, in_order
from aseme_dsl.diagnostics.pages import Example
from aseme_dsl.diagnostics.problems.files import NoSystem
from aseme_dsl.project.building.project import options_of
from aseme_dsl.project.settings.configuration import FILE, Configuration, configuration_of
from aseme_dsl.source import Source


def diagnostics_of(example: Example) -> tuple[Diagnostic, ...]:
    """What `asemec check` would say to the files of an example, of which the first `.aseme` file is the root.

    The files are compiled where they stand, in memory. An example that is a console has nothing to compile.
    """
    if example.console:
        return ()
    found: list[Diagnostic] = []
    texts = {file.name: file.text for file in example.files}
    configuration = Configuration(Path())
    if FILE in texts:
        configuration, problems = configuration_of(Source(FILE, texts[FILE]))
        found += problems
    root = next((file for file in example.files if file.language == "aseme"), None)
    if root is not None:
        analysis = analyse(Source(root.name, root.text), texts, options_of(configuration))
        found += [
            item
            for item in analysis.diagnostics
            if not (analysis.is_library and isinstance(item.problem, NoSystem))
        ]
    return in_order(found)
