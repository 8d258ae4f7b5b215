"""Network: how bad the simulated links between agents are, as `--network`, a project and scenarios say it."""

from __future__ import annotations

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.team.faults import Faults

_UNITS = ((60_000_000_000, "min"), (1_000_000_000, "s"), (1_000_000, "ms"))


@dataclass(frozen=True, slots=True)
class Network:
    """A simulated network. Each transmission takes a random time from `least` to `most` ns, and is lost with
    the probability `loss`.

    `reorder`: a transmission may overtake an earlier one of the same sender to the same receiver. Signals,
    states and agent messages arrive once and in that order nevertheless, only later: what is lost is sent
    again, and what comes too early waits. Data and radio topics have no such order.
    """

    least: int = 0
    most: int = 0
    loss: float = 0.0
    reorder: bool = False

    def faults(self, seed: int) -> Faults:
        """What goes wrong in a run with this seed."""
        return Faults(seed, self.loss, delay=self.most, least_delay=self.least, reorder=self.reorder)

    def __str__(self) -> str:
        """The words: `delay 0..300ms loss 10% reorder`; `delay 0ms` of a perfect network."""
        words = []
        if self.most or not self.loss:
            least = _duration(self.least) if self.least else "0"
            span = f"{least}.." if self.least != self.most else ""
            words.append(f"delay {span}{_duration(self.most)}")
        if self.loss:
            words.append(f"loss {self.loss * 100:g}%")
        return " ".join([*words, *(["reorder"] if self.reorder else [])])


def words_of(faults: Faults | None) -> str | None:
    """The words of the network in what goes wrong; None if its links are perfect."""
    if faults is None or not (faults.delay or faults.loss):
        return None
    return str(Network(faults.least_delay, faults.delay, faults.loss, faults.reorder))


def _duration(time: int) -> str:
    for unit, name in _UNITS:
        if time and not time % unit:
            return f"{time // unit}{name}"
    return f"{time / 1e6:.6f}".rstrip("0").rstrip(".") + "ms"
