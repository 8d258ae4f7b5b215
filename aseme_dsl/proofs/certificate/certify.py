"""Certify: every statechart of a system against what its source says, and what was left out."""

from __future__ import annotations

from aseme_dsl.amola.system import System
from aseme_dsl.proofs.certificate.agreement import Agreed, Comparison, NotCertified
from aseme_dsl.proofs.certificate.claim import Claims, Process
from aseme_dsl.proofs.certificate.places import Places, Unplaced
from aseme_dsl.proofs.certificate.subcharts import compare_subcharts
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Certificate:
    """What was proved of one statechart (`iac.player`): it is its formula, with its control lines.

    `subcharts` are the participants in it whose states are those of the protocol's own statechart. Of what is
    `left_out` nothing is proved; each entry says why.
    """

    chart: str
    states: int
    transitions: int
    subcharts: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether it was proved, of all of the statechart."""
        return not self.left_out

    @property
    def text(self) -> str:
        """What was proved, in one line: of what is left out, why."""
        return "proved" if self.is_whole else f"left out: {'; '.join(self.left_out)}"


def certify(system: System, claims: Claims) -> tuple[Certificate, ...]:
    """The certificates of all statecharts, protocols first.

    Raises:
        NotCertified: a statechart is not what its source says.
    """
    places: dict[Process, Places] = {}
    found: list[Certificate] = []
    try:
        for chart in system.eacs:
            agreed = Comparison(chart, claims, places).of_protocol(claims.protocols[chart.name])
            found.append(_certificate(f"eac.{chart.name}", agreed))
        for chart in system.iacs:
            role = claims.roles.get(chart.name)
            if role is None:
                reason = "it is written state by state: there is no formula to compare it with"
                found.append(Certificate(f"iac.{chart.name}", 0, 0, left_out=(reason,)))
                continue
            agreed = Comparison(chart, claims, places).of_role(role)
            subcharts = compare_subcharts(system, chart, agreed.branches)
            found.append(_certificate(f"iac.{chart.name}", agreed, subcharts))
    except Unplaced as problem:
        raise NotCertified(f"{problem.line.span}: no formula has the term of this line") from problem
    return tuple(found)


def _certificate(name: str, agreed: Agreed, subcharts: tuple[str, ...] = ()) -> Certificate:
    return Certificate(name, agreed.states, agreed.transitions, subcharts, agreed.left_out)


__all__ = ["Certificate", "NotCertified", "certify"]
