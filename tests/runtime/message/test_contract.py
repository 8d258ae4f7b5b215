"""Messages of one build, read by another: as Protocol Buffers read them, or refused."""

from __future__ import annotations

import base64
from typing import Any

from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime.message.contract import Contract, contract_of, loads, reading
from aseme_dsl.runtime.message.wire import WireError
from tests.support.generated import Generated, generate

TYPES = ("bool", "int", "double", "string", "bytes", "duration", "Colour", "Inner", "Shared")
NAMES = ("a", "b", "c", "d")

Fields = dict[str, tuple[int, str, str]]
"""The fields of a message: number, label and type by name."""


@st.composite
def fields(draw: st.DrawFn, types: tuple[str, ...] = TYPES) -> Fields:
    names = draw(st.lists(st.sampled_from(NAMES), unique=True, min_size=1))
    numbers = draw(st.permutations(range(1, 6)))
    usual = {name: number for number, name in enumerate(NAMES, 1)}
    is_usual = draw(st.integers(0, 3)) > 0
    return {
        name: (
            usual[name] if is_usual else numbers[place],
            draw(st.sampled_from(("", "optional", "repeated"))),
            draw(st.sampled_from(types))
            if draw(st.booleans())
            else ("int", "Shared", "string", "Colour")[NAMES.index(name)],
        )
        for place, name in enumerate(names)
    }


def text(outer: Fields, inner: Fields, constants: list[str]) -> str:
    def one(found: Fields) -> str:
        return "  ".join(f"{label} {kind} {name} = {number}" for name, (number, label, kind) in found.items())

    return f"""
system Wire
enum Colour {{ {"  ".join(constants)} }}
message Shared {{ int x }}
message Inner {{ {one(inner)} }}
message M {{ {one(outer)} }}
topic team {{ state M }}
srm r {{ liveness {{ r = A }} activities {{ A takes 1s writes team.state.M }} }}
team T {{ ann : r }}
"""


simple = tuple(kind for kind in TYPES if kind != "Inner")
builds = st.tuples(
    fields(), fields(simple), st.sampled_from((["RED", "GREEN"], ["RED", "GREEN", "BLUE"], ["RED", "BLUE"]))
)


@st.composite
def pairs(draw: st.DrawFn) -> tuple[Any, Any]:
    """Two builds that differ in little: most are compatible."""
    outer, inner, constants = draw(builds)
    others = [dict(outer), dict(inner)]
    for found in others:
        name = draw(st.sampled_from(NAMES))
        if name in found:
            number, label, kind = found[name]
            change = draw(st.sampled_from(("nothing", "remove", "optional", "required", "type")))
            if change == "remove" and len(found) > 1:
                del found[name]
            elif change == "type":
                found[name] = number, label, draw(st.sampled_from(simple))
            elif change in ("optional", "required") and label != "repeated":
                found[name] = number, "optional" if change == "optional" else "", kind
        elif draw(st.booleans()):
            found[name] = max(number for number, _, _ in found.values()) + 1, "optional", "int"
    more = draw(st.sampled_from((constants, ["RED", "GREEN", "BLUE"])))
    new, old = (outer, inner, constants), (others[0], others[1], more)
    return draw(st.sampled_from(((new, old), (old, new))))


def proto_of(generated: Generated) -> type[Any]:
    """The class that Google's library makes of the descriptors of a build."""
    pool = descriptor_pool.DescriptorPool()
    data = base64.b64decode(generated.messages.SCHEMA.descriptors)
    for file in descriptor_pb2.FileDescriptorSet.FromString(data).file:
        pool.Add(file)
    return message_factory.GetMessageClass(pool.FindMessageTypeByName("wire.M"))


def values(kind: str, constants: list[str]) -> st.SearchStrategy[Any]:
    match kind:
        case "bool":
            return st.booleans()
        case "int" | "duration":
            return st.integers(-3, 2**40)
        case "double":
            return st.floats(-8, 8, width=16)
        case "string":
            return st.text("ab", max_size=3)
        case "bytes":
            return st.binary(max_size=3)
        case _:
            return st.integers(0, len(constants) - 1)


def filled(draw: Any, proto: Any, generated: Generated, name: str, known: dict[str, Fields]) -> None:
    """Set fields of a message as Google's library has it."""
    colours = [item.value for item in generated.messages.Colour]
    for field, (_, label, kind) in known[name].items():
        for _ in range(draw(st.integers(0, 2 if label == "repeated" else 1))):
            if kind in known:
                target = getattr(proto, field)
                inside = target.add() if label == "repeated" else target
                inside.SetInParent()
                filled(draw, inside, generated, kind, known)
                continue
            value = draw(values(kind, colours))
            value = colours[value] if kind == "Colour" else value
            if label == "repeated":
                getattr(proto, field).append(value)
            else:
                setattr(proto, field, value)


