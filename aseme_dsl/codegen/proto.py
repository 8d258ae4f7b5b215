"""Protocol Buffers: a system's messages as descriptors in memory and as `.proto` text that says the same.

Types of the language: `bool`, `string` and `bytes` are themselves, `int` is int64 so that no value is lost,
`double` is double, and a `duration` is an int64 of nanoseconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePath
from typing import TYPE_CHECKING

from aseme_dsl.amola.messages import DURATION, EnumType, Field, Kind, Message
from aseme_dsl.amola.python_names import kept_apart
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.place import place
from aseme_dsl.runtime.message.naming import snake_case

if TYPE_CHECKING:
    from google.protobuf.descriptor_pb2 import DescriptorProto, FileDescriptorProto

SCALARS = {
    Kind.BOOL: "bool",
    Kind.INT: "int64",
    Kind.DOUBLE: "double",
    Kind.STRING: "string",
    Kind.BYTES: "bytes",
    Kind.DURATION: "int64",
}

_WORDS = frozenset(
    """
    double float int32 int64 uint32 uint64 sint32 sint64 fixed32 fixed64 sfixed32 sfixed64 bool string bytes
    message enum group map oneof optional required repeated reserved extensions extend option import public
    weak package service rpc returns stream syntax edition to max export local
    """.split()
)
"""Words that mean something at the beginning of a field: a type of this name is written with its package."""


def package_name(system: System) -> str:
    """The package of the messages: the system's name, unless an imported file has taken that."""
    taken = {PurePath(file.name).stem for file in system.protos}
    taken |= {item.full_name.split(".")[0] for item in system.enums if item.imported}
    taken |= {item.full_name.split(".")[0] for item in system.messages if item.imported}
    name = snake_case(system.name) or "system"
    while name in taken:
        name += "_system"
    return name


def file_name(system: System) -> str:
    """What the `.proto` file is called: as the system is, unless an imported file stands there already."""
    taken = {PurePath(file.name).stem.lower() for file in system.protos}
    name = system.name
    while name.lower() in taken:  # also where a file system takes cell.proto for Cell.proto
        name += "_system"
    return f"{name}.proto"


def full_name(system: System, item: Message | EnumType) -> str:
    """The name of a message or enum on the wire: `kouretes.Ball`, or that of the file that it came from."""
    return item.full_name if item.imported else f"{package_name(system)}.{item.name}"


# ---- descriptors -------------------------------------------------------------------------------


def file_descriptor(system: System) -> FileDescriptorProto:
    """The descriptor of the system's own messages and enums, as protoc makes it from `proto_text`."""
    from google.protobuf import descriptor_pb2

    file = descriptor_pb2.FileDescriptorProto(
        name=file_name(system), package=package_name(system), syntax="proto3", dependency=_imports(system)
    )
    constants = constant_names(system)
    for enum in system.enums:
        if not enum.imported:
            described = file.enum_type.add(name=enum.name)
            for name, number in enum.constants:
                described.value.add(name=constants[enum.name, name], number=number)
    for message in system.messages:
        if not message.imported:
            _describe(system, message, file.message_type.add(name=message.name))
    return file


def _describe(system: System, message: Message, described: DescriptorProto) -> None:
    from google.protobuf.descriptor_pb2 import FieldDescriptorProto as Proto

    types = {
        "bool": Proto.TYPE_BOOL,
        "int64": Proto.TYPE_INT64,
        "double": Proto.TYPE_DOUBLE,
        "string": Proto.TYPE_STRING,
        "bytes": Proto.TYPE_BYTES,
    }
    taken = {field.name for field in message.fields}
    for field in message.fields:
        label = Proto.LABEL_REPEATED if field.label == "repeated" else Proto.LABEL_OPTIONAL
        member = described.field.add(name=field.name, number=field.number, label=label)
        if field.type.kind in SCALARS:
            member.type = types[SCALARS[field.type.kind]]
        else:
            member.type = Proto.TYPE_ENUM if field.type.kind is Kind.ENUM else Proto.TYPE_MESSAGE
            member.type_name = "." + full_name(system, _declared(system, field))
        if field.label == "optional":
            # As protoc does it: presence is a oneof of one member, with a name that nothing else has.
            name = field.name if field.name.startswith("_") else f"_{field.name}"
            while name in taken:
                name = f"X{name}"
            taken.add(name)
            member.proto3_optional = True
            member.oneof_index = len(described.oneof_decl)
            described.oneof_decl.add(name=name)


