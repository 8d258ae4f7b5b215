"""The generated module `messages`: its classes, its checkers, and its messages as bytes and back."""

from __future__ import annotations

import dataclasses
import importlib.util
import math
import struct
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.system import System
from aseme_dsl.codegen.messages import generate_messages
from aseme_dsl.codegen.proto import descriptor_set, full_name
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.runtime.message.wire import WireError
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.support.compiling import system

TEXT = """
system TestSystem
message Outer { Inner inner  Kind kind = 9 }
message Inner { double x  double y }
enum Kind { SMALL LARGE = 200 }
message All {
  bool truth
  int number
  double measure
  string name
  bytes raw
  duration time
  Kind kind
  Outer outer
  repeated int numbers
  repeated Outer outers
  repeated Kind kinds
  optional int perhaps
  optional Inner where
  optional Kind mood
}
message Small {
  bool truth  int number  double measure  Kind kind  duration time  Inner inner  optional int perhaps
}
message Empty { }
enum An_enum_with_a_very_long_name_that_does_not_fit { ONE_CONSTANT_WITH_A_LONG_NAME }
message A_message_with_a_very_long_name_that_does_not_fit_a_line_with_its_default {
  Inner one_more_long_name_of_a_member
  An_enum_with_a_very_long_name_that_does_not_fit and_another_long_name
  optional A_message_with_a_very_long_name_that_does_not_fit_a_line_with_its_default the_same_again
  repeated An_enum_with_a_very_long_name_that_does_not_fit and_several_of_them
}
topic t { state All, Small  signal A_message_with_a_very_long_name_that_does_not_fit_a_line_with_its_default }
topic air radio 40 { state Small  signal Inner, Empty }
srm r { liveness { r = A } }
"""


