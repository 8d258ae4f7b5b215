"""Conditions: what cannot be right in the conditions of choices (W41x, N71x)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem


class BranchesOverlap(Problem):
    """`facts` are a situation in which both hold."""

    code = "W410"
    facts: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"this and an earlier branch can both hold: {', '.join(self.facts)}"

    hint = (
        "let them exclude each other; if their order is meant, write `else` for the last branch, or "
        "`control NAME first { … }`"
    )


class NoBranchHolds(Problem):
    """`facts` are a situation in which none does; none where it is every one."""

    code = "W411"
    facts: tuple[str, ...]

    @property
    def message(self) -> str:
        if not self.facts:
            return "no branch of this choice is enabled"
        return f"no branch of this choice is enabled when {', '.join(self.facts)}"

    hint = "cover it, write `else` for one branch, or end the wait with `after(…)` or an event"


class ConditionNeverHolds(Problem):
    """`others` is how many conditions that lead to it have to hold as well."""

    code = "W412"
    others: int

    @property
    def message(self) -> str:
        if self.others == 0:
            return "this condition can never hold"
        together = "together with the one on the way here" if self.others == 1 else "after what leads here"
        return f"this condition can never hold {together}"

    @property
    def hint(self) -> str:
        if self.others == 0:
            return (
                "what one part of it wants, another excludes: look for `&&` where `||` is meant, or a wrong "
                "limit"
            )
        return "what it wants, the other excludes: ask for one of them in another place, or leave this out"


class MayWaitForEver(Problem):
    """`state` waits, or the beginning of a composite if None; `facts` are values with which it does.

    `of_outcome`: its condition asks how an activity has ended.
    """

    code = "W438"
    state: str | None
    facts: tuple[str, ...]
    of_outcome: bool

    @property
    def message(self) -> str:
        where = "this" if self.state is None else f"`{self.state}`"
        return f"{where} can wait for ever: nothing leads on when {', '.join(self.facts)}"

    @property
    def hint(self) -> str:
        what = "outcome" if self.of_outcome else "case"
        return (
            f"add a line for this {what}, make it a choice (`A | B`, `[A]`), or end the wait with `after(…)`"
        )


class BranchNeverTaken(Problem):
    """`earlier` is how many branches before it are, between them, always open when it is."""

    code = "W412"
    is_else: bool
    has_condition: bool
    earlier: int

    @property
    def message(self) -> str:
        what = "`else`" if self.is_else else "this branch"
        earlier = "an earlier one is" if self.earlier == 1 else "one of the earlier ones is"
        return f"{what} can never be taken: {earlier} open whenever this is"

    @property
    def hint(self) -> str | None:
        return "write the special case before the general one" if self.has_condition else None


class BranchBehindOpenOne(Problem):
    """`first` has the condition `true`."""

    code = "W412"
    branch: str
    first: str

    @property
    def message(self) -> str:
        return f"`{self.branch}` is never taken: `{self.first}` comes first and is always open"

    hint = "say when each is meant, or write `else` for the last branch"


class ConditionsUndecided(Problem):
    code = "N711"
    message = "whether these conditions overlap or leave a gap was too hard to find out"


class ConditionAlwaysHolds(Problem):
    code = "N712"
    message = "this condition always holds when what it reads is there"
    hint = "leave it out, or ask `has(…)` if that is what it is for"


class ChoiceWaitsForMessage(Problem):
    """`facts` are a situation in which no branch is open."""

    code = "N713"
    facts: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"no branch of this choice is enabled while a message has not arrived: {', '.join(self.facts)}"

    hint = "it waits for the message; ask `!has(…)` of it, too, if it should not"


__all__ = [
    "BranchNeverTaken",
    "BranchesOverlap",
    "ChoiceWaitsForMessage",
    "ConditionAlwaysHolds",
    "ConditionNeverHolds",
    "ConditionsUndecided",
    "MayWaitForEver",
    "NoBranchHolds",
]
