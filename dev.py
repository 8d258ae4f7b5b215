#!/usr/bin/env python3
"""Set up this checkout and use it, with nothing but Python: `python3 dev.py play`, `python3 dev.py test`.

The first run makes `.venv` beside this file and installs the package into it; later runs reuse it until
the dependencies change. This file must be readable by any Python 3.7: it is what tells people that
theirs is too old.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from typing import TextIO

ROOT = Path(__file__).resolve().parent
VENV = ROOT / os.environ.get("ASEME_DSL_VENV", ".venv")  # ci/pythons.py has one for each Python
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
STAMP = VENV / "aseme-dsl.json"  # what was installed last
LOG = VENV / "aseme-dsl.log"  # what pip said then

OLDEST_PYTHON = (3, 11)

PLAY = ["-m", "aseme_dsl", "run", "examples/robocup"]
"""What `play` runs, seen from the root; further arguments of `dev.py play` are appended."""

# Each worker begins with tests that stand together, so that what they share is made once. There is one more
# than processors: many a test waits for other processes.
IN_WORKERS = ["-n", str((os.cpu_count() or 1) + 1), "--dist", "worksteal"]

FAILED = ROOT / ".pytest_cache/v/cache/lastfailed"
FEW = 5
"""So many tests that fail beside others are run once more, alone."""

CHECKS = [
    [("ruff check", ["-m", "ruff", "check"])],
    [("ruff format", ["-m", "ruff", "format", "--check"])],
    # Both use one processor only.
    [
        ("mypy", ["-m", "mypy"]),
        ("documentation", ["-m", "sphinx", "-W", "--keep-going", "-q", "-E", "docs", "docs/_build/html"]),
    ],
    # Last, because its closing line is the result that people and CI look for.
    [("pytest", ["-m", "pytest", *IN_WORKERS])],
]
"""What `test` runs, in this order, a group beside each other; its further arguments go to the last one."""

UNIT = [
    "tests/grammar",
    "tests/diagnostics",
    "tests/compiler",
    "tests/codegen",
    "tests/backends",
    "tests/behaviour",
    "tests/runtime",
    "tests/test_patterns.py",
    "tests/test_source.py",
    "--ignore=tests/backends/test_batch.py",
    "--ignore=tests/backends/test_plain_memory.py",
    "--ignore=tests/backends/test_plain_size.py",
    "--ignore=tests/codegen/test_proto.py",
    "--ignore=tests/codegen/test_proto_messages.py",
    "--ignore=tests/compiler/models/test_any_input.py",
    "--ignore=tests/compiler/models/test_language_of_charts.py",
    "--ignore=tests/compiler/models/test_used_oddly.py",
    "--ignore=tests/compiler/test_slips.py",
    "--ignore=tests/grammar/syntax/test_textmate.py",
    "--ignore=tests/grammar/syntax/test_vim.py",
    "--ignore=tests/grammar/test_growth.py",
    "--ignore=tests/grammar/test_layout_random.py",
    "--ignore=tests/grammar/test_recovery.py",
    "--ignore=tests/runtime/platform",
    "--ignore=tests/runtime/transport",
    "--ignore=tests/runtime/agent/test_many_agents.py",
    "--ignore=tests/runtime/conversation/test_many_conversations.py",
    "--ignore=tests/runtime/workers/test_threads.py",
]
"""What `unit` runs, and `ci/pythons.py` on every other Python: the tests that depend on the Python (its
regular expressions, its compiler, its standard library), without those that count work, memory or threads,
use a network, ask other programs (editors, protoc, Numba), or try by chance what others have tried."""

LONG = [
    ("on every Python here", ["ci/pythons.py"], {}),
    ("on a bare Debian", ["ci/bare_debian.py"], {}),
    ("a large file", ["benchmarks/large_file.py"], {}),
    ("a changed file of a large project", ["benchmarks/rebuild.py"], {}),
    ("compact drawings", ["benchmarks/compact.py"], {}),
    ("broken files", ["benchmarks/broken_files.py"], {}),
    ("one slip, one message", ["benchmarks/mutations.py"], {}),
    ("tests that take long", ["-m", "pytest", "-n", "auto", "-m", "long"], {"LONG_TESTS": "1"}),
    (
        "scenarios of the examples with many seeds",
        ["-m", "pytest", "-n", "auto", "tests/examples/test_scenarios.py"],
        {"SCENARIO_SEEDS": "20"},
    ),
    ("whether scenarios notice mistakes", ["-m", "benchmarks.mutants"], {}),
    ("whether mistakes are seen as differences", ["-m", "benchmarks.differences"], {}),
    (
        "certificates of the library and the examples",
        ["-m", "pytest", "-n", "auto", "tests/docs/test_certificates.py"],
        {"CERTIFICATES": "1"},
    ),
    (
        "planted faults are never proved",
        ["-m", "pytest", "-n", "auto", "tests/cli/test_prove_pairs.py", "tests/cli/test_prove_robocup.py"],
        {"CERTIFICATES": "1"},
    ),
    (
        "SPIN as a second opinion about random protocols",
        ["-m", "pytest", "-n", "auto", "-rs", "tests/interop/exports/test_promela.py"],
        {"SPIN_TALKS": "100"},
    ),
    (
        "counterexamples of random protocols are played",
        ["-m", "pytest", "-n", "auto", "tests/cli/test_counterexamples.py"],
        {"REPLAYED_TALKS": "200"},
    ),
    (
        "what is proved of times holds in random runs",
        ["-m", "pytest", "-n", "auto", "tests/proofs/test_timed_runs.py"],
        {"TIMED_TEAMS": "600"},
    ),
    (
        "what random charts do is explored",
        ["-m", "pytest", "-n", "auto", "-s", "tests/proofs/test_explored_charts.py"],
        {"EXPLORED_CHARTS": "1000"},
    ),
    ("whether mistakes in protocols are refuted", ["-m", "benchmarks.protocol_mutants"], {}),
    (
        "certificates of random charts, and of charts with planted faults",
        ["-m", "pytest", "-n", "auto", "tests/proofs/test_certificate.py"],
        {"CERTIFIED_CHARTS": "1000", "CERTIFIED_FAULTS": "400"},
    ),
    (
        "mutations of all examples",
        [
            "-m",
            "pytest",
            "-n",
            "auto",
            "tests/cli/test_mutations.py",
            "tests/compiler/models/test_used_oddly.py",
        ],
        {"MUTATIONS": "20000"},
    ),
    (
        "changed models of KSE, agents.xml and .proto files",
        ["-m", "pytest", "-n", "auto", "tests/interop/test_changed_models.py"],
        {"ASEME_CHANGED_MODELS": "5000"},
    ),
    (
        "changed models of KSE as projects",
        ["-m", "pytest", "-n", "auto", "tests/interop/test_emf_charts.py"],
        {"ASEME_CHANGED_MODELS": "500"},
    ),
    (
        "exported charts on engines of others",
        ["-m", "pytest", "-n", "auto", "tests/interop/exports"],
        {"EXPORTED_CHARTS": "300", "EXPORTED_DRAWINGS": "1", "ASEME_ROUND_TRIPS": "300"},
    ),
    (
        "changed state machines, and machines that go out and come home",
        ["-m", "pytest", "-n", "auto", "tests/interop/machines"],
        {"ASEME_CHANGED_MACHINES": "5000", "ASEME_ROUND_TRIPS": "300"},
    ),
    (
        "the scripts of SCION in SCION_TESTS",
        ["-m", "pytest", "-rs", "-s", "tests/interop/machines/test_scion_scripts.py"],
        {},
    ),
    ("models of KSE in ASEME_MODELS", ["-m", "pytest", "-rs", "tests/interop/test_real_models.py"], {}),
    (
        "compact drawings of random charts",
        [
            "-m",
            "pytest",
            "-n",
            "auto",
            "tests/diagrams/test_compact.py",
            "tests/diagrams/test_nested_parts.py",
        ],
        {"COMPACT_CHARTS": "2000", "COMPACT_EDITS": "1", "COMPACT_FAULTS": "1"},
    ),
    (
        "drawings of random models and talks",
        ["-m", "pytest", "-n", "auto", "tests/diagrams/test_readable.py", "tests/diagrams/test_sequence.py"],
        {"RANDOM_DRAWINGS": "500"},
    ),
    (
        "questions why not",
        ["-m", "pytest", "-n", "auto", "tests/play/test_asking.py"],
        {"ASKED": "30", "ASKED_CHARTS": "200"},
    ),
    (
        "layout of random programs",
        ["-m", "pytest", "tests/grammar/test_layout_random.py"],
        {"LAYOUT_EXAMPLES": "500"},
    ),
    (
        "observed runs have the verdicts of the runs",
        ["-m", "pytest", "-n", "auto", "tests/cli/test_observe.py"],
        {"OBSERVED_RUNS": "100"},
    ),
    ("how fast logs are observed", ["benchmarks/observe.py"], {}),
    ("latency", ["benchmarks/latency.py"], {}),
    ("agents", ["benchmarks/agents.py"], {}),
    ("a long match", ["benchmarks/soak.py", "0.5"], {}),
    ("faults of activities", ["-m", "pytest", "tests/faults"], {"FAULT_STARTS": "20000", "LONG_TESTS": "1"}),
    ("robots on machines", ["-m", "pytest", "tests/security/test_machines.py"], {"MACHINES": "1"}),
    ("robots that cannot be reached", ["-m", "pytest", "-s", "tests/network"], {"NETWORK_RUNS": "10"}),
    (
        "a day in the field",
        ["-m", "pytest", "-s", "tests/faults/test_field_days.py"],
        {"FIELD_HOURS": "24", "LONG_TESTS": "1"},
    ),
    ("robots in processes", ["benchmarks/transport.py"], {}),
    ("whole matches", ["-m", "pytest", "tests/examples/test_robocup.py"], {"MATCH_SEEDS": "3 11"}),
    (
        "letters of other agents",
        ["-m", "pytest", "tests/runtime/message/test_acl_text.py"],
        {"ACL_EXAMPLES": "5000"},
    ),
    (
        "links that lose",
        ["-m", "pytest", "tests/runtime/transport/test_stream.py"],
        {"STREAM_EXAMPLES": "2000"},
    ),
    ("a real match of ten minutes", ["benchmarks/real_match.py", "10", "SIGINT"], {}),
    ("one that SIGTERM ends", ["benchmarks/real_match.py", "3", "SIGTERM"], {}),
    ("speed, by hand and of others", ["-m", "benchmarks.peers"], {}),
    ("thousands at once", ["benchmarks/batch.py"], {}),
    ("answers to an editor", ["benchmarks/editor.py"], {}),
    ("charts that are saved and loaded", ["-m", "benchmarks.saving"], {}),
    (
        "random edits",
        ["-m", "pytest", "tests/editor/test_drift.py", "tests/editor/test_endurance.py"],
        {"EDITOR_EDITS": "10000"},
    ),
    ("the extension in VS Code", ["benchmarks/vscode_host.py"], {}),
    ("agents over SPADE and mango", ["tests/platforms/lane.py"], {}),
    ("what our layer costs over SPADE", ["tests/platforms/lane.py", "bench"], {}),
    ("random charts", ["-m", "pytest", "tests/oracle"], {"ORACLE_EXAMPLES": "5000"}),
    ("machine code", ["-m", "pytest", "tests/project/building/test_native.py"], {"NATIVE_EXAMPLES": "12"}),
    ("one seed, one trace", ["-m", "benchmarks.same_traces"], {}),
    (
        "replays of examples and of seeded faults",
        ["-m", "pytest", "-n", "auto", "tests/play/test_replay.py"],
        {"REPLAY_RUNS": "334", "REPLAY_SECONDS": "60"},
    ),
    (
        "damaged traces",
        ["-m", "pytest", "-n", "auto", "tests/cli/test_hostile_traces.py"],
        {"HOSTILE_TRACES": "500"},
    ),
    ("seeded faults", ["-m", "pytest", "-n", "auto", "tests/faults/test_seeded.py"], {"FAULT_RUNS": "1000"}),
    (
        "random networks",
        [
            "-m",
            "pytest",
            "-n",
            "auto",
            "tests/faults/test_random_networks.py",
            "tests/stdlib/test_networks.py",
        ],
        {"NETWORK_SEEDS": "2000"},
    ),
    (
        "conversations among processes",
        ["-m", "pytest", "tests/faults/test_library_in_processes.py", "tests/faults/test_called_away.py"],
        {"PROCESS_RUNS": "20"},
    ),
    ("random swaps", ["-m", "pytest", "-n", "auto", "tests/faults/test_swap.py"], {"SWAP_EXAMPLES": "300"}),
]
"""What `long` runs: too heavy for every change, to be run before a release."""


class SetupError(Exception):
    """Something that the reader has to mend; the text says how."""


def check_python(version: tuple[int, int], executable: str) -> None:
    """Refuse a Python that is too old or cannot make a virtual environment.

    Raises:
        SetupError: with what to install.
    """
    if version < OLDEST_PYTHON:
        raise SetupError(
            "aseme-dsl needs Python {}.{} or newer, and {} is Python {}.{}.\n"
            "Install a newer one and run this script with it, for example: python3.12 dev.py test".format(
                *OLDEST_PYTHON, executable, *version
            )
        )
    try:
        import ensurepip
        import venv

        del ensurepip, venv
    except ImportError as error:
        raise SetupError(
            f"This Python ({executable}) cannot make virtual environments: its module "
            f"`{error.name}` is not installed.\n"
            f"On Debian and Ubuntu install it with: sudo apt install python{version[0]}.{version[1]}-venv\n"
            "On other systems install the package of your Python that brings `venv` and `ensurepip`.\n"
            "Then run this command again."
        ) from error


def wanted_installation() -> str:
    """Return a fingerprint of all that decides what `pip install` does here."""
    import tomllib  # only in the Pythons that check_python lets through

    configuration = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    tool = configuration.get("tool", {})
    parts = [configuration.get("build-system"), configuration["project"], tool.get("hatch"), str(ROOT)]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def is_installed(wanted: str, extra: str) -> bool:
    """Say whether the environment already has what is wanted, `extra` (or more) included."""
    try:
        stamp = json.loads(STAMP.read_text(encoding="utf-8"))
        return bool(stamp["fingerprint"] == wanted and extra in stamp["extras"])
    except (OSError, ValueError, KeyError, TypeError):
        return False


def has_usable_environment() -> bool:
    """Say whether `.venv` has a Python that starts, is new enough, and has pip."""
    question = f"import sys, pip; sys.exit(sys.version_info < {OLDEST_PYTHON})"
    try:
        return subprocess.run([str(PYTHON), "-c", question], capture_output=True).returncode == 0
    except OSError:
        return False


def set_up(extra: str) -> None:
    """Make `.venv` and install the package in editable form, with the dependencies of `extra` ("" for none).

    Raises:
        SetupError: The environment or the package could not be installed.
    """
    usable = has_usable_environment()
    wanted = wanted_installation()
    if usable and is_installed(wanted, extra):
        return
    if not usable:
        say("Making a virtual environment in .venv ...")
        made = subprocess.run(
            [sys.executable, "-m", "venv", "--clear", str(VENV)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        if made.returncode != 0:
            raise SetupError(f"{made.stdout.rstrip()}\nThe virtual environment {VENV} could not be made.")
    else:
        STAMP.unlink(missing_ok=True)  # an installation that breaks off counts as none
    say("Installing aseme-dsl and what it needs into .venv (the first time takes a minute or two) ...")
    began = time.monotonic()
    install(f"{ROOT}[{extra}]" if extra else str(ROOT))
    # What pip installs in editable form is compiled when it is first used, and in some environments never.
    subprocess.run([str(PYTHON), "-m", "compileall", "-q", str(ROOT / "aseme_dsl")], check=False)
    # `dev` brings all that the plain package needs.
    stamp = {"fingerprint": wanted, "extras": ["", extra]}
    STAMP.write_text(json.dumps(stamp), encoding="utf-8")
    say(f"Installed in {time.monotonic() - began:.0f} s.")


def install(requirement: str) -> None:
    """Run pip, showing its last word on a terminal and nothing elsewhere; all it says goes to `LOG`.

    Raises:
        SetupError: pip failed; the text has the end of what it said.
    """
    command = [str(PYTHON), "-m", "pip", "install", "--editable", requirement]
    command += ["--no-input", "--disable-pip-version-check", "--progress-bar", "off"]
    shows_progress = sys.stdout.isatty() and not os.environ.get("CI")
    pip = subprocess.Popen(
        command,
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        errors="replace",
    )
    lines: list[str] = []
    with pip, LOG.open("w", encoding="utf-8") as log:
        assert pip.stdout is not None
        for line in pip.stdout:
            log.write(line)
            lines.append(line.rstrip())
            if shows_progress:
                print(f"\r\x1b[K  {line.strip()[:76]}", end="", flush=True)
    if shows_progress:
        print("\r\x1b[K", end="", flush=True)
    if pip.returncode != 0:
        raise SetupError(
            "\n".join(lines[-15:]) + f"\n\npip could not install aseme-dsl (all it said is in {LOG}).\n"
            "It needs the network, or a mirror that pip is configured for, the first time."
        )


def in_environment(
    arguments: list[str], variables: dict[str, str] | None = None, output: TextIO | None = None
) -> int:
    """Run the environment's Python from the root, with what it says in `output`; return its exit code."""
    # Nothing that changes a Python: its folders, its warnings, or that it writes no bytecode (the tests start
    # hundreds of processes: without bytecode each compiles the package anew).
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    environment.pop("ASEME_DSL_VENV", None)
    environment.update(variables or {})
    environment["VIRTUAL_ENV"] = str(VENV)
    # What a check starts by name (asemec, ruff) is the environment's own.
    environment["PATH"] = os.pathsep.join([str(PYTHON.parent), environment.get("PATH", os.defpath)])
    errors = None if output is None else subprocess.STDOUT
    return subprocess.run(
        [str(PYTHON), *arguments], cwd=ROOT, env=environment, stdout=output, stderr=errors
    ).returncode