def module_of(compiled: System, folder: Path, name: str = "messages") -> ModuleType:
    path = folder / f"{name}.py"
    path.write_text(generate_messages(compiled))
    spec = importlib.util.spec_from_file_location(f"generated_{folder.name}_{name}", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def compiled() -> System:
    return system(TEXT)


@pytest.fixture(scope="module")
def messages(compiled: System, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    return module_of(compiled, tmp_path_factory.mktemp("messages"))


def test_text(compiled: System, snapshot: Snapshot) -> None:
    snapshot(generate_messages(compiled), "messages.py.txt")
    assert generate_messages(system(TEXT)) == generate_messages(compiled)


def test_checkers_find_nothing(tmp_path: Path) -> None:
    texts = {"messages": TEXT, "nothing": "system Nothing\nsrm r { liveness { r = A } }"}
    for name, text in texts.items():
        (tmp_path / f"{name}.py").write_text(generate_messages(system(text)))
    files = [str(tmp_path / f"{name}.py") for name in texts]
    rules = "E4,E7,E9,F,W,I,B,UP,SIM,RUF,PTH,D100,D101,D103"
    for command in (
        ["ruff", "check", "--isolated", "--select", rules],
        ["ruff", "format", "--isolated", "--check"],
        ["ruff", "format", "--isolated", "--check", "--line-length", "110"],
        ["mypy", "--strict", "--config-file", "", "--cache-dir", str(tmp_path / "cache")],
    ):
        done = subprocess.run([sys.executable, "-m", *command, *files], capture_output=True, text=True)
        assert done.returncode == 0, " ".join(command) + done.stdout + done.stderr


def test_messages_are_immutable_and_have_defaults(messages: ModuleType) -> None:
    message = messages.All()
    assert (message.number, message.raw, message.numbers, message.perhaps, message.where) == (
        0,
        b"",
        (),
        None,
        None,
    )
    assert message.outer == messages.Outer(inner=messages.Inner(), kind=messages.Kind.SMALL)
    with pytest.raises(dataclasses.FrozenInstanceError):
        message.number = 1
    assert hash(message) == hash(messages.All())


def test_every_channel_has_its_class(messages: ModuleType) -> None:
    assert messages.CHANNELS["t.state.All"] is messages.All
    assert list(messages.SCHEMA.radio) == ["air.state.Small", "air.signal.Inner", "air.signal.Empty"]


# ---- Protocol Buffers --------------------------------------------------------------------------

INT64 = st.integers(-(2**63), 2**63 - 1)
DOUBLE = st.floats(allow_nan=False)
NAME = st.text(st.characters(exclude_categories=("Cs",)))


def all_messages(messages: ModuleType) -> st.SearchStrategy[Any]:
    kind = st.sampled_from(messages.Kind)
    inner = st.builds(messages.Inner, DOUBLE, DOUBLE)
    outer = st.builds(messages.Outer, inner, kind)
    return st.builds(
        messages.All,
        truth=st.booleans(),
        number=INT64,
        measure=DOUBLE,
        name=NAME,
        raw=st.binary(max_size=9),
        time=INT64,
        kind=kind,
        outer=outer,
        numbers=st.lists(INT64, max_size=3).map(tuple),
        outers=st.lists(outer, max_size=2).map(tuple),
        kinds=st.lists(kind, max_size=3).map(tuple),
        perhaps=st.none() | INT64,
        where=st.none() | inner,
        mood=st.none() | kind,
    )


@given(st.data())
@settings(max_examples=80)
def test_what_goes_over_the_wire_comes_back(messages: ModuleType, data: st.DataObject) -> None:
    message = data.draw(all_messages(messages))
    wire = messages.SCHEMA.encode(message)
    back = messages.SCHEMA.decode(messages.All, wire)
    assert back == message
    assert type(back.kind) is messages.Kind
    assert messages.SCHEMA.encode(back) == wire


def test_other_programs_read_the_same_with_the_written_descriptors(
    compiled: System, messages: ModuleType
) -> None:
    pool = descriptor_pool.DescriptorPool()
    for file in descriptor_pb2.FileDescriptorSet.FromString(descriptor_set(compiled)).file:
        pool.Add(file)
    message = compiled.message("All")
    assert message is not None
    theirs = message_factory.GetMessageClass(pool.FindMessageTypeByName(full_name(compiled, message)))()
    theirs.ParseFromString(
        messages.SCHEMA.encode(
            messages.All(number=-3, kinds=(messages.Kind.LARGE,), where=messages.Inner(x=2))
        )
    )
    assert (theirs.number, list(theirs.kinds), theirs.where.x, theirs.HasField("perhaps")) == (
        -3,
        [200],
        2.0,
        False,
    )


def test_two_systems_do_not_disturb_each_other(tmp_path: Path) -> None:
    text = "system S\nmessage M {{ {} x }}\ntopic t {{ state M }}\nsrm r {{ liveness {{ r = A }} }}"
    one = module_of(system(text.format("int")), tmp_path, "one")
    two = module_of(system(text.format("string")), tmp_path, "two")
    assert one.SCHEMA.decode(one.M, one.SCHEMA.encode(one.M(3))).x == 3
    assert two.SCHEMA.decode(two.M, two.SCHEMA.encode(two.M("a"))).x == "a"
    with pytest.raises(WireError, match="M is not a message of this system"):
        one.SCHEMA.encode(two.M("a"))


@pytest.mark.parametrize(
    ("members", "words"),
    [
        ({"number": 2**63}, "All.number = 9223372036854775808"),
        ({"name": "\ud800"}, "All.name"),
    ],
)
def test_what_cannot_be_encoded_is_named(messages: ModuleType, members: dict[str, Any], words: str) -> None:
    with pytest.raises(WireError) as problem:
        messages.SCHEMA.encode(messages.All(**members))
    assert words in str(problem.value)


def test_what_cannot_be_decoded_is_said(messages: ModuleType) -> None:
    with pytest.raises(WireError, match="2 bytes cannot be read as All"):
        messages.SCHEMA.decode(messages.All, b"\xff\xff")
    with pytest.raises(WireError, match=r"Outer\.kind: Kind has no constant with the number 7"):
        messages.SCHEMA.decode(messages.Outer, b"\x48\x07")


def test_imported_messages_with_maps_and_oneofs(tmp_path: Path) -> None:
    (tmp_path / "old.proto").write_text(
        """
        syntax = "proto3";
        package old;
        message Thing {
          map<string, sint32> limits = 1;
          map<int32, Thing> things = 2;
          oneof choice { bool fast = 3; bytes plan = 4; }
          fixed32 class = 5;
          Thing next = 6;
          map<string, Mood> moods = 7;
          enum Mood { CALM = 0; ANGRY = 4; }
        }
        """
    )
    found = analyse(
        Source(
            str(tmp_path / "main.aseme"),
            'system S\nimport "old.proto"\ntopic t { state Thing }\nsrm r { liveness { r = A } }',
        )
    )
    assert found.system is not None, render_text(found.diagnostics)
    module = module_of(found.system, tmp_path)
    thing = module.Thing(
        limits=(module.Thing_LimitsEntry("a", -1), module.Thing_LimitsEntry("b", 2)),
        things=(module.Thing_ThingsEntry(3, module.Thing(class_=7)),),
        moods=(module.Thing_MoodsEntry("x", module.Thing_Mood.ANGRY),),
        plan=b"x",
        next=module.Thing(fast=False),
    )
    assert module.SCHEMA.decode(module.Thing, module.SCHEMA.encode(thing)) == thing
    with pytest.raises(WireError, match="more than one member of `choice`"):
        module.SCHEMA.encode(module.Thing(fast=True, plan=b""))


# ---- radio -------------------------------------------------------------------------------------


@given(st.data())
@settings(max_examples=80)
def test_what_goes_by_radio_comes_back(messages: ModuleType, data: st.DataObject) -> None:
    single = st.floats(width=32, allow_nan=False)
    int32 = st.integers(-(2**31), 2**31 - 1)
    message = data.draw(
        st.builds(
            messages.Small,
            truth=st.booleans(),
            number=int32,
            measure=single,
            kind=st.sampled_from(messages.Kind),
            time=int32.map(lambda milliseconds: milliseconds * 1_000_000),
            inner=st.builds(messages.Inner, single, single),
            perhaps=st.none() | int32,
        )
    )
    payload = messages.SCHEMA.pack("air.state.Small", message)
    assert len(payload) <= 1 + 1 + 4 + 4 + 1 + 4 + 8 + 5 <= 40
    assert messages.SCHEMA.unpack(payload) == ("air.state.Small", message)


def test_a_double_travels_in_single_precision_and_time_in_milliseconds(messages: ModuleType) -> None:
    sent = messages.Small(measure=0.1, time=1_499_999)
    _, heard = messages.SCHEMA.unpack(messages.SCHEMA.pack("air.state.Small", sent))
    assert heard.measure == struct.unpack(">f", struct.pack(">f", 0.1))[0]
    assert heard.time == 1_000_000
    _, endless = messages.SCHEMA.unpack(
        messages.SCHEMA.pack("air.signal.Inner", messages.Inner(math.inf, math.nan))
    )
    assert endless.x == math.inf and math.isnan(endless.y)


def test_a_small_message_takes_few_bytes(messages: ModuleType) -> None:
    assert messages.SCHEMA.pack("air.signal.Empty", messages.Empty()) == b"\x02"
    assert messages.SCHEMA.pack("air.signal.Inner", messages.Inner(1.0, -2.0)).hex() == "013f800000c0000000"


@pytest.mark.parametrize(
    ("members", "words"),
    [
        ({"number": 2**31}, "Small.number = 2147483648 does not fit the radio's 4 bytes"),
        ({"measure": 1e300}, "Small.measure = 1e+300 does not fit"),
        ({"time": 2**63}, "Small.time"),
        ({"perhaps": -(2**31) - 1}, "Small.perhaps"),
    ],
)
def test_what_does_not_fit_is_named(messages: ModuleType, members: dict[str, Any], words: str) -> None:
    with pytest.raises(WireError) as problem:
        messages.SCHEMA.pack("air.state.Small", messages.Small(**members))
    assert words in str(problem.value)


def test_the_wrong_channel_or_message_is_named(messages: ModuleType) -> None:
    with pytest.raises(WireError, match="does not travel by radio"):
        messages.SCHEMA.pack("t.state.All", messages.All())
    with pytest.raises(WireError, match="carries Inner, not Empty"):
        messages.SCHEMA.pack("air.signal.Inner", messages.Empty())


@given(st.binary(max_size=40))
def test_noise_on_the_radio_is_an_error_or_a_message(messages: ModuleType, noise: bytes) -> None:
    try:
        channel, message = messages.SCHEMA.unpack(noise)
    except WireError:
        return
    assert messages.CHANNELS[channel] is type(message)
