"""A call of the library changes nothing of the whole process, also while several threads call."""

from __future__ import annotations

import asyncio
import decimal
import gc
import locale
import logging
import os
import random
import signal
import socket
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import aseme_dsl
from aseme_dsl.cli.program import run_program
from aseme_dsl.editor.answers.navigation import PythonFolders
from aseme_dsl.editor.files.workspace import Project
from aseme_dsl.editor.server import make_server
from aseme_dsl.grammar import parse
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.settings.platforms import GIVEN, _mango_hosts, given_environment, provided
from aseme_dsl.runtime import Context
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.runtime.workers.process_wide import switching, uncollected
from aseme_dsl.source import Source
from tests.runtime.playing import make
from tests.support.batches import made, without_compiling
from tests.support.generated import generate, system_of
from tests.support.waiting import wait_until

PROGRAM = "system S\nsrm r { liveness { r = A . B } activities { A takes 1s B takes 1s } }\n"


@pytest.fixture(autouse=True, scope="module")
def unfrozen() -> Iterator[None]:
    """Nothing is frozen at first (`tests/conftest.py` freezes): what a call freezes is seen."""
    gc.unfreeze()
    yield
    gc.freeze()


def globals_of_the_process() -> dict[str, object]:
    mask = os.umask(0)
    os.umask(mask)
    return {
        "collector": (gc.get_threshold(), gc.isenabled(), gc.get_freeze_count()),
        "recursion": sys.getrecursionlimit(),
        "switch interval": sys.getswitchinterval(),
        "signals": [signal.getsignal(number) for number in signal.valid_signals()],
        "locale": locale.setlocale(locale.LC_ALL),
        "warnings": list(warnings.filters),
        "logging": (logging.root.level, list(logging.root.handlers), logging.root.manager.disable),
        "environment": dict(os.environ),
        "folder": Path.cwd(),
        "mask": mask,
        "path": list(sys.path),
        "finders": [type(finder) for finder in sys.meta_path],
        "streams": (sys.stdin, sys.stdout, sys.stderr),
        "asyncio": type(asyncio.get_event_loop_policy()),
        "chance": random.getstate(),
        "decimals": repr(decimal.getcontext()),
        "sockets": socket.getdefaulttimeout(),
        "stacks": threading.stack_size(),
        "traced": (sys.gettrace(), sys.getprofile()),
        "hooks": (sys.excepthook, threading.excepthook, sys.unraisablehook),
    }


def test_no_call_changes_one_even_while_it_works() -> None:
    before = globals_of_the_process()["collector"]
    seen: set[object] = set()
    over = threading.Event()

    def watch() -> None:
        while not over.is_set():
            seen.add((gc.get_threshold(), gc.isenabled(), gc.get_freeze_count()))

    def call() -> None:
        for _ in range(5):
            parse(Source("s.aseme", PROGRAM))
            aseme_dsl.analyse(Source("s.aseme", PROGRAM))

    threads = [threading.Thread(target=call) for _ in range(3)]
    watcher = threading.Thread(target=watch)
    watcher.start()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    over.set()
    watcher.join()
    assert seen == {before}


def test_a_call_leaves_all_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "s.aseme"
    path.write_text(PROGRAM, "utf-8")
    aseme_dsl.analyse(path)
    before = globals_of_the_process()
    aseme_dsl.analyse(path)
    parse(Source("s.aseme", PROGRAM))
    assert globals_of_the_process() == before


def test_a_command_puts_it_back(tmp_path: Path) -> None:
    path = tmp_path / "s.aseme"
    path.write_text(PROGRAM, "utf-8")
    before = gc.get_threshold()
    run_program(["check", str(path)])
    assert gc.get_threshold() == before


PROJECT = """
system S
srm r { liveness { r = A . B } activities { A takes 100ms  B takes 100ms } }
team T { one : r }
"""


