"""A plugin of pytest: the scenarios of `.aseme` files are tests."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from aseme_dsl.play.scenario import Scenario
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.testing.verdicts import ScenarioResult


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--aseme`, and `aseme = true` in the configuration."""
    text = "Collect the scenarios of .aseme files in folders, too."
    parser.getgroup("aseme").addoption("--aseme", action="store_true", help=text)
    parser.addini("aseme", text, type="bool", default=False)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """A file that is named on the command line is always collected, one in a folder if that is wanted."""
    if file_path.suffix != ".aseme":
        return None
    config = parent.config
    is_wanted = config.getoption("--aseme") or config.getini("aseme")
    if not is_wanted and not parent.session.isinitpath(file_path):
        return None
    return AsemeFile.from_parent(parent, path=file_path)


class AsemeFile(pytest.File):
    """A file with scenarios."""

    def collect(self) -> Iterator[pytest.Item]:
        """Its scenarios; none of a file that is only imported.

        Raises:
            CollectError: the file has errors.
        """
        from aseme_dsl.diagnostics import Severity
        from aseme_dsl.diagnostics.render import render_text
        from aseme_dsl.project.building.project import compile_root
        from aseme_dsl.project.testing.playing import scenarios_in

        compiled = compile_root(self.path)
        if compiled.is_library:
            return
        wrong = [item for item in compiled.diagnostics if item.severity is Severity.ERROR]
        if wrong or compiled.system is None:
            raise self.CollectError(render_text(wrong))
        for scenario in scenarios_in(compiled):
            yield ScenarioItem.from_parent(self, name=scenario.name, compiled=compiled, scenario=scenario)


class ScenarioItem(pytest.Item):
    """A scenario as a test."""

    def __init__(
        self, name: str, parent: pytest.Collector, *, compiled: Compiled, scenario: Scenario
    ) -> None:
        super().__init__(name, parent)
        self.compiled = compiled
        self.scenario = scenario
        self.funcargs: dict[str, object] = {}  # other plugins look for fixtures here

    def runtest(self) -> None:
        """Play it. Raises NotPassed."""
        from aseme_dsl.project.building.build import activities_folder, choose
        from aseme_dsl.project.settings.configuration import OUTPUT
        from aseme_dsl.project.testing.playing import play_scenarios

        configuration = self.compiled.configuration
        choice = choose(configuration)
        folder = activities_folder(configuration.output or Path(OUTPUT), choice)
        assert self.compiled.system is not None  # it has no errors
        (result,) = play_scenarios(
            self.compiled.system,
            [self.scenario],
            (configuration.seed,),
            configuration,
            choice,
            folder,
            1,
        )
        if result.verdict != "passed":
            raise NotPassed(result)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: object = None) -> str:
        """The expectation with its place, and what happened last."""
        from aseme_dsl.project.testing.reports import explained

        if isinstance(excinfo.value, NotPassed):
            result = excinfo.value.result
            return "\n".join((f"{result.verdict}, seed {result.seed}", *explained(result, is_coloured=False)))
        return str(super().repr_failure(excinfo))

    def reportinfo(self) -> tuple[Path, int, str]:
        """Where it stands."""
        return self.path, self.scenario.span.line - 1, self.name


class NotPassed(Exception):
    """A scenario has not passed."""

    def __init__(self, result: ScenarioResult) -> None:
        super().__init__(result.reason)
        self.result = result


__all__ = ["AsemeFile", "NotPassed", "ScenarioItem", "pytest_addoption", "pytest_collect_file"]
