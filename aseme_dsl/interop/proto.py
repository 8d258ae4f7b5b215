"""Protocol Buffers: the messages and enums of an existing .proto file."""

from __future__ import annotations

from dataclasses import dataclass

from aseme_dsl.amola.messages import EnumType, Message, ProtoFile


@dataclass(frozen=True, slots=True)
class ProtoImport:
    """What one `import "x.proto"` gives: types, and the files that are needed on the wire."""

    enums: tuple[EnumType, ...]
    messages: tuple[Message, ...]
    files: tuple[ProtoFile, ...]