def play(further: list[str]) -> int:
    """Set up what a user needs, and let the example team play."""
    set_up("")
    return in_environment([*PLAY, *further])


def test(further: list[str]) -> int:
    """Set up what a developer needs, and run all checks up to the first that fails."""
    set_up("dev")
    for group in CHECKS:
        for name, code in beside(group) if len(group) > 1 else alone(*group[0], further):
            if code != 0:
                say(f"dev.py: {name} failed (exit code {code})", to=sys.stderr)
                return code
    return 0


def alone(name: str, arguments: list[str], further: list[str]) -> Iterator[tuple[str, int]]:
    """Run a check; give its name and its exit code."""
    say(f"== {name}")
    yield name, tests(arguments, further) if name == "pytest" else in_environment(arguments)


def tests(arguments: list[str], further: list[str]) -> int:
    """Run pytest; give its exit code.

    A few tests that failed beside others are run once more, one after the other: on a busy machine, a test
    that waits for other processes can be too late. They are listed, so that somebody makes them steady.
    """
    code = in_environment([*arguments, *further])
    if code != 1 or further or not FAILED.exists() or len(failed := json.loads(FAILED.read_text())) > FEW:
        return code
    say("== pytest, one after the other, what failed beside others: " + ", ".join(failed))
    return in_environment(["-m", "pytest", "-n", "0", "--last-failed", "--last-failed-no-failures", "none"])


