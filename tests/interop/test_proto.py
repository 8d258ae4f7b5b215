"""Existing .proto files: what a document can use of them, and what it is told when they are wrong."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

from aseme_dsl.amola.messages import BOOL, BYTES, DOUBLE, INT, STRING, Kind, Type
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.project.editing.import_models import import_models
from aseme_dsl.source import Source
from tests.conftest import Snapshot

MOVEIT = """
syntax = "proto3";

package moveit.msgs;

import "geometry/pose.proto";
import "google/protobuf/timestamp.proto";

// What the arm does.
enum Phase {
  PHASE_IDLE = 0;
  PHASE_MOVING = 1;
  value = 2;
}

message Goal {
  message Tolerance { float position = 1; double angle = 2; }
  enum Kind { JOINT = 0; CARTESIAN = 3; }

  geometry.Pose target = 1;
  Tolerance tolerance = 2;
  Kind kind = 3;
  optional int32 tries = 4;
  repeated string frames = 5;
  map<string, sint64> limits = 6;
  oneof planner { bool fast = 7; bytes plan = 8; }
  google.protobuf.Timestamp stamp = 9;
  uint32 from = 10;
  Goal next = 11;
  Phase phase = 12;
  fixed32 class = 13;
}
service Arm { rpc Move (Goal) returns (Goal); }
"""
POSE = """
syntax = "proto3";
package geometry;
message Pose { double x = 1; double y = 2; Header header = 3; }
message Header { string frame = 1; }
"""
USE = """
system Cell
import "msgs/moveit.proto"
message Job { Goal goal  Phase phase  optional Goal_Tolerance tolerance }
topic arm { state Goal, Job }
srm cell {
  var phase : Phase = Phase.PHASE_MOVING
  var kind : Goal_Kind
  liveness { cell = A | B }
  control cell {
    enter A : [arm.state.Goal.target.x > 1 && arm.state.Goal.kind == Goal_Kind.CARTESIAN
               && phase == Phase.value_ && arm.state.Goal.tries < 3
               && arm.state.Goal.next.from_ == 2 && arm.state.Goal.stamp.seconds > 3]
    enter B : else
  }
}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "msgs").mkdir()
    (tmp_path / "geometry").mkdir()
    (tmp_path / "msgs" / "moveit.proto").write_text(MOVEIT)
    (tmp_path / "geometry" / "pose.proto").write_text(POSE)
    return tmp_path


def compiled(folder: Path, text: str) -> System:
    found = analyse(Source(str(folder / "main.aseme"), text))
    assert found.system is not None, render_text(found.diagnostics)
    return found.system


def test_messages_and_enums_are_used_like_own_ones(folder: Path) -> None:
    system = compiled(folder, USE)
    goal = system.message("Goal")
    assert goal is not None
    assert (goal.imported, goal.full_name) == ("msgs/moveit.proto", "moveit.msgs.Goal")
    assert [(field.name, field.number, field.type, field.label) for field in goal.fields] == [
        ("target", 1, Type(Kind.MESSAGE, "Pose"), ""),
        ("tolerance", 2, Type(Kind.MESSAGE, "Goal_Tolerance"), ""),
        ("kind", 3, Type(Kind.ENUM, "Goal_Kind"), ""),
        ("tries", 4, INT, "optional"),
        ("frames", 5, STRING, "repeated"),
        ("limits", 6, Type(Kind.MESSAGE, "Goal_LimitsEntry"), "repeated"),
        ("fast", 7, BOOL, "optional"),
        ("plan", 8, BYTES, "optional"),
        ("stamp", 9, Type(Kind.MESSAGE, "google_protobuf_Timestamp"), ""),
        ("from_", 10, INT, ""),
        ("next", 11, Type(Kind.MESSAGE, "Goal"), "optional"),
        ("phase", 12, Type(Kind.ENUM, "Phase"), ""),
        ("class_", 13, INT, ""),
    ]
    tolerance = system.message("Goal_Tolerance")
    assert tolerance is not None
    assert [field.type for field in tolerance.fields] == [DOUBLE, DOUBLE]
    phase = system.enum("Phase")
    assert phase is not None
    assert phase.constants == (("PHASE_IDLE", 0), ("PHASE_MOVING", 1), ("value_", 2))


def test_every_type_has_its_place_in_its_file(folder: Path) -> None:
    system = compiled(folder, USE)
    places = {item.name: f"{item.span}" for item in system.messages}
    assert places["Goal"].endswith("msgs/moveit.proto:16:9")
    assert places["Goal_Tolerance"].endswith("msgs/moveit.proto:17:11")
    assert places["Pose"] == "geometry/pose.proto:4:9"
    assert [field.span.text for field in system.messages[1].fields]


