"""The plugin of pytest: scenarios are collected where they are asked for, and told like tests."""

from __future__ import annotations

from importlib.metadata import entry_points

import pytest

from tests.cli.support import GOOD

SCENARIOS = """
scenario "it stands" { one : robot  by 1s one in Stand }
scenario "it walks" { one : robot  by 3s one in Walk }
"""
INSTALLED = entry_points(group="pytest11", name="aseme")
"""Nothing where the package was installed before it had a plugin."""
PLUGIN = ("-p", "no:cacheprovider", *(() if INSTALLED else ("-p", "aseme_dsl.pytest_plugin")))


@pytest.fixture
def project(pytester: pytest.Pytester) -> pytest.Pytester:
    pytester.makefile(".aseme", good=GOOD + SCENARIOS, other="message M { int n }")
    pytester.makepyfile(test_it="def test_it(): pass")
    return pytester


def test_a_file_that_is_named_is_collected(project: pytest.Pytester) -> None:
    done = project.runpytest_inprocess(*PLUGIN, "good.aseme")
    done.assert_outcomes(passed=1, failed=1)
    done.stdout.fnmatch_lines(
        [
            "failed, seed 1",
            "*good.aseme:17:36: `one in Walk` has not come by 3 s: one is in Stand",
            "*by 3s one in Walk*",
            "*3 s  one  Stand returns; Stand -> Stand*",
            "FAILED good.aseme::it walks*",
        ]
    )


def test_files_in_folders_are_collected_if_that_is_wanted(project: pytest.Pytester) -> None:
    project.runpytest_inprocess(*PLUGIN).assert_outcomes(passed=1)
    project.runpytest_inprocess(*PLUGIN, "--aseme", "-k", "stands").assert_outcomes(passed=1, deselected=2)
    project.makeini("[pytest]\naseme = true")
    project.runpytest_inprocess(*PLUGIN).assert_outcomes(passed=2, failed=1)


def test_a_file_with_errors_is_an_error(project: pytest.Pytester) -> None:
    project.makefile(".aseme", bad=GOOD.replace("Walk  :", "Wlk  :"))
    done = project.runpytest_inprocess(*PLUGIN, "bad.aseme")
    done.assert_outcomes(errors=1)
    done.stdout.fnmatch_lines(["*bad.aseme:8:11*E400*"])
