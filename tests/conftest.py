"""What every test has: the `snapshot` fixture, Hypothesis without deadlines, surroundings that are known."""

from __future__ import annotations

import difflib
import gc
import os
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

from tests.support.drawings import remember_drawings
from tests.support.forgetting import forget_what_is_left
from tests.support.lanes import IS_LONG
from tests.support.libraries import remember_libraries
from tests.support.surroundings import settle

# How fast an example runs depends on the machine, so it decides no test. In CI the examples are the
# same every time: a red run can be repeated.
settings.register_profile("local", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("ci", settings.get_profile("local"), derandomize=True, print_blob=True)
# Hypothesis also tries constants of all modules of ours. These differ with what other tests
# have imported, and it reads each module for them, also each that a test generates.
providers._get_local_constants = lambda: providers._local_constants
settings.load_profile("ci" if os.environ.get("CI") else "local")

Snapshot = Callable[[str | bytes, str], None]


def pytest_sessionstart() -> None:
    settle()
    remember_drawings()
    remember_libraries()
    # Classes of thousands of generated modules stay: to look for cycles among them takes a tenth of the time.
    gc.set_threshold(100_000, 50, 100)


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """What all tests share stays to the end: whoever looks at all objects is spared looking at these."""
    gc.collect()
    gc.freeze()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--snapshot-update",
        action="store_true",
        default=False,
        help="write what the tests produce into tests/…/snapshots instead of comparing with it",
    )


def pytest_runtest_setup(item: pytest.Item) -> None:
    if not IS_LONG and item.get_closest_marker("long") is not None:
        pytest.skip("takes long: python3 dev.py long")


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    if nextitem is not None and nextitem.path != item.path:
        forget_what_is_left()


@pytest.fixture
def snapshot(request: pytest.FixtureRequest) -> Snapshot:
    """`snapshot(value, "name.txt")` compares a text or bytes with `snapshots/name.txt` beside the test file.

    A text is compared as UTF-8 with the newlines it has. `pytest --snapshot-update` writes the files.
    """
    folder = request.path.parent / "snapshots"
    update: bool = request.config.getoption("--snapshot-update")
    command = f"pytest {shlex.quote(request.node.nodeid)} --snapshot-update"

    def compare(value: str | bytes, name: str) -> None:
        __tracebackhide__ = True
        path = folder / name
        if not path.resolve().is_relative_to(folder.resolve()):
            raise ValueError(f"a snapshot stays in its folder: {name!r}")
        got = value.encode() if isinstance(value, str) else value
        if update:
            _write(path, got)
            return
        if not path.is_file():
            pytest.fail(f"there is no snapshot {path}\nCreate it, and look at what it says: {command}")
        expected = path.read_bytes()
        if got != expected:
            difference = _text_difference(expected, got) if isinstance(value, str) else _place(expected, got)
            pytest.fail(f"not as in {path}\n{difference}\nIf the new one is right: {command}")

    return compare


def _write(path: Path, content: bytes) -> None:
    """Write only what differs, so that an update leaves the other files' times alone."""
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def _text_difference(expected: bytes, got: bytes) -> str:
    """A unified diff; line ends other than `\\n` are shown, since they may be the only difference."""
    before, after = (content.decode(errors="backslashreplace").split("\n") for content in (expected, got))
    lines = difflib.unified_diff(before, after, "snapshot", "now", lineterm="")
    return "\n".join(line.replace("\r", "␍") for line in lines)


def _place(expected: bytes, got: bytes) -> str:
    common = min(len(expected), len(got))
    first = next((i for i in range(common) if expected[i] != got[i]), common)
    window = slice(max(first - 8, 0), first + 24)
    return (
        f"the snapshot has {len(expected)} bytes, now it is {len(got)}; they differ from byte {first} on\n"
        f"  snapshot … {expected[window]!r} …\n  now      … {got[window]!r} …"
    )
