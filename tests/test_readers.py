"""Every reader of bytes that come from outside goes through `outside`, or is listed here with its reason."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import aseme_dsl

PACKAGE = Path(aseme_dsl.__file__).parent

READERS = frozenset(
    {
        "FromString",
        "ParseFromString",
        "fdopen",
        "fromstring",
        "iterparse",
        "loads",
        "makefile",
        "open",
        "read1",
        "read_bytes",
        "read_text",
        "readline",
        "readlines",
        "recv",
        "recv_bytes",
        "recv_into",
        "recvfrom",
    }
)
"""What reads, by the last part of its name."""
SAFE = frozenset({"outside", "self", "webbrowser", "zenoh"})
"""Methods of these are not looked at."""
CAUGHT = "of a bounded text; its depth is caught"
JUST_WRITTEN = "what this process has just written"
REGULAR = "regular, the user's own, and with a largest size"
OWN = "a file of this package"
CHILD = "a process that this one has started, over a pipe between the two"
SYSTEM = "a file of the operating system"

NO_FILE = "it opens no file"
BOUNDED_BY_LINK = "as large as the link lets through; protobuf bounds its depth"
LOCK = "a lock in the user's own folder, of which nothing is read"
PROVEN = "the other end has proven that it is of this team"

BUNDLE = "a bundle that an operator of this team has brought; this script stands alone on a host"

LISTED: dict[str, str] = {
    "cli/deploy.py: _write: os.fdopen": "it writes",
    "cli/deploy.py: _write: os.open": "it writes",
    "cli/deploy.py: _write: read_bytes": OWN,
    "editor/proving/proofs.py: _asked: readline": CHILD,
    "project/deploying/bundle.py: _tar: open": "it writes",
    "project/deploying/bundle.py: make_bundle: read_bytes": OWN,
    "project/deploying/install.py: _content: read": BUNDLE,
    "project/deploying/install.py: _unpack: open": BUNDLE,
    "project/deploying/install.py: _unpack_private: open": BUNDLE,
    "project/deploying/install.py: _unpack_private: os.fdopen": "it writes",
    "project/deploying/install.py: _unpack_private: os.open": "it writes",
    "project/deploying/install.py: altered: read_bytes": BUNDLE,
    "project/deploying/install.py: read_list: json.loads": BUNDLE,
    "project/deploying/install.py: read_list: read_bytes": BUNDLE,
    "project/deploying/install.py: start: read_text": BUNDLE,
    "project/deploying/remote.py: _run: read_bytes": OWN,
    "project/deploying/start_check.py: incomplete: read_text": BUNDLE,
    "project/deploying/wheels.py: _own_wheel: json.loads": "what pip has written of this package",
    "project/deploying/wheels.py: _own_wheel: read_text": "what pip has written of this package",
    "project/deploying/wheels.py: _project_needs: read_text": "the configuration, which was read before",
    "project/deploying/wheels.py: _project_needs: tomllib.loads": "the configuration, which was read before",
    "project/deploying/wheels.py: wheels_for: read_bytes": "what pip has just written",
    "project/operating/endpoint.py: _head: readline": "with a largest size",
    "project/proving/process.py: main: os.fdopen": "it writes",
    "project/proving/process.py: main: readline": "the process that has started this one, over that pipe",
    "runtime/control/usage.py: memory: read_text": SYSTEM,
    "runtime/message/contract.py: types_of: FromString": "what the compiler has made",
    "runtime/transport/delivery/builds.py: _learn: loads": "of `message.contract`, by `outside`",
    "runtime/version/epochs.py: write: open": "it writes",
    "runtime/version/epochs.py: write: os.open": "it writes",
    "amola/as_json.py: schema: json.loads": OWN,
    "amola/as_json.py: schema: read_text": OWN,
    "interop/machines/json_text.py: string: json.loads": "one text that a pattern has matched",
    "interop/machines/json_text.py: value: json.loads": "one number or word that a pattern has matched",
    "play/sight/sightings.py: _heard: json.loads": CHILD,
    "play/sight/sightings.py: asked_of: json.loads": "the process that has started this one, over that pipe",
    "project/playing/seen.py: record: json.loads": "the process that has started this one, over that pipe",
    "project/testing/coverage_page.py: page: read_text": OWN,
    "project/comparing/pictures.py: _marked: fromstring": JUST_WRITTEN,
    "project/testing/coverage_page.py: _coloured: fromstring": JUST_WRITTEN,
    "project/testing/coverage.py: _document: json.loads": CAUGHT,
    "project/settings/configuration.py: configuration_of: tomllib.loads": CAUGHT,
    "project/settings/deployment.py: read_hosts: tomllib.loads": CAUGHT,
    "runtime/workers/descendants.py: _children: read_bytes": SYSTEM,
    "runtime/workers/descendants.py: _command: read_bytes": SYSTEM,
    "project/editing/new.py: new_project: read_text": OWN,
    "project/settings/platforms.py: _given: json.loads": "of an environment variable, which `giving` has set",
    "project/settings/platforms.py: _listening: readline": CHILD,
    "project/playing/supervisor.py: _read_err: readline": "with a largest size",
    "project/playing/match.py: _next: recv": CHILD,
    "project/playing/match_team.py: __call__: recv": CHILD,
    "project/playing/match_team.py: _run: recv": CHILD,
    "project/playing/supervisor.py: _read_out: readline": "with a largest size",
    "project/playing/world_process.py: _own_output: os.fdopen": "it writes",
    "project/playing/world_process.py: _simulate: json.loads": CHILD,
    "project/playing/world_process.py: _simulate: readline": CHILD,
    "project/playing/world_process.py: watch: read": CHILD,
    "project/playing/world_process.py: main: json.loads": CHILD,
    "project/playing/world_process.py: main: readline": CHILD,
    "project/files/write.py: create: os.fdopen": "it writes",
    "project/files/write.py: create: os.open": "it writes",
    "cli/lsp.py: command: os.fdopen": "it writes",
    "cli/sim.py: _plain: readline": "with a largest size",
    "cli/program.py: _ignore_output: os.open": "it writes, to nowhere",
    "codegen/proto.py: descriptor_set: FromString": "what the compiler has made",
    "compiler/read/library.py: _declared: read_text": OWN,
    "compiler/read/library.py: _text_of: read_text": OWN,
    "diagnostics/pages.py: page: read_text": OWN,
    "diagrams/rendering/store.py: _write: os.fdopen": "it writes",
    "diagrams/rendering/lines.py: mixed_up: fromstring": "what Graphviz has drawn of our own text",
    "diagrams/rendering/lines.py: crossed: fromstring": "what Graphviz has drawn of our own text",
    "diagrams/rendering/svg.py: faults: fromstring": "what Graphviz has drawn of our own text",
    "diagrams/rendering/inset.py: inset: fromstring": "what Graphviz has drawn of our own text",
    "documents/html.py: inline: fromstring": "what Graphviz has drawn of our own text",
    "editor/reading/bounded_input.py: readline: readline": "with a largest size",
    "editor/server.py: did_change: open": NO_FILE,
    "editor/server.py: did_open: open": NO_FILE,
    "editor/viewer.py: page: read_text": OWN,
    "grammar/parsing/declarations/pieces.py: text: read_text": NO_FILE,
    "grammar/formulas/expression.py: _whole: read_text": NO_FILE,
    "grammar/formulas/formula.py: read_formula: read": NO_FILE,
    "grammar/formulas/statement.py: _atom: read_text": NO_FILE,
    "grammar/parsing/rules.py: checksum: read_text": OWN,
    "grammar/syntax/__main__.py: main: read_text": OWN,
    "interop/monas_agents.py: _parsed: read": NO_FILE,
    "interop/proto.py: _imported: FromString": "what protoc has made of a bounded text",
    "runtime/control/control.py: read: loads": "of `outside`",
    "runtime/control/connections.py: readinto: recv_into": "of the size of a buffer",
    "runtime/control/control_socket.py: _converse: readline": "with a largest size",
    "runtime/control/control_socket.py: _exactly: recv": "of 32 bytes",
    "runtime/control/control_socket.py: ask: makefile": "its line has a largest size",
    "runtime/control/control_socket.py: ask: readline": "with a largest size",
    "runtime/conversation/conversation_trace.py: answered_outside: json.loads": JUST_WRITTEN,
    "runtime/conversation/management_sl.py: asked: loads": "of `message.sl`: with a largest size and depth",
    "runtime/team/ending.py: picture: open": NO_FILE,
    "runtime/control/operator_gate.py: _objects: loads": "of `outside`",
    "runtime/control/operator_gate.py: answer: loads": "of `outside`",
    "runtime/control/operator_gate.py: ask: loads": "of `outside`",
    "runtime/control/operator_key.py: read_keys: os.fdopen": REGULAR,
    "runtime/control/operator_key.py: read_keys: os.open": REGULAR,
    "runtime/control/operator_key.py: read_keys: tomllib.loads": CAUGHT,
    "runtime/control/operator_key.py: write_new: os.fdopen": "it writes",
    "runtime/control/operator_key.py: write_new: os.open": "it writes",
    "runtime/channel/persist.py: _settle: os.open": "a folder, of which nothing is read",
    "runtime/workers/processes.py: _run: pickle.loads": CHILD,
    "runtime/world/body.py: fit_to_travel: pickle.loads": "what this process has just pickled",
    "runtime/transport/heartbeats/heartbeats.py: _receive: recvfrom": "of the size of a heartbeat",
    "runtime/transport/heartbeats/heartbeats.py: _run: recv": "from itself, by which it is woken",
    "runtime/world/shared_world.py: _answer: recv": PROVEN,
    "runtime/world/shared_world.py: _serve: recv": PROVEN,
    "runtime/trace/trace_schema.py: schema: json.loads": OWN,
    "runtime/trace/trace_schema.py: schema: read_text": OWN,
    "runtime/trace/trace_mcap.py: _line: json.loads": JUST_WRITTEN,
    "runtime/trace/trace_mcap.py: message_classes: FromString": "what the compiler has made",
    "runtime/transport/delivery/clocks.py: clock_identity: read_text": SYSTEM,
    "runtime/transport/envelope.py: read: FromString": BOUNDED_BY_LINK,
    "runtime/transport/meeting.py: _is_live: os.open": LOCK,
    "runtime/transport/meeting.py: _locked: os.open": LOCK,
    "runtime/transport/meeting.py: _secret: os.fdopen": "it writes",
    "runtime/transport/meeting.py: _secret: os.open": "it writes",
    "runtime/platform/over_platform.py: _answer: json.loads": JUST_WRITTEN,
    "runtime/transport/reliable_delivery.py: begin: open": NO_FILE,
    "runtime/version/versions.py: _opened: os.open": REGULAR,
    "runtime/message/wire.py: _protos: FromString": "what the compiler has made",
    "runtime/message/wire.py: decode: FromString": BOUNDED_BY_LINK,
    "runtime/workers/worker.py: main: open": SYSTEM,
    "runtime/workers/worker.py: main: os.fdopen": CHILD,
    "runtime/workers/worker.py: work: pickle.loads": CHILD,
}
"""Where else something is read, as `file: function: call`, and why that needs no limit or has its own."""


def _calls(tree: ast.AST) -> Iterator[tuple[str, str]]:
    waiting: list[tuple[str, ast.AST]] = [("", tree)]
    while waiting:
        inside, node = waiting.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            inside = node.name
        if isinstance(node, ast.Call):
            match node.func:
                case ast.Name(id=name) if name in READERS:
                    yield inside, name
                case ast.Attribute(value=ast.Name(id=module), attr=name) if module in SAFE:
                    pass
                case ast.Attribute(value=value, attr=name) if name in READERS:
                    module = value.id if isinstance(value, ast.Name) else ""
                    named = module in ("os", "json", "pickle", "tomllib")
                    yield inside, f"{module}.{name}" if named else name
                case ast.Attribute(attr="read") if not node.args:
                    yield inside, "read"
                case _:
                    pass
        waiting += [(inside, child) for child in ast.iter_child_nodes(node)]


def _found() -> Counter[str]:
    found: Counter[str] = Counter()
    for path in sorted(PACKAGE.rglob("*.py")):
        name = path.relative_to(PACKAGE).as_posix()
        if name == "outside.py":
            continue
        for inside, call in _calls(ast.parse(path.read_text("utf-8"))):
            found[f"{name}: {inside}: {call}"] += 1
    return found


def test_every_reader_is_bounded_or_listed() -> None:
    found = _found()
    assert sorted(set(found) - set(LISTED)) == [], "read it with aseme_dsl.outside, or say here why not"
    assert sorted(set(LISTED) - set(found)) == [], "there are no such readers any more"