def _declared(system: System, field: Field) -> Message | EnumType:
    name = field.type.name
    found = system.enum(name) if field.type.kind is Kind.ENUM else system.message(name)
    assert found is not None
    return found


def _imports(system: System) -> list[str]:
    """The imported files that the system's own fields need, in their order."""
    used = {
        declared.imported
        for message in system.messages
        if not message.imported
        for field in message.fields
        if field.type.kind not in SCALARS
        for declared in (_declared(system, field),)
    }
    return [file.name for file in system.protos if file.name in used]


def descriptor_set(system: System) -> bytes:
    """A serialized FileDescriptorSet: the imported files in their order, then the system's own."""
    from google.protobuf import descriptor_pb2

    files = [descriptor_pb2.FileDescriptorProto.FromString(file.descriptor) for file in system.protos]
    files.append(file_descriptor(system))
    return descriptor_pb2.FileDescriptorSet(file=files).SerializeToString(deterministic=True)


def constant_names(system: System) -> dict[tuple[str, str], str]:
    """The name on the wire of each (enum, constant) of the document's own: with the enum's name in front.

    Protocol Buffers put the constants of all enums of a package side by side.
    """
    taken = {item.name for item in system.messages} | {item.name for item in system.enums}
    wishes = (
        ((enum.name, constant), f"{snake_case(enum.name).upper()}_{constant}")
        for enum in system.enums
        if not enum.imported
        for constant, _ in enum.constants
    )
    return kept_apart(wishes, taken)


# ---- text --------------------------------------------------------------------------------------


def proto_files(system: System) -> dict[str, str]:
    """Every file of the system by name: its own, and the imported ones that protoc does not bring itself."""
    files = {file.name: file.text for file in system.protos if not file.name.startswith("google/protobuf/")}
    return files | {file_name(system): proto_text(system)}


def proto_text(system: System) -> str:
    """The system's own messages as a `.proto` file."""
    return "\n".join(_lines(system)) + "\n"


def _lines(system: System) -> Iterator[str]:
    spans = [enum.span for enum in system.enums if not enum.imported]
    spans += [message.span for message in system.messages if not message.imported]
    files = dict.fromkeys(PurePath(span.source.path).name for span in spans)
    origin = ", ".join(files) or (PurePath(system.span.source.path).name if system.span else system.name)
    yield f"// The messages of {system.name}, generated from {origin}: a change here is lost."
    yield ""
    yield 'syntax = "proto3";'
    yield ""
    yield f"package {package_name(system)};"
    imports = _imports(system)
    if imports:
        yield ""
        yield from (f'import "{name}";' for name in imports)
    constants = constant_names(system)
    for enum in system.enums:
        if not enum.imported:
            yield ""
            yield f"// {place(enum.span)}"
            yield f"enum {enum.name} {{"
            yield from (f"  {constants[enum.name, name]} = {number};" for name, number in enum.constants)
            yield "}"
    for message in system.messages:
        if not message.imported:
            yield ""
            yield f"// {place(message.span)}"
            yield f"message {message.name} {{"
            yield from (f"  {_field_text(system, field)}" for field in message.fields)
            yield "}"


def _field_text(system: System, field: Field) -> str:
    label = f"{field.label} " if field.label else ""
    note = "  // ns" if field.type == DURATION else ""
    return f"{label}{_type_text(system, field)} {field.name} = {field.number};{note}"


def _type_text(system: System, field: Field) -> str:
    if field.type.kind in SCALARS:
        return SCALARS[field.type.kind]
    declared = _declared(system, field)
    if declared.imported or declared.name in _WORDS:
        return "." + full_name(system, declared)
    return declared.name
