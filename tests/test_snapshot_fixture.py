"""The `snapshot` fixture, used by a test as a person writes it."""

from __future__ import annotations

import inspect
from pathlib import Path

import pytest

CONFTEST = Path(__file__).with_name("conftest.py")

TEST = """
def test_poem(snapshot):
    snapshot("roses\\nviolets\\n", "poem.txt")
"""


@pytest.fixture
def project(pytester: pytest.Pytester) -> pytest.Pytester:
    """A project with our conftest and one test in a folder of its own."""
    pytester.makeini("[pytest]\nasyncio_default_fixture_loop_scope = function\n")  # else it warns each time
    pytester.makeconftest(CONFTEST.read_text(encoding="utf-8"))
    (pytester.path / "room").mkdir()
    (pytester.path / "room" / "test_poem.py").write_text(inspect.cleandoc(TEST), encoding="utf-8")
    return pytester


def stored(project: pytest.Pytester, name: str = "poem.txt") -> Path:
    return project.path / "room" / "snapshots" / name


def test_a_missing_snapshot_fails_and_says_how_to_create_it(project: pytest.Pytester) -> None:
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*no snapshot*poem.txt*", "*pytest *test_poem --snapshot-update*"])
    assert not stored(project).exists()


def test_update_writes_the_file_and_the_next_run_passes(project: pytest.Pytester) -> None:
    project.runpytest_inprocess("--snapshot-update").assert_outcomes(passed=1)
    assert stored(project).read_bytes() == b"roses\nviolets\n"
    project.runpytest_inprocess().assert_outcomes(passed=1)


def test_a_difference_is_shown_as_a_unified_diff(project: pytest.Pytester) -> None:
    project.runpytest_inprocess("--snapshot-update")
    stored(project).write_bytes(b"roses\ntulips\n")
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*-tulips", "*+violets", "*--snapshot-update*"])
    assert stored(project).read_bytes() == b"roses\ntulips\n"


def test_a_difference_in_line_ends_only_is_a_visible_difference(project: pytest.Pytester) -> None:
    project.runpytest_inprocess("--snapshot-update")
    stored(project).write_bytes(b"roses\r\nviolets\n")
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*-roses␍", "*+roses"])


def test_an_update_does_not_touch_what_is_the_same(project: pytest.Pytester) -> None:
    project.runpytest_inprocess("--snapshot-update")
    before = stored(project).stat().st_mtime_ns
    project.runpytest_inprocess("--snapshot-update")
    assert stored(project).stat().st_mtime_ns == before


def test_bytes_say_where_they_differ(project: pytest.Pytester) -> None:
    test = project.path / "room" / "test_poem.py"
    test.write_text("def test_poem(snapshot):\n    snapshot(bytes(range(40)), 'sub/poem.bin')\n", "utf-8")
    project.runpytest_inprocess("--snapshot-update").assert_outcomes(passed=1)
    path = stored(project, "sub/poem.bin")
    path.write_bytes(path.read_bytes()[:30])
    result = project.runpytest_inprocess()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*30 bytes, now it is 40; they differ from byte 30 on*"])


def test_a_snapshot_cannot_leave_its_folder(project: pytest.Pytester) -> None:
    test = project.path / "room" / "test_poem.py"
    test.write_text("def test_poem(snapshot):\n    snapshot('x', '../../poem.txt')\n", "utf-8")
    project.runpytest_inprocess("--snapshot-update").assert_outcomes(failed=1)
    assert not (project.path / "poem.txt").exists()
