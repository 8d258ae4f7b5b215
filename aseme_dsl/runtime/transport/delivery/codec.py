"""Codec: messages of one version of the model as bytes, and back."""

from __future__ import annotations

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.free import Text
from aseme_dsl.runtime.message.wire import Schema, WireError


@dataclass(frozen=True, slots=True)
class Codec:
    """How the messages of a version of the model travel."""

    schema: Schema
    model: str
    """The MODEL of the generated package; messages of another one are refused."""
    readable: bool
    """Whether they travel as JSON."""
    largest: int | None

    def encode(self, message: object) -> bytes:
        """The payload of a message. Raises WireError."""
        if isinstance(message, Text):
            payload = _utf_8(message.text)
        else:
            payload = self.schema.encode_json(message) if self.readable else self.schema.encode(message)
        if self.largest is not None and len(payload) > self.largest:
            raise WireError(f"it has {len(payload)} bytes, and at the most {self.largest} travel here")
        return payload

    def read(self, kind: type[object], payload: bytes) -> object:
        """The message that a payload is. Raises WireError."""
        if kind is Text:
            try:
                return Text(payload.decode())
            except UnicodeDecodeError as problem:
                raise WireError(f"{len(payload)} bytes are not a text in UTF-8: {problem}") from None
        if self.readable:
            return self.schema.decode_json(kind, payload)
        return self.schema.decode(kind, payload)


def _utf_8(text: str) -> bytes:
    """A text as bytes. Raises WireError for one with half a character."""
    try:
        return text.encode()
    except UnicodeEncodeError as problem:
        raise WireError(f"the text cannot be encoded: {problem}") from None