def beside(group: list[tuple[str, list[str]]]) -> Iterator[tuple[str, int]]:
    """Run checks beside each other; when one is done, print what it said, and give its name and exit code."""
    with ThreadPoolExecutor(len(group)) as workers, ExitStack() as files:
        outputs = [files.enter_context(tempfile.TemporaryFile("w+", errors="replace")) for _ in group]
        codes = [
            workers.submit(in_environment, arguments, None, output)
            for (_, arguments), output in zip(group, outputs, strict=True)
        ]
        for (name, _), output, code in zip(group, outputs, codes, strict=True):
            say(f"== {name}")
            found = code.result()
            output.seek(0)
            say(output.read().rstrip("\n"))
            yield name, found


def unit(further: list[str]) -> int:
    """Set up what a developer needs, and run the tests that depend on the Python."""
    set_up("dev")
    return tests(["-m", "pytest", "-q", *IN_WORKERS, *UNIT], further)


def long(further: list[str]) -> int:
    """Set up what a developer needs, and run what takes minutes."""
    set_up("dev")
    for name, arguments, variables in LONG:
        say(f"== {name}")
        code = in_environment([*arguments, *further], variables)
        if code != 0:
            say(f"dev.py: {name} failed (exit code {code})", to=sys.stderr)
            return code
    return 0


