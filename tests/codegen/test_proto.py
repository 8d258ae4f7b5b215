"""The written .proto: real protoc takes it and reads what the compiler built in memory."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from google.protobuf import descriptor_pb2
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.system import System
from aseme_dsl.codegen.proto import (
    constant_names,
    descriptor_set,
    file_descriptor,
    file_name,
    package_name,
    proto_files,
    proto_text,
)
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.runtime.message.naming import snake_case
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.support.compiling import system

ACCEPTANCE = sorted((Path(__file__).parent.parent / "acceptance").glob("*.aseme"))

EVERYTHING = """
system TestSystem
enum PlayerState { INITIAL READY = 5 SET }
enum Player { STATE_READY }
message PLAYER { int x }
message Point { double x  double y }
message All {
  bool truth
  int number = 7
  double measure
  string name
  bytes raw
  duration time
  PlayerState state
  Point point
  repeated int numbers
  repeated Point points
  optional int perhaps
  optional Point where
  optional PlayerState mood
  int _perhaps
}
message Empty { }
topic t { state All }
srm r { liveness { r = A } }
"""


def protoc(folder: Path, compiled: System) -> descriptor_pb2.FileDescriptorProto:
    """What real protoc reads in the written files."""
    for name, text in proto_files(compiled).items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text)
    command = [sys.executable, "-m", "grpc_tools.protoc", f"-I{folder}", "--fatal_warnings"]
    command += [f"--descriptor_set_out={folder / 'out'}", file_name(compiled)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr + proto_text(compiled)
    (found,) = descriptor_pb2.FileDescriptorSet.FromString((folder / "out").read_bytes()).file
    for message in found.message_type:
        for field in message.field:
            field.ClearField("json_name")
    return found


@pytest.mark.parametrize("path", ACCEPTANCE, ids=lambda path: path.stem)
def test_acceptance_files(path: Path, tmp_path: Path) -> None:
    compiled = analyse(path).system
    assert compiled is not None
    assert protoc(tmp_path, compiled) == file_descriptor(compiled)


def test_every_type_and_label(tmp_path: Path, snapshot: Snapshot) -> None:
    compiled = system(EVERYTHING)
    assert protoc(tmp_path, compiled) == file_descriptor(compiled)
    snapshot(proto_text(compiled), "everything.proto")


def test_the_same_system_gives_the_same_bytes() -> None:
    assert descriptor_set(system(EVERYTHING)) == descriptor_set(system(EVERYTHING))


def test_constants_of_different_enums_stay_apart() -> None:
    names = constant_names(system(EVERYTHING))
    assert names["PlayerState", "READY"] == "PLAYER_STATE_READY"
    assert names["Player", "STATE_READY"] == "PLAYER_STATE_READY_"


@pytest.mark.parametrize(
    ("name", "snake"),
    [
        ("TestBehavior", "test_behavior"),
        ("HTTPServer", "http_server"),
        ("Robot2Go", "robot2_go"),
        ("a_B", "a_b"),
    ],
)
def test_names_of_packages(name: str, snake: str) -> None:
    assert snake_case(name) == snake


def test_imported_messages_stay_in_their_files(tmp_path: Path) -> None:
    (tmp_path / "cell.proto").write_text(
        'syntax = "proto3"; package cell; message Goal { double x = 1; }  message Unused { int32 y = 1; }'
    )
    (tmp_path / "other.proto").write_text('syntax = "proto3"; message Never { int32 y = 1; }')
    text = """
    system Cell
    import "cell.proto"
    import "other.proto"
    message Job { Goal goal }
    topic t { state Job, Unused }
    srm r { liveness { r = A } }
    """
    found = analyse(Source(str(tmp_path / "main.aseme"), text))
    assert found.system is not None, render_text(found.diagnostics)
    assert (package_name(found.system), file_name(found.system)) == ("cell_system", "Cell_system.proto")
    (tmp_path / "out").mkdir()
    read = protoc(tmp_path / "out", found.system)
    assert read == file_descriptor(found.system)
    assert list(read.dependency) == ["cell.proto"]
    assert set(proto_files(found.system)) == {"cell.proto", "other.proto", "Cell_system.proto"}
    files = descriptor_pb2.FileDescriptorSet.FromString(descriptor_set(found.system)).file
    assert [file.name for file in files] == ["cell.proto", "other.proto", "Cell_system.proto"]


WORDS = st.sampled_from(
    """
    a b x_y xY _x to max group map oneof optional repeated reserved extensions message option rpc stream
    syntax package import double1 service returns public weak extend edition int32 fixed64 float1 A AB A_B ABC
    Thing local export inf nan
    """.split()
)
"""Names that mean something to protoc, or that look alike to it."""

FIELDS = st.lists(
    st.tuples(
        st.sampled_from(["", "optional ", "repeated "]),
        st.sampled_from(["int", "bool", "double", "string", "bytes", "duration", "T0", "E0"]),
        WORDS,
    ),
    max_size=6,
)


@given(
    st.lists(st.tuples(WORDS, FIELDS), max_size=4),
    st.lists(st.tuples(WORDS, st.lists(WORDS, min_size=1, max_size=4)), max_size=3),
)
@settings(max_examples=40)
def test_what_the_compiler_accepts_protoc_accepts(
    tmp_path_factory: pytest.TempPathFactory,
    messages: list[tuple[str, list[tuple[str, str, str]]]],
    enums: list[tuple[str, list[str]]],
) -> None:
    lines = ["system Any", "message T0 { int only }", "enum E0 { ZERO ONE }"]
    for name, fields in messages:
        body = "; ".join(f"{label}{kind} {field}" for label, kind, field in fields)
        lines.append(f"message {name} {{ {body} }}")
    lines += [f"enum {name} {{ {' '.join(constants)} }}" for name, constants in enums]
    lines.append("srm r { liveness { r = A } }")
    found = analyse(Source("any.aseme", "\n".join(lines))).system
    if found is not None:
        assert protoc(tmp_path_factory.mktemp("any"), found) == file_descriptor(found)
