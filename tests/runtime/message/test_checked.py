"""Messages made in Python hold to the types of their fields."""

import dataclasses
import importlib.util
from pathlib import Path
from types import ModuleType

import numpy
import pytest

import aseme_dsl
from aseme_dsl.codegen.messages import generate_messages
from aseme_dsl.source import Source

TEXT = """
system S
enum Mode { idle = 0  busy = 3 }
message Point { double x  double y }
message M {
  bool b  int i  double d  string s  bytes raw  duration t  Mode mode  Point at
  optional int oi  optional Mode om  repeated double ds  repeated Point points  repeated Mode modes
}
topic t { state M }
srm r { liveness { r = A } activities { A } }
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    path: Path = tmp_path_factory.mktemp("made") / "messages_of_checked.py"
    path.write_text(generate_messages(aseme_dsl.compile(Source("s.aseme", TEXT))))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    import sys

    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("field", "given", "kept"),
    [
        ("d", 3, 3.0),
        ("d", numpy.float32(0.5), 0.5),
        ("d", numpy.float64(0.25), 0.25),
        ("i", numpy.int64(7), 7),
        ("b", numpy.bool_(True), True),
        ("raw", bytearray(b"ab"), b"ab"),
        ("ds", [1, 2.5], (1.0, 2.5)),
        ("ds", numpy.array([1.0, 2.0]), (1.0, 2.0)),
        ("oi", None, None),
        ("oi", 4, 4),
    ],
)
def test_what_means_the_same_is_converted(made: ModuleType, field: str, given: object, kept: object) -> None:
    value = getattr(made.M(**{field: given}), field)
    assert value == kept
    assert type(value) is type(kept)
    if isinstance(kept, tuple):
        assert [type(item) for item in value] == [type(item) for item in kept]


def test_a_number_becomes_its_constant(made: ModuleType) -> None:
    message = made.M(mode=3, om=numpy.int32(3), modes=[0, made.Mode.busy])
    assert message.mode is made.Mode.busy
    assert message.om is made.Mode.busy
    assert message.modes == (made.Mode.idle, made.Mode.busy)


def test_fields_that_fit_are_kept_as_they_are(made: ModuleType) -> None:
    points = (made.Point(x=1.0),)
    message = made.M(at=points[0], points=points)
    assert message.at is points[0]
    assert message.points is points


@pytest.mark.parametrize(
    ("field", "given", "error"),
    [
        ("i", "3", "M.i: an int is wanted, not '3'"),
        ("i", 3.0, "M.i: an int is wanted, not 3.0"),
        ("i", True, "M.i: an int is wanted, not True"),
        ("i", None, "M.i: an int is wanted, not None"),
        ("t", 0.5, "M.t: an int is wanted, not 0.5"),
        ("d", "1.5", "M.d: a number is wanted, not '1.5'"),
        ("b", 1, "M.b: True or False is wanted, not 1"),
        ("s", 5, "M.s: a str is wanted, not 5"),
        ("raw", "text", "M.raw: bytes is wanted, not 'text'"),
        ("mode", "busy", "M.mode: one of idle, busy of Mode is wanted, not 'busy'"),
        ("at", (1, 2), "M.at: a Point is wanted, not (1, 2)"),
        ("oi", "4", "M.oi: an int is wanted, not '4'"),
        ("ds", 1.0, "M.ds: a tuple is wanted, not 1.0"),
        ("ds", "12", "M.ds: a tuple is wanted, not '12'"),
        ("ds", [1.0, "x"], "M.ds[1]: a number is wanted, not 'x'"),
        ("points", (None,), "M.points[0]: a Point is wanted, not None"),
    ],
)
def test_another_type_is_an_error(made: ModuleType, field: str, given: object, error: str) -> None:
    with pytest.raises(TypeError) as caught:
        made.M(**{field: given})
    assert str(caught.value) == error


def test_a_number_without_a_constant_is_an_error(made: ModuleType) -> None:
    with pytest.raises(ValueError) as caught:
        made.M(mode=1)
    assert str(caught.value) == "M.mode: Mode has no constant with the number 1"


def test_a_constant_of_another_enum_is_an_error(made: ModuleType) -> None:
    class Other(made.Mode.__mro__[1]):  # type: ignore[misc]
        busy = 3

    with pytest.raises(TypeError):
        made.M(mode=Other.busy)


def test_a_changed_copy_is_checked(made: ModuleType) -> None:
    with pytest.raises(TypeError):
        dataclasses.replace(made.M(), i="3")


def test_an_integer_that_no_double_holds_is_an_error(made: ModuleType) -> None:
    with pytest.raises(TypeError):
        made.M(d=10**400)