def syntax(further: list[str]) -> int:
    """Set up what a developer needs, and make what follows from the grammar: its rules, and all colours."""
    set_up("dev")
    return in_environment(["-m", "aseme_dsl.grammar.syntax", *further])


def vsix(further: list[str]) -> int:
    """Bundle and package the extension of VS Code; what npm needs stays in editors/vscode/node_modules."""
    npm = shutil.which("npm")
    if npm is None:
        raise SetupError("There is no npm: install Node.js 20 or newer.")
    folder = ROOT / "editors" / "vscode"
    lock = (folder / "package-lock.json").read_bytes()
    stamp = folder / "node_modules" / ".aseme-dsl"  # the lock file of what was installed last
    if not stamp.exists() or stamp.read_bytes() != lock:
        say("Installing what the extension is built with ...")
        code = subprocess.call([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder)
        if code != 0:
            return code
        stamp.write_bytes(lock)
    target = ROOT / "build" / "aseme.vsix"
    target.parent.mkdir(exist_ok=True)
    for command in (["run", "--silent", "bundle"], ["run", "package", "--", "--out", str(target), *further]):
        code = subprocess.call([npm, *command], cwd=folder)
        if code != 0:
            return code
    say(f"Install it with: code --install-extension {target}")
    return 0


COMMANDS = {"play": play, "test": test, "unit": unit, "long": long, "syntax": syntax, "vsix": vsix}


def say(text: str, to: TextIO | None = None) -> None:
    """Print at once, so that our lines and those of what we start keep their order."""
    print(text, file=to or sys.stdout, flush=True)


def main(arguments: list[str]) -> int:
    """Do what the command line asks; return the exit code."""
    parser = argparse.ArgumentParser(
        prog="dev.py",
        description="Set up this checkout in .venv (reused while the dependencies are the same) and use it.",
        epilog="Example: python3 dev.py test tests/test_packaging.py -x",
    )
    parser.add_argument(
        "command",
        choices=list(COMMANDS),
        help="play the example; run every check; run the tests that depend on the Python; "
        "run benchmarks and long random tests; "
        "make the colours of all editors from the grammar; package the extension of VS Code",
    )
    parser.add_argument(
        "further", nargs=argparse.REMAINDER, help="more arguments for asemec run (play) or pytest (test)"
    )
    options = parser.parse_args(arguments)
    # A shell without a terminal starts what is in the background with SIGINT ignored, which children inherit.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        check_python((sys.version_info[0], sys.version_info[1]), sys.executable)
        return COMMANDS[options.command](options.further)
    except SetupError as error:
        say(f"dev.py: {error}", to=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
