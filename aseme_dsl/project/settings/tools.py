"""Tools: what asemec can use on this machine, what it is for, and how to get what is missing."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib import metadata

from aseme_dsl.records import dataclass

OLDEST_PYTHON = (3, 11)


@dataclass(frozen=True, slots=True)
class Tool:
    """A tool or library. `found` says which one there is (a version, a path), or is None."""

    name: str
    found: str | None
    purpose: str
    needed: bool = False
    """Whether asemec does not work without it."""
    advice: str = ""
    """What to do if it is not there."""


_LIBRARIES = {
    "textx": "reads .aseme files",
    "click": "the command line",
    "jinja2": "the templates of generated code",
    "networkx": "questions about graphs",
    "graphviz": "the drawings' texts",
    "protobuf": "messages on the wire and .proto files",
}
"""What the package depends on, with what it is for."""

OPTIONAL = {
    "z3-solver": ("check", "lets check compare conditions: overlaps, gaps, what never holds"),
    "grpcio-tools": ("proto", "imports .proto files, with the real protoc that it carries"),
    "pygls": ("editor", "the language server, for editors"),
    "eclipse-zenoh": ("zenoh", "robots in several processes and on several machines"),
    "cryptography": ("certificates", "makes the certificates of a team"),
    "spade": ("spade", "agents as SPADE agents, on an XMPP server"),
    "greenlet": ("spade", "what SPADE's database needs"),
    "mango-agents": ("mango", "agents as mango agents, which talk over TCP"),
    "mcap": ("trace", "traces as MCAP files"),
    "mcap-protobuf-support": ("trace", "traces as MCAP files"),
    "msgspec": ("trace", "reads logs and traces faster"),
    "numpy": ("batch", "thousands of statecharts at once, in arrays"),
    "numba": ("numba", "the same as machine code"),
    "mypy": ("native", "machine code of plain statecharts"),
    "setuptools": ("native", "calls the C compiler for it"),
    "matplotlib": ("plot", "plots of what `optimise` measures"),
    "pypdf": ("pdf", "several diagrams in one PDF file"),
    "textual": ("sim", "the screens of `sim` and `team status`"),
    "opentelemetry-sdk": ("otel", "metrics of `node` for OpenTelemetry"),
    "opentelemetry-exporter-otlp-proto-http": ("otel", "sends these metrics"),
    "distributed": ("cluster", "the runs of `test` and `optimise` on many machines"),
    "jsonschema": ("schema", "validates models and traces against their JSON schemas"),
    "sphinx": ("sphinx", "draws models in the pages of a documentation"),
    "mkdocs": ("mkdocs", "draws models in the pages of a documentation"),
}
"""What the extras bring: the packages of every extra but `dev`, with the extra and what it is for."""


def tools() -> tuple[Tool, ...]:
    """All of them, those that are needed first."""
    return (
        _python(),
        *(
            Tool(name, _version(name), purpose, True, f"pip install {name}")
            for name, purpose in _LIBRARIES.items()
        ),
        _standard_library(),
        _graphviz(),
        *(
            Tool(name, _version(name), purpose, advice=f"pip install 'aseme-dsl[{extra}]'")
            for name, (extra, purpose) in OPTIONAL.items()
        ),
        Tool(
            "ruff",
            _program("ruff") or _version("ruff"),
            "checks generated and activity code, if you like",
            advice="pip install ruff",
        ),
        _priority(),
        *_backends(),
    )


def _python() -> Tool:
    version = ".".join(str(part) for part in sys.version_info[:3])
    fits = sys.version_info >= OLDEST_PYTHON
    needed = ".".join(str(part) for part in OLDEST_PYTHON)
    return Tool("Python", version if fits else None, "runs everything", True, f"get Python {needed} or newer")


def _standard_library() -> Tool:
    from aseme_dsl.standard_library import standard_library

    try:
        names = sorted(path.stem for path in standard_library().glob("*.aseme"))
    except FileNotFoundError:
        names = []
    found = ", ".join(names) or None
    return Tool("standard library", found, "what `import NAME` brings", True, "reinstall aseme-dsl")


def _graphviz() -> Tool:
    from aseme_dsl.diagrams import GraphvizMissing, program

    advice = "pip install graphviz-pure, or install the system's package graphviz"
    purpose = "draws the models; without it there are only .dot files"
    try:
        path = program()
    except GraphvizMissing:
        return Tool("Graphviz", None, purpose, advice=advice)
    return Tool("Graphviz", f"{_said_version(path)} ({path})", purpose, advice=advice)


def _priority() -> Tool:
    from aseme_dsl.runtime.time.timer_thread import may_raise_priority

    problem = may_raise_priority()
    found = "permitted" if problem is None else None
    purpose = "keeps the timers of a robot punctual, if its project asks for it"
    return Tool("real time", found, purpose, advice=problem or "")


def _said_version(path: str) -> str:
    """The version in what `dot -V` says, on standard error."""
    try:
        done = subprocess.run([path, "-V"], capture_output=True, text=True, timeout=20, errors="replace")
    except (OSError, subprocess.TimeoutExpired):
        return "does not start"
    version = re.search(r"\d+\.\d+[\w.]*", done.stderr + done.stdout)
    return version[0] if version and done.returncode == 0 else "unknown version"


def _backends() -> tuple[Tool, ...]:
    from aseme_dsl.backends.backend import OWN, foreign_backends

    ours = f"aseme-dsl {_version('aseme-dsl') or ''}".rstrip()
    found = [Tool(f"backend {name}", ours, "generates code") for name in sorted(OWN)]
    for point in foreign_backends():
        try:
            point.load()
            state = f"{point.dist.name} {point.dist.version}" if point.dist is not None else "there"
        except Exception as error:  # a foreign package may raise anything
            state = ""
            problem = f"{type(error).__name__}: {error}"
        if state:
            found.append(Tool(f"backend {point.name}", state, "generates code"))
        else:
            found.append(Tool(f"backend {point.name}", None, "generates code", advice=f"broken: {problem}"))
    return tuple(found)


def _version(distribution: str) -> str | None:
    try:
        return metadata.version(distribution)
    except metadata.PackageNotFoundError:
        return None


def _program(name: str) -> str | None:
    return shutil.which(name)