@pytest.mark.parametrize(
    "command",
    [
        "check s.aseme",
        "build s.aseme -o out",
        "run s.aseme -o out",
        "run s.aseme -o out --real",
        "trace out/trace.jsonl.gz",
        "bench s.aseme --rounds 1 --steps 5 --inputs out/trace.jsonl.gz",
        "diagram s.aseme iac -o drawn",
        "sniff out/trace.jsonl.gz",
    ],
    ids=lambda command: command.split()[0] + "-real" * command.endswith("--real"),
)
def test_commands_and_what_they_call_leave_all_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("s.aseme").write_text(PROJECT, "utf-8")
    if "trace.jsonl" in command:
        assert run_program(["run", "s.aseme", "-o", "out", "-q"]) == 0
    before = globals_of_the_process()
    assert run_program(command.split()) == 0
    assert globals_of_the_process() == before


LAMP = "system Lamp srm r { liveness { r = Wait } activities { Wait } }"


def test_runs_in_threads_that_end_in_any_order_put_the_switch_interval_back() -> None:
    generated = generate(LAMP)
    before = globals_of_the_process()
    begun, ends = [threading.Event(), threading.Event()], [threading.Event(), threading.Event()]

    def run(number: int) -> None:
        class Wait:
            def execute(self, context: Context) -> None:
                begun[number].set()
                while not ends[number].is_set():
                    context.wait(0.01)

        interval = (100_000, 50_000)[number]
        team, _ = make(generated, {"Wait": Wait}, clock="real", real_time=RealTime(switch_interval=interval))
        team.run()

    threads = [threading.Thread(target=run, args=(number,)) for number in range(2)]
    threads[0].start()
    wait_until(begun[0].is_set)
    threads[1].start()
    wait_until(begun[1].is_set)
    # An activity may begin just before the run sets the interval.
    wait_until(lambda: sys.getswitchinterval() == pytest.approx(50e-6))
    ends[0].set()
    threads[0].join()
    assert sys.getswitchinterval() == pytest.approx(50e-6)
    ends[1].set()
    threads[1].join()
    assert globals_of_the_process() == before


def test_what_somebody_else_sets_meanwhile_stays() -> None:
    before = sys.getswitchinterval()
    try:
        with switching(1e-4):
            sys.setswitchinterval(0.02)
        assert sys.getswitchinterval() == pytest.approx(0.02)
    finally:
        sys.setswitchinterval(before)


def test_the_collector_is_off_until_the_last_has_measured() -> None:
    assert gc.isenabled()
    first, second = uncollected(), uncollected()
    first.__enter__()
    second.__enter__()
    first.__exit__(None, None, None)
    assert not gc.isenabled()
    second.__exit__(None, None, None)
    assert gc.isenabled()


def test_what_a_platform_is_given_is_in_no_environment_but_that_of_its_robots() -> None:
    loaded = Loaded.__new__(Loaded)
    object.__setattr__(loaded, "team", (("one", "r"), ("two", "r")))
    before = globals_of_the_process()
    hosts: dict[str, Any] = {}
    with provided("mango", loaded, Configuration(Path()), print):
        assert globals_of_the_process() == before
        hosts.update(_mango_hosts(Configuration(Path())))
        assert set(given_environment()) == {GIVEN}
        elsewhere: list[object] = []
        thread = threading.Thread(target=lambda: elsewhere.append(given_environment()))
        thread.start()
        thread.join()
        assert elsewhere == [{}]
    assert set(hosts) == {"one", "two"}
    assert given_environment() == {} and GIVEN not in os.environ


@pytest.mark.parametrize("name", ["tidy_up", "tidy_all"])
def test_a_language_server_in_another_s_process_leaves_its_collector_alone(name: str) -> None:
    server = make_server("1", Project(), lambda root: PythonFolders())
    before = globals_of_the_process()
    tidy: Callable[[], None] = getattr(server.tidying, name)
    tidy()
    assert globals_of_the_process() == before


def test_plain_and_batch_change_nothing(tmp_path: Path) -> None:
    system = system_of("system S srm r { liveness { r = A . B } activities { A  B } }")
    plain_kind, batch_kind = made(system, tmp_path, "r")

    def use() -> None:
        chart: Any = plain_kind()
        chart.start()
        with without_compiling():
            many: Any = batch_kind(3)
            many.start()

    use()  # numpy has filters of warnings of its own, from its import on
    before = globals_of_the_process()
    use()
    assert globals_of_the_process() == before
