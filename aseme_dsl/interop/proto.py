"""Protocol Buffers: the messages and enums of an existing .proto file, read by the real protoc."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field, replace
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.amola.messages import (
    BOOL,
    BYTES,
    DOUBLE,
    INT,
    STRING,
    EnumType,
    Field,
    Kind,
    Message,
    ProtoFile,
    Type,
)
from aseme_dsl.amola.python_names import free_name, taken_as_constant, taken_as_member, taken_as_type
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.files import GrpcToolsMissing, ProtocSays, ProtoNotRead
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from google.protobuf.descriptor import Descriptor, EnumDescriptor, FieldDescriptor
    from google.protobuf.descriptor_pb2 import FileDescriptorProto

TIME_LIMIT = 60.0
"""Seconds that protoc may take (it takes hundredths of one)."""

_IMPORT = re.compile(r'^\s*import\s+(?:public\s+|weak\s+)?"([^"]+)"', re.MULTILINE)
_PROBLEM = re.compile(r"^(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): (?P<text>.*)$")
_NOISE = re.compile(r"WARNING: All log messages|[IWEF]\d{4} |.*: File not found\.$")
"""Log lines, and what protoc says again at the place of the import."""
_WELL_KNOWN = "google/protobuf/"
_INT_TYPES = "INT32 INT64 UINT32 UINT64 SINT32 SINT64 FIXED32 FIXED64 SFIXED32 SFIXED64".split()


@dataclass(frozen=True, slots=True)
class ProtoImport:
    """What one `import "x.proto"` gives: types, and the files that are needed on the wire.

    Types are called by their full names with underscores (`moveit_Pose`) until `join` gives them the names
    that a document uses. A member that cannot be an attribute in Python (`from`) has an underscore behind its
    name. Members that conditions cannot use are kept all the same. They are repeated members, maps (repeated
    entries with `key` and `value`), members of a `oneof`, and `optional` members, absent until they are set.
    """

    name: str
    enums: tuple[EnumType, ...]
    messages: tuple[Message, ...]
    files: tuple[ProtoFile, ...]
    short: Mapping[str, str]
    """The name without its package of each type (`Pose`, `Outer_Inner`), by its full name."""
    at: Span


def join(
    imports: Sequence[ProtoImport], own: Collection[str]
) -> tuple[tuple[EnumType, ...], tuple[Message, ...], tuple[ProtoFile, ...]]:
    """All types and files of several imports, each once, under the names that a document uses.

    That is the name without its package. Two imported types that would have the same name keep their full
    names. So does a type with a name of `own` (the document's types) if only another imported file imports
    its file.
    """
    direct = {item.name for item in imports}
    enums = {item.name: item for one in imports for item in one.enums}
    messages = {item.name: item for one in imports for item in one.messages}
    files = {item.name: item for one in imports for item in one.files}
    short = {name: text for one in imports for name, text in one.short.items()}
    counted = Counter(short.values())
    names = {}
    for full, item in (enums | messages).items():
        hidden = short[full] in own and item.imported not in direct
        names[full] = full if counted[short[full]] > 1 or hidden else short[full]

    def renamed(kind: Type) -> Type:
        return replace(kind, name=names[kind.name]) if kind.name else kind

    return (
        tuple(replace(item, name=names[item.name]) for item in enums.values()),
        tuple(
            replace(
                item,
                name=names[item.name],
                fields=tuple(replace(member, type=renamed(member.type)) for member in item.fields),
            )
            for item in messages.values()
        ),
        tuple(files.values()),
    )


def read_proto(
    source: Source, path: Path, buffers: Mapping[Path, str], at: Span
) -> tuple[ProtoImport | None, tuple[Diagnostic, ...]]:
    """Read the .proto file `source`, which is (or would be) at `path`, and what it imports.

    `buffers` are texts that count instead of the files at their paths. `at` is the import that asks for it.
    Imports inside are looked for from the file's folder, or from the nearest folder above it from which all
    of them are found. Needs the extra `proto` (grpcio-tools): without it, that is the diagnostic (E007).
    """
    import tempfile

    if find_spec("grpc_tools") is None:
        return None, (Diagnostic(GrpcToolsMissing(source.path), at),)
    root = _root(source, path, buffers)
    name = path.relative_to(root).as_posix()
    texts = {
        place.relative_to(root).as_posix(): text
        for place, text in buffers.items()
        if place.suffix == ".proto" and place.is_relative_to(root)
    }
    texts[name] = source.text
    with tempfile.TemporaryDirectory(prefix="aseme-proto-") as folder:
        content, problems = _protoc(Path(folder), root, name, texts)
    if content is None:
        return None, _diagnostics(problems, source, name, at)
    return _imported(content, source, root, name, texts, at), ()


def is_current(known: ProtoImport, source: Source, path: Path, buffers: Mapping[Path, str]) -> bool:
    """Whether `read_proto` would give the same again: whether no text that it came from has changed."""
    root = _root(source, path, buffers)
    if path.relative_to(root).as_posix() != known.name:
        return False
    for file in known.files:
        if not file.name.startswith(_WELL_KNOWN):
            place = root / file.name
            now = source.text if file.name == known.name else buffers.get(place)
            if file.text != (_read(place) if now is None else now):
                return False
    return True


def _read(path: Path) -> str:
    try:
        return outside.read_text(path, encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return ""


def files_behind(path: Path) -> set[Path]:
    """The files that a .proto file imports, and those that these do, as far as they are there."""
    found: set[Path] = set()
    waiting = [path]
    while waiting:
        importer = waiting.pop()
        for item in _IMPORT.findall(_read(importer)):
            places = (folder / item for folder in path.parents)
            place = next((other for other in places if outside.is_file(other)), path.parent / item)
            if not item.startswith(_WELL_KNOWN) and place not in found:
                found.add(place)
                waiting.append(place)
    return found


def _root(source: Source, path: Path, buffers: Mapping[Path, str]) -> Path:
    """The folder from which the file's imports are found, as protoc's `-I` would say."""
    wanted = [item for item in _IMPORT.findall(source.text) if not item.startswith(_WELL_KNOWN)]
    for folder in path.parents:
        if all((folder / item) in buffers or outside.is_file(folder / item) for item in wanted):
            return folder
    return path.parent


def _protoc(
    folder: Path, root: Path, name: str, texts: Mapping[str, str]
) -> tuple[bytes | None, tuple[str, ...]]:
    """The serialized FileDescriptorSet, or what protoc says is wrong."""
    import subprocess

    for other, text in texts.items():
        place = folder / "in" / other
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8", newline="")
    output = folder / "descriptors"
    command = [sys.executable, "-m", "grpc_tools.protoc", f"-I{folder / 'in'}", f"-I{root}"]
    command += ["--include_imports", "--include_source_info", f"--descriptor_set_out={output}", name]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=TIME_LIMIT, stdin=subprocess.DEVNULL, cwd=folder
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        return None, (f"protoc could not be run: {problem}",)
    if done.returncode == 0 and output.is_file():
        return outside.read_bytes(output), ()
    said = (line.replace(f"{folder / 'in'}/", "") for line in done.stderr.splitlines())
    lines = tuple(line for line in said if line.strip() and not _NOISE.match(line))
    return None, lines or (f"protoc ended with code {done.returncode}: {done.stderr.strip()}",)


def _diagnostics(problems: tuple[str, ...], source: Source, name: str, at: Span) -> tuple[Diagnostic, ...]:
    """protoc's messages, each at its place if it is in the imported file itself."""
    found = []
    for problem in problems:
        match = _PROBLEM.match(problem)
        if match is None or match["file"] != name:
            found.append(Diagnostic(ProtoNotRead(source.path, problem), at))
            continue
        related = (Related(at, "it is imported here"),)
        span = _word(source, int(match["line"]), int(match["column"]))
        found.append(Diagnostic(ProtocSays(match["text"]), span, related))
    return tuple(found)


def _word(source: Source, line: int, column: int) -> Span:
    """The word at a place that protoc names; its columns count bytes and tabs of eight."""
    starts = _line_starts(source.text)
    line = min(line, len(starts))
    text = source.line(line)
    start, at = 0, 1
    while start < len(text) and at < column:
        at = (at - 1) // 8 * 8 + 9 if text[start] == "\t" else at + len(text[start].encode())
        start += 1
    found = re.compile(r"\w+|\S|$").search(text, start)
    begin, end = found.span() if found else (start, start)
    return Span(source, starts[line - 1] + begin, starts[line - 1] + end)


def _line_starts(text: str) -> list[int]:
    return [0, *(match.end() for match in re.finditer("\n", text))]


# ---- from descriptors to types -----------------------------------------------------------------


@dataclass(slots=True)
class _File:
    """A file of the set while it is read: where its types' names are in its text."""

    proto: FileDescriptorProto
    source: Source
    lines: Mapping[tuple[int, ...], int]
    starts: list[int] = field(init=False)

    def __post_init__(self) -> None:
        self.starts = _line_starts(self.source.text)

    def span(self, path: tuple[int, ...], name: str) -> Span:
        """The name of what `path` (numbers of descriptor fields) leads to."""
        line = self.lines.get((*path, 1), self.lines.get(path, 0))
        if line >= len(self.starts):
            return Span(self.source, 0, 0)
        offset = self.starts[line]
        found = re.search(rf"\b{re.escape(name)}\b", self.source.line(line + 1))
        if found is None:
            return Span(self.source, offset, offset)
        return Span(self.source, offset + found.start(), offset + found.end())


def _imported(
    content: bytes, source: Source, root: Path, name: str, texts: Mapping[str, str], at: Span
) -> ProtoImport:
    from google.protobuf import descriptor_pb2, descriptor_pool

    pool = descriptor_pool.DescriptorPool()
    files: list[ProtoFile] = []
    opened: list[_File] = []
    for proto in descriptor_pb2.FileDescriptorSet.FromString(content).file:
        lines = {tuple(place.path): place.span[0] for place in proto.source_code_info.location}
        proto.ClearField("source_code_info")
        text = "" if proto.name.startswith(_WELL_KNOWN) else _text(root, proto.name, texts)
        files.append(ProtoFile(proto.name, proto.SerializeToString(deterministic=True), text))
        shown = source if proto.name == name else Source(proto.name, text)
        opened.append(_File(proto, shown, lines))
        pool.Add(proto)
    enums: list[EnumType] = []
    messages: list[Message] = []
    short: dict[str, str] = {}
    for file in opened:
        descriptor = pool.FindFileByName(file.proto.name)
        package = len(descriptor.package) + 1 if descriptor.package else 0
        if file.proto.name.startswith(_WELL_KNOWN):
            package = 0  # google_protobuf_Timestamp: a Timestamp is more likely to be the document's own
        own_enums: list[tuple[EnumDescriptor, tuple[int, ...]]] = [
            (descriptor.enum_types_by_name[enum.name], (5, index))
            for index, enum in enumerate(file.proto.enum_type)
        ]
        for index, top in enumerate(file.proto.message_type):
            for message, path in _nested(descriptor.message_types_by_name[top.name], (4, index)):
                messages.append(_message(message, file, path))
                short[messages[-1].name] = _free_type(message.full_name[package:])
                own_enums += [(enum, (*path, 4, place)) for place, enum in enumerate(message.enum_types)]
        for enum_type, path in own_enums:
            enums.append(_enum(enum_type, file, path))
            short[enums[-1].name] = _free_type(enum_type.full_name[package:])
    return ProtoImport(name, tuple(enums), _without_circles(messages), tuple(files), short, at)


def _text(root: Path, name: str, texts: Mapping[str, str]) -> str:
    return texts[name] if name in texts else _read(root / name)


def _nested(message: Descriptor, path: tuple[int, ...]) -> Iterator[tuple[Descriptor, tuple[int, ...]]]:
    """A message and all messages inside it, each with its place in the descriptor."""
    stack = [(message, path)]
    while stack:
        item, place = stack.pop()
        yield item, place
        inner = list(item.nested_types)
        stack.extend((other, (*place, 3, index)) for index, other in reversed(list(enumerate(inner))))


def _free_type(full_name: str) -> str:
    name = full_name.replace(".", "_")
    return free_name(name, set()) if taken_as_type(name) else name


def _enum(descriptor: EnumDescriptor, file: _File, path: tuple[int, ...]) -> EnumType:
    taken = {value.name for value in descriptor.values}
    constants = tuple(
        (free_name(value.name, taken) if taken_as_constant(value.name) else value.name, value.number)
        for value in descriptor.values
    )
    span = file.span(path, descriptor.name)
    return EnumType(_free_type(descriptor.full_name), constants, span, file.proto.name, descriptor.full_name)


def _message(descriptor: Descriptor, file: _File, path: tuple[int, ...]) -> Message:
    taken = {item.name for item in descriptor.fields}
    fields = []
    for index, item in enumerate(descriptor.fields):
        span = file.span((*path, 2, index), item.name)
        fields.append(Field(_member_name(item, taken), _field_type(item), item.number, _label(item), span))
    name = _free_type(descriptor.full_name)
    span = file.span(path, descriptor.name)
    return Message(name, tuple(fields), span, file.proto.name, descriptor.full_name)


def _member_name(item: FieldDescriptor, taken: set[str]) -> str:
    """Its own name, unless generated Python cannot have an attribute of that name."""
    kind = item.message_type or item.enum_type
    if not taken_as_member(item.name) and (kind is None or kind.name != item.name):
        return item.name
    name = free_name(item.name, taken)
    taken.add(name)
    return name


def _field_type(item: FieldDescriptor) -> Type:
    simple = {item.TYPE_BOOL: BOOL, item.TYPE_STRING: STRING, item.TYPE_BYTES: BYTES}
    simple |= {item.TYPE_DOUBLE: DOUBLE, item.TYPE_FLOAT: DOUBLE}
    simple |= {getattr(item, f"TYPE_{name}"): INT for name in _INT_TYPES}
    if item.type in simple:
        return simple[item.type]
    if item.enum_type is not None:
        return Type(Kind.ENUM, _free_type(item.enum_type.full_name))
    assert item.message_type is not None
    return Type(Kind.MESSAGE, _free_type(item.message_type.full_name))


def _label(item: FieldDescriptor) -> str:
    if item.is_repeated:
        return "repeated"
    if item.containing_oneof is not None:
        return "optional"
    if item.message_type is None and item.has_presence and not item.is_required:
        return "optional"
    return ""


def _without_circles(messages: list[Message]) -> tuple[Message, ...]:
    """A message that contains itself ends somewhere: the member that closes the circle may be absent."""
    by_name = {message.name: message for message in messages}
    state: dict[str, int] = {}  # 1: around the one that is looked at, 2: done
    closing: set[tuple[str, str]] = set()
    for message in messages:
        if message.name in state:
            continue
        state[message.name] = 1
        stack = [(message, iter(message.fields))]
        while stack:
            owner, rest = stack[-1]
            for item in rest:
                if item.label or item.type.kind is not Kind.MESSAGE:
                    continue
                seen = state.get(item.type.name)
                if seen == 1:
                    closing.add((owner.name, item.name))
                elif seen is None:
                    state[item.type.name] = 1
                    inner = by_name[item.type.name]
                    stack.append((inner, iter(inner.fields)))
                    break
            else:
                state[owner.name] = 2
                stack.pop()
    return tuple(
        replace(
            message,
            fields=tuple(
                replace(item, label="optional") if (message.name, item.name) in closing else item
                for item in message.fields
            ),
        )
        for message in messages
    )