def test_files_come_with_their_descriptors_and_texts_in_order(folder: Path) -> None:
    system = compiled(folder, USE)
    assert [(file.name, file.text) for file in system.protos] == [
        ("geometry/pose.proto", POSE),
        ("google/protobuf/timestamp.proto", ""),
        ("msgs/moveit.proto", MOVEIT),
    ]


def test_two_imports_that_share_a_file_share_its_types(folder: Path) -> None:
    text = 'import "geometry/pose.proto"\n' + USE + "topic where { state Pose }"
    system = compiled(folder, text)
    assert [file.name for file in system.protos].count("geometry/pose.proto") == 1
    assert [item.name for item in system.messages].count("Pose") == 1


def test_an_own_type_hides_one_that_is_only_needed_by_an_import(folder: Path) -> None:
    system = compiled(folder, USE + "message Header { int x }")
    header, theirs = system.message("Header"), system.message("geometry_Header")
    assert header is not None and theirs is not None
    assert (header.imported, theirs.imported) == (None, "geometry/pose.proto")


def test_texts_of_an_editor_go_before_the_disk(folder: Path) -> None:
    sources = {str(folder / "geometry" / "pose.proto"): POSE.replace("double x", "bool ok = 9; double x")}
    found = analyse(Source(str(folder / "main.aseme"), USE), sources)
    assert found.system is not None
    pose = found.system.message("Pose")
    assert pose is not None and pose.field("ok") is not None


def test_what_is_wrong_is_said_where_it_is(folder: Path, snapshot: Snapshot) -> None:
    (folder / "bad.proto").write_text(
        'syntax = "proto3";\nimport "none.proto";\nmessage A {\n\tdble x = 1;\n  int32 y = 1;\n}\n'
    )
    (folder / "worse.proto").write_text("this is no proto\n")
    text = USE.replace("import", 'import "bad.proto"\nimport "worse.proto"\nimport "nowhere.proto"\nimport')
    text = text.replace("state Goal, Job", "state Goal, Job, A")
    text = text.replace(
        "tries < 3", "frames == 1 && arm.state.Goal.limits.key == 3 && arm.state.Goal.from == 1"
    )
    found = analyse(Source(str(folder / "main.aseme"), text))
    assert found.system is None
    snapshot(render_text(found.diagnostics).replace(str(folder), "FOLDER"), "wrong.txt")


def test_an_own_type_of_the_same_name_as_an_imported_one(folder: Path) -> None:
    found = analyse(Source(str(folder / "main.aseme"), USE + "message Goal { int x }"))
    assert [item.code for item in found.diagnostics] == ["E201"]
    assert "moveit.proto" in str(found.diagnostics[0].related[0].span)


def test_old_files_with_required_fields_groups_and_defaults(tmp_path: Path) -> None:
    (tmp_path / "old.proto").write_text(
        """
        syntax = "proto2";
        message Old {
          required int32 id = 1;
          optional double weight = 2 [default = 1.5];
          optional group Part = 3 { optional int32 n = 4; }
          optional Old child = 5;
          extensions 100 to 199;
        }
        extend Old { optional int32 more = 100; }
        enum E { FIRST = 3; SECOND = -1; }
        """
    )
    system = compiled(tmp_path, 'system S\nimport "old.proto"\nsrm r { liveness { r = A } }')
    old = system.message("Old")
    assert old is not None
    assert [(field.name, field.label) for field in old.fields] == [
        ("id", ""),
        ("weight", "optional"),
        ("part", ""),
        ("child", "optional"),
    ]


def test_without_grpcio_tools_the_extra_is_named(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        "aseme_dsl.interop.proto.find_spec", lambda name: None if name == "grpc_tools" else find_spec(name)
    )
    found = analyse(Source(str(folder / "main.aseme"), USE)).diagnostics
    assert [item.code for item in found] == ["E007"]
    assert found[0].hint == 'pip install "aseme-dsl[proto]"'
    assert found[0].span is not None and found[0].span.text == '"msgs/moveit.proto"'


@pytest.mark.parametrize("name", ["x" * 300 + ".proto", "a/" * 3000 + "b.proto", "a\nb.proto"])
def test_an_import_that_no_file_can_be_called_is_not_found(name: str, tmp_path: Path) -> None:
    text = f'syntax = "proto3";\nimport "{name}";\nmessage M {{ int32 x = 1; }}\n'
    (tmp_path / "m.proto").write_text(text, "utf-8")
    (tmp_path / "main.aseme").write_text('system S\nimport "m.proto"\ntopic t { state M }\n', "utf-8")
    found = analyse(tmp_path / "main.aseme").diagnostics
    assert found and all(
        item.span is not None and item.span.source.path.endswith("m.proto") for item in found
    )
    (tmp_path / "a.sag").write_text("<a/>", "utf-8")
    assert import_models([tmp_path / "a.sag", tmp_path / "m.proto"]).diagnostics
