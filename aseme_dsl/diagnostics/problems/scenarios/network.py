"""Simulated networks: their words, and runs that cannot have one (E036, E037, N770)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean

NETWORK_WORDS = ("delay", "loss", "reorder")
_EXAMPLE = "write for example `delay=0..300ms,loss=10%,reorder`"

# ---- E036: the words ---------------------------------------------------------------------------


class NoNetworkWords(Problem):
    code = "E036"
    message = "a network is described by `delay`, `loss` and `reorder`"
    hint = _EXAMPLE


class UnknownNetworkWord(Problem):
    """`close`: the one that is spelt alike."""

    code = "E036"
    word: str
    close: str | None

    @property
    def message(self) -> str:
        return f"`{self.word}` does not describe a network"

    @property
    def hint(self) -> str:
        return did_you_mean(self.close) if self.close else _EXAMPLE


class NetworkWordTwice(Problem):
    code = "E036"
    word: str
    hint = "remove one of them"

    @property
    def message(self) -> str:
        return f"`{self.word}` is given twice"


class WrongDelay(Problem):
    """`value`: None if there is none."""

    code = "E036"
    value: str | None
    hint = "write a duration of at most 24 hours, or a range, such as `delay=50ms` or `delay=0..300ms`"

    @property
    def message(self) -> str:
        return "`delay` has no value" if self.value is None else f"`{self.value}` is not a delay"


class DelayReversed(Problem):
    code = "E036"
    least: str
    most: str

    @property
    def message(self) -> str:
        return f"the range of delays `{self.least}..{self.most}` is empty"

    @property
    def hint(self) -> str:
        return "write the shorter delay first"


class WrongLoss(Problem):
    """`value`: None if there is none."""

    code = "E036"
    value: str | None
    hint = "write a percentage from 0 to less than 100, such as `loss=10%`"

    @property
    def message(self) -> str:
        return "`loss` has no value" if self.value is None else f"`{self.value}` is not a loss"


class ValueOfReorder(Problem):
    code = "E036"
    value: str
    hint = "remove the value"

    @property
    def message(self) -> str:
        return f"`reorder` takes no value, but has `{self.value}`"


class ReorderWithoutRange(Problem):
    code = "E036"
    message = "`reorder` has no effect without a range of delays"
    hint = "add a range, such as `delay=0..300ms`, or remove `reorder`"


# ---- E037, N770: in real time ------------------------------------------------------------------


class NetworkInRealTime(Problem):
    """`option`: what asks for real time."""

    code = "E037"
    option: str
    hint = "remove `--network`: in real time, the links are those of the transport"

    @property
    def message(self) -> str:
        return f"`--network` simulates a network in virtual time, not with `{self.option}`"


class NetworkNotSimulated(Problem):
    """`words`: what the project says."""

    code = "N770"
    words: str
    hint = "run in virtual time to simulate it"

    @property
    def message(self) -> str:
        return f"the network `{self.words}` of the project is not simulated in real time"
