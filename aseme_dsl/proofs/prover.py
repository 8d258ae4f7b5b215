"""Prover: z3, where it is installed, for the conditions of one system."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from aseme_dsl.amola import expression as e
from aseme_dsl.proofs.unknowns import Vocabulary

if TYPE_CHECKING:
    from aseme_dsl.proofs.solver import Snapshot


class Prover:
    """Asks z3 about conditions. z3 is loaded with the first question, and nothing is kept between runs."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.vocabulary = vocabulary

    @cached_property
    def is_there(self) -> bool:
        """Whether z3 is installed and can be loaded."""
        try:
            import z3  # noqa: F401
        except Exception:  # a broken installation raises what it likes
            return False
        return True

    @cached_property
    def _context(self) -> Any:
        import z3

        return z3.Context()

    def snapshot(self, conditions: Sequence[e.Value], facts: Sequence[e.Value] = ()) -> Snapshot:
        """What these conditions see at a moment, in which the facts hold. Raises ImportError without z3."""
        from aseme_dsl.proofs.solver import Snapshot

        return Snapshot(conditions, self.vocabulary, self._context, facts)

    def is_possible(self, holding: Sequence[e.Value], failing: Sequence[e.Value]) -> bool:
        """Whether the first conditions can hold in one snapshot in which none of the second does.

        Raises Undecided, and ImportError without z3.
        """
        from aseme_dsl.proofs.solver import Claim

        claim = Claim(tuple(holding), tuple((condition,) for condition in failing))
        return self.snapshot(claim.conditions).is_possible(claim)


__all__ = ["Prover"]
