"""Codec: messages of one version of the model as bytes, and back."""

from __future__ import annotations

from functools import cached_property

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.contract import Contract, Reading, reading
from aseme_dsl.runtime.message.convert import converted
from aseme_dsl.runtime.message.free import Text
from aseme_dsl.runtime.message.wire import Schema, WireError


@dataclass(frozen=True)
class Codec:
    """How the messages of a version of the model travel."""

    schema: Schema
    contract: Contract
    readable: bool
    """Whether they travel as JSON."""
    largest: int | None

    def encode(self, message: object) -> bytes:
        """The payload of a message. Raises WireError.

        While a team changes its version, messages of the other one may come: they are converted.
        """
        if isinstance(message, Text):
            payload = _utf_8(message.text)
        else:
            if type(message).__name__ in self.kinds:
                message = converted(message, self.kinds)
            payload = self.schema.encode_json(message) if self.readable else self.schema.encode(message)
        if self.largest is not None and len(payload) > self.largest:
            raise WireError(f"it has {len(payload)} bytes, and at the most {self.largest} travel here")
        return payload

    @cached_property
    def number(self) -> int:
        """The number of the contract."""
        return self.contract.number

    @cached_property
    def kinds(self) -> dict[str, type[object]]:
        """The class of each message by its name; the empty name is a text."""
        return {"": Text, **{kind.__name__: kind for kind in self.schema.classes}}

    def reading(self, contract: Contract) -> Reading:
        """How messages are read that were sent under a contract."""
        return reading(self.contract, contract)

    def read(self, kind: type[object], payload: bytes, other: Reading | None = None) -> object:
        """The message that a payload is, of this build or of an `other` one. Raises WireError."""
        if kind is Text:
            try:
                return Text(payload.decode())
            except UnicodeDecodeError as problem:
                raise WireError(f"{len(payload)} bytes are not a text in UTF-8: {problem}") from None
        if self.readable:
            return self.schema.decode_json(kind, payload, known=other is None)
        return self.schema.decode(kind, payload, other.zeros if other is not None else frozenset())


def _utf_8(text: str) -> bytes:
    """A text as bytes. Raises WireError for one with half a character."""
    try:
        return text.encode()
    except UnicodeEncodeError as problem:
        raise WireError(f"the text cannot be encoded: {problem}") from None
