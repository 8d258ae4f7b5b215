"""Content: what agent messages say, and what is sent instead of waiting (E577 to E584, W580, N760)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import listed


class ContentIncomplete(Problem):
    """`missing` are the members, those of inner messages by their paths."""

    code = "E577"
    type: str
    missing: tuple[str, ...]

    @property
    def message(self) -> str:
        fields = listed(self.missing)
        return f"the content of `{self.type}` leaves out {fields}"

    hint = "fill every field, or end with `..` to leave the others at their defaults"


class RestOfNoMessage(Problem):
    code = "E578"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is not a message"

    hint = "name a received message after `..`: `propose Bid b from …` / `{ ..b }`"


class RestDoesNotFit(Problem):
    """`lacking` are the members that `name`, a message of the type `source`, does not have so."""

    code = "E578"
    name: str
    source: str
    type: str
    lacking: tuple[str, ...]

    @property
    def message(self) -> str:
        fields = listed(self.lacking)
        return f"`{self.name}` is a `{self.source}`, which does not give {fields} of `{self.type}`"

    hint = "fill these fields before `..`"


class DeadlineInThePast(Problem):
    code = "E579"
    message = "the deadline of the answer is not greater than zero"
    hint = "write how long the receiver has: `reply_by 2s`"


class NothingLeft(Problem):
    code = "N760"
    type: str

    @property
    def message(self) -> str:
        return f"all fields of `{self.type}` are filled: `..` has no effect"

    hint = "remove `..`"


__all__ = ["ContentIncomplete", "DeadlineInThePast", "NothingLeft", "RestDoesNotFit", "RestOfNoMessage"]