def expected(theirs: Any, mine: Any, name: str, known: dict[str, Fields], sent: dict[str, Fields]) -> Any:
    """What a message is for its reader, by the two messages that Google's library has read."""
    found = {}
    for field, (_, label, kind) in known[name].items():

        def one(value: Any, other: Any, kind: str = kind) -> Any:
            return expected(other, value, kind, known, sent) if kind in known else value

        if label == "repeated":
            others = getattr(theirs, field, [None] * 9) if field in sent[name] else [None] * 9
            found[field] = [one(*pair) for pair in zip(getattr(mine, field), others, strict=False)]
        elif label == "optional" and (
            field not in sent[name] or (sent[name][field][1] == "optional" and not theirs.HasField(field))
        ):
            found[field] = None
        else:
            found[field] = one(getattr(mine, field), getattr(theirs, field, None))
    return found


def plain(message: Any) -> Any:
    if isinstance(message, tuple):
        return [plain(item) for item in message]
    if hasattr(message, "__dataclass_fields__"):
        return {name: plain(getattr(message, name)) for name in message.__dataclass_fields__}
    return message


def known_constants(message: Any, numbers: set[int]) -> bool:
    """Whether a message has no enum with a number that its reader does not have."""
    for descriptor, value in message.ListFields():
        items = value if descriptor.is_repeated else [value]
        if descriptor.enum_type is not None and not set(items) <= numbers:
            return False
        if descriptor.message_type is not None and not all(known_constants(i, numbers) for i in items):
            return False
    return True


def is_same(one: Fields, other: Fields) -> bool:
    return all(other.get(name, about)[0::2] == about[0::2] for name, about in one.items())


@given(st.one_of(pairs(), pairs(), pairs(), st.tuples(builds, builds)), st.data())
@settings(max_examples=100, deadline=None)
def test_what_is_read_is_what_protocol_buffers_read(two: Any, data: Any) -> None:
    new, old = two
    sender, reader = generate(text(*new)), generate(text(*old))
    ours = contract_of(reader.messages.SCHEMA, [], "old")
    theirs = contract_of(sender.messages.SCHEMA, [], "new")
    assert loads(theirs.dumps()) == theirs and loads(theirs.dumps()).number == theirs.number
    view = reading(ours, theirs)
    known = {"M": old[0], "Inner": old[1], "Shared": {"x": (1, "", "int")}}
    sent = {"M": new[0], "Inner": new[1], "Shared": {"x": (1, "", "int")}}
    said = proto_of(sender)()
    filled(data.draw, said, sender, "M", sent)
    payload = said.SerializeToString()
    if reason := view.channels.get("team.state.M"):
        assert is_refused_rightly(known, sent, old[2], new[2]), reason
        return
    assert not is_refused_rightly(known, sent, old[2], new[2])
    read = proto_of(reader).FromString(payload)
    numbers = {item.value for item in reader.messages.Colour}
    try:
        found = reader.messages.SCHEMA.decode(reader.messages.M, payload, view.zeros)
    except WireError:
        assert not known_constants(read, numbers)
        return
    if known_constants(read, numbers):
        assert plain(found) == expected(said, read, "M", known, sent)


def is_refused_rightly(
    known: dict[str, Fields], sent: dict[str, Fields], mine: list[str], theirs: list[str]
) -> bool:
    """Whether two schemas are incompatible, by the table in the documentation."""

    def clash(ours: str, other: str) -> bool:
        fields_, others = known[ours], sent[other]
        numbers = {about[0]: name for name, about in others.items()}
        for name, (number, label, kind) in fields_.items():
            if name not in others:
                if number in numbers or not label:
                    return True
                continue
            number_, label_, kind_ = others[name]
            if number != number_ or ("repeated" in {label, label_} and label != label_):
                return True
            if label_ == "optional" and not label:
                return True
            both = kind in known and kind_ in sent
            if (kind != kind_ and not both) or (both and clash(kind, kind_)):
                return True
            if kind == "Colour" and mine[1] != theirs[1]:
                return True
        return False

    return clash("M", "M")


def test_a_contract_is_small() -> None:
    schema = generate(text({"a": (1, "", "int")}, {"a": (1, "", "int")}, ["RED"])).messages.SCHEMA
    found: Contract = contract_of(schema, [])
    assert len(found.dumps()) < 300
