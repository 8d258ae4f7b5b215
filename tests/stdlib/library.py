"""The protocols of the library with who plays them, and what their activities do if all goes well."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from aseme_dsl.amola.aip import Aip
from aseme_dsl.runtime import Context
from tests.support.generated import Generated, generate, system_of

OPENERS = {
    "CloseLease",
    "LearnOutcome",
    "LearnAnswer",
    "EndSubscription",
    "CloseAuction",
    "LearnReply",
    "LearnResult",
}
"""The last activities of those who begin: they know how it ended."""
CLOSERS = {
    "CloseOrder",
    "CloseQuestion",
    "CloseInstruction",
    "CloseJob",
    "CloseSubscription",
    "LeaveAuction",
    "CloseIdea",
    "CloseSearch",
    "CloseErrand",
    "CloseNeed",
}
"""The last activities of the others, which run again if what they were told was not the last word."""


@dataclass(frozen=True)
class Act:
    """What an activity does: it lasts, writes variables, prepares a message, and may break down.

    A value may be a mapping by agent, or a list of which each start takes the next.
    """

    takes: float | Mapping[str, float] = 0.0
    sets: Mapping[str, Any] = field(default_factory=dict)
    says: tuple[str, Mapping[str, Any]] | None = None
    breaks: bool | Mapping[str, bool] = False


def act(takes: Any = 0.0, says: Any = None, breaks: Any = False, **sets: Any) -> Act:
    return Act(takes, sets, says, breaks)


def kind_of(generated: Generated, name: str, what: Act) -> type[Any]:
    starts: dict[str, int] = {}

    class Activity:
        def execute(self, context: Context) -> None:
            number = starts[context.agent] = starts.get(context.agent, -1) + 1

            def of(value: Any) -> Any:
                if isinstance(value, dict):
                    value = value[context.agent]
                return value[min(number, len(value) - 1)] if isinstance(value, list) else value

            takes = of(what.takes)
            if takes:
                context.wait(takes)
            if of(what.breaks):
                raise RuntimeError("the arm is broken")
            for variable, value in what.sets.items():
                context.set_variable(variable, of(value))
            if what.says is not None:
                message, members = what.says
                context.prepare(
                    generated.message(message, **{key: of(value) for key, value in members.items()})
                )
            if name in OPENERS | CLOSERS:
                context.log(f"ended {context.get_variable('ending').name}")

    return Activity


@dataclass(frozen=True)
class Entries:
    """What a role that plays a part says: entries, what stands for the part in its formula, more formulas."""

    entries: str
    term: str
    formulas: str = ""


@dataclass(frozen=True)
class Protocol:
    """A protocol with those who play it, by agent, and what their activities do if all goes well."""

    name: str
    parts: Mapping[str, str]
    acts: Mapping[str, Act]
    library: str = "protocols"
    roles: Mapping[str, Entries] = field(default_factory=dict)
    """What a role says that does not only play its part, by part."""

    def __str__(self) -> str:
        return self.name

    @property
    def first(self) -> str:
        """The first activity of who begins."""
        return next(iter(self.acts))

    def said_of(self, part: str) -> Entries:
        """What a role that plays a part says, besides its own formula."""
        return self.roles.get(part, Entries(f"  plays {self.name}.{part}", part))

    def text(self) -> str:
        roles = dict.fromkeys(self.parts.values())
        lines = [f"system {self.name.title().replace('_', '')}", f"import {self.library}"]
        for part in roles:
            said = self.said_of(part)
            formulas = "  ".join(filter(None, (said.term, said.formulas)))
            liveness = f"  liveness {{ {part}_role = {formulas} }}"
            lines += [f"srm {part}_role {{\n{said.entries}\n{liveness}\n}}"]
        team = " ".join(f"{agent} : {part}_role" for agent, part in self.parts.items())
        return "\n".join([*lines, f"team T {{ {team} }}", ""])


ERRANDS = {
    "PrepareErrand": act(says=("Errand", {"id": "1", "what": "soup", "wanted": "cook"})),
    "AwaitResult": act(),
    "LearnResult": act(),
    "ConsiderErrand": act(0.1, willing=True),
    "ChooseProvider": act(0.1, found=[True, True, False], chosen=["cid", "dan", "dan"]),
    "AwaitProvider": act(),
    "StopSearch": act(),
    "CloseSearch": act(),
    "WeighErrand": act(0.1, able=True),
    "RunErrand": act(3, succeeded=True),
    "ReportResult": act(says=("Outcome", {"id": "1", "detail": "hot"})),
    "DropErrand": act(),
    "CloseErrand": act(),
}
"""What the agents do in brokering and in recruiting."""

PROTOCOLS = (
    Protocol(
        "request",
        {"ann": "initiator", "bob": "responder"},
        {
            "PrepareOrder": act(says=("Order", {"id": "1", "what": "soup"})),
            "AwaitOutcome": act(),
            "LearnOutcome": act(),
            "ConsiderOrder": act(0.1, willing=True),
            "PerformOrder": act(3, succeeded=True),
            "ReportOutcome": act(says=("Outcome", {"id": "1", "detail": "hot"})),
            "StopOrder": act(),
            "CloseOrder": act(),
        },
    ),
    Protocol(
        "query",
        {"ann": "initiator", "bob": "responder"},
        {
            "PrepareQuestion": act(says=("Question", {"id": "1", "about": "the soup"})),
            "AwaitAnswer": act(),
            "LearnAnswer": act(),
            "ConsiderQuestion": act(0.1, willing=True),
            "FindAnswer": act(1, known=True),
            "GiveAnswer": act(says=("Answer", {"id": "1", "holds": True, "value": "hot"})),
            "DropQuestion": act(),
            "CloseQuestion": act(),
        },
    ),
    Protocol(
        "request_when",
        {"ann": "initiator", "bob": "responder"},
        {
            "PrepareInstruction": act(
                says=("Instruction", {"id": "1", "what": "serve", "condition": "it is hot"})
            ),
            "AwaitOutcome": act(),
            "LearnOutcome": act(),
            "ConsiderInstruction": act(0.1, willing=True),
            "AwaitCondition": act(30),
            "PerformInstruction": act(3, succeeded=True),
            "ReportOutcome": act(says=("Outcome", {"id": "1", "detail": "served"})),
            "StopInstruction": act(),
            "CloseInstruction": act(),
        },
    ),
    Protocol(
        "propose",
        {"ann": "initiator", "bob": "responder"},
        {
            "PrepareIdea": act(says=("Idea", {"id": "1", "what": "I cook"})),
            "AwaitReply": act(),
            "LearnReply": act(),
            "ConsiderIdea": act(1, wanted=True),
            "StopIdea": act(),
            "CloseIdea": act(),
        },
    ),
    Protocol(
        "subscribe",
        {"ann": "initiator", "bob": "responder"},
        {
            "PrepareSubscription": act(says=("Interest", {"id": "1", "about": "the soup"})),
            "ReadNews": act(withdrawn=[False, False, True]),
            "AwaitStop": act(),
            "EndSubscription": act(),
            "ConsiderSubscription": act(0.1, willing=True),
            "WatchSource": act(2, says=("News", {"id": "1", "value": ["cold", "warm", "hot"]})),
            "StopService": act(),
            "CloseSubscription": act(),
        },
    ),
    Protocol(
        "contract_net",
        {"ann": "manager", "bob": "contractor", "cid": "contractor", "dan": "contractor"},
        {
            "AnnounceJob": act(says=("Job", {"id": "1", "what": "soup"})),
            "CollectProposals": act(2),
            "AwardContract": act(),
            "AwaitOutcome": act(),
            "LearnOutcome": act(),
            "EvaluateJob": act(
                {"bob": 0.1, "cid": 0.2, "dan": 0.3}, able={"bob": True, "cid": True, "dan": False}
            ),
            "MakeProposal": act(
                says=("Proposal", {"job": "1", "cost": {"bob": 7.0, "cid": 5.0, "dan": 9.0}})
            ),
            "DeclineJob": act(),
            "CarryOut": act(5, succeeded=True),
            "ReportOutcome": act(says=("Outcome", {"id": "1", "detail": "hot"})),
            "StopWork": act(),
            "CloseJob": act(),
        },
    ),
    Protocol(
        "iterated_contract_net",
        {"ann": "manager", "bob": "contractor", "cid": "contractor", "dan": "contractor"},
        {
            "AnnounceJob": act(says=("Job", {"id": "1", "what": "soup"})),
            "CollectProposals": act(2),
            "DecideRound": act(again=[True, False], says=("Job", {"id": "1", "what": "cheaper"})),
            "AwaitOutcome": act(),
            "LearnOutcome": act(),
            "EvaluateJob": act(
                {"bob": 0.1, "cid": 0.2, "dan": 0.3}, able={"bob": True, "cid": True, "dan": False}
            ),
            "MakeProposal": act(
                says=("Proposal", {"job": "1", "cost": {"bob": [7.0, 4.0], "cid": [5.0, 4.5], "dan": 9.0}})
            ),
            "CarryOut": act(5, succeeded=True),
            "ReportOutcome": act(says=("Outcome", {"id": "1", "detail": "hot"})),
            "StopWork": act(),
            "CloseJob": act(),
        },
    ),
    Protocol(
        "auction",
        {"ann": "auctioneer", "bob": "bidder", "cid": "bidder"},
        {
            "OpenAuction": act(lot="a clock", price=10.0, step=5.0, reserve=12.0),
            "CallPrice": act(0.1),
            "CollectOffers": act(2),
            "AwaitPayment": act(),
            "CloseAuction": act(),
            "ConsiderLot": act(),
            "DecideOffer": act(
                {"bob": 0.1, "cid": 0.2},
                interested={"bob": [True, True, False], "cid": [True, True, True, False]},
            ),
            "Pay": act(1, solvent=True),
            "LeaveAuction": act(),
        },
    ),
    Protocol(
        "dutch_auction",
        {"ann": "auctioneer", "bob": "bidder", "cid": "bidder"},
        {
            "OpenAuction": act(lot="fish", price=10.0, step=2.0, reserve=5.0),
            "CallPrice": act(0.1),
            "CollectOffers": act(2),
            "AwaitPayment": act(),
            "CloseAuction": act(),
            "ConsiderLot": act(),
            "DecideOffer": act(
                {"bob": 0.1, "cid": 0.2}, interested={"bob": [False, True], "cid": [False, False, True]}
            ),
            "Pay": act(1, solvent=True),
            "LeaveAuction": act(),
        },
    ),
    Protocol(
        "brokering",
        {"ann": "client", "bob": "broker", "cid": "provider", "dan": "provider"},
        ERRANDS,
    ),
    Protocol(
        "recruiting",
        {"ann": "client", "bob": "recruiter", "cid": "provider", "dan": "provider"},
        ERRANDS,
    ),
    Protocol(
        "resource",
        {"ann": "holder", "bob": "keeper"},
        {
            "ExpressNeed": act(),
            "AwaitTurn": act(),
            "UseResource": act(3),
            "CloseLease": act(),
            "OpenDesk": act(),
            "ConsiderNeed": act(0.1),
            "KeepInLine": act(),
            "Lend": act(),
            "CloseNeed": act(),
        },
        "resources",
        {
            "holder": Entries(
                """  plays resource.holder with whom = "", what = "the lift", urgency = 0, lease = 10s,
                             patience = 1min, renewing = renewed
  var renewed : bool = false
  activities { ExpressNeed writes renewed }""",
                "holder",
            ),
            "keeper": Entries("  includes resource_keeper", "service", "places = keeper"),
        },
    ),
)


def protocol(name: str) -> Protocol:
    return next(item for item in PROTOCOLS if item.name == name)


@cache
def of_the_library() -> tuple[Aip, ...]:
    """Every protocol that a file of the library has, whether these tests know it or not."""
    folder = Path(__file__).parents[2] / "stdlib"
    names = sorted(file.stem for file in folder.glob("*.aseme"))
    text = "\n".join(["system Library", *(f"import {name}" for name in names), ""])
    return system_of(text).aips


@cache
def generated(name: str) -> Generated:
    return generate(protocol(name).text())


def disagreement(item: Protocol, said: Mapping[str, str]) -> str:
    """What is wrong between how agents say that their parts have ended; nothing if they agree.

    Who has had no last word (UNKNOWN), is lost or has lost the other knows nothing of how it has ended. A
    recruiter that is DONE has found somebody; of several contractors some may fail.
    """
    first = next(iter(item.parts))
    mine = said.get(first, "")
    others = {
        ending for agent, ending in said.items() if agent != first and item.parts.get(agent) != "recruiter"
    }
    if item.name == "resource":
        allowed = {
            "RETURNED": {"RETURNED"},
            "REFUSED": {"REFUSED"},
            "WITHDRAWN": {"WITHDRAWN", "NOT_TAKEN", "LOST"},
            "EXPIRED": {"RETURNED", "EXPIRED", "NOT_TAKEN", "LOST"},
        }
        wrong = others - allowed.get(mine, others)
        return f"{mine}, but {', '.join(sorted(wrong))}" if wrong else ""
    if item.name == "brokering" and mine == "DONE":  # the broker may have asked another provider before
        others = {said.get("bob", "")}
    match mine:
        case "" | "UNKNOWN" | "LOST":
            return ""
        case "DONE":
            wrong = not others & {"DONE", "UNCONFIRMED"} or "LATE" in others
        case "LATE":
            wrong = not others & {"LATE", "UNCONFIRMED"}
        case "FAILED" if item.name == "contract_net":
            return ""
        case _:
            wrong = bool(others & {"DONE", "LATE", "UNCONFIRMED"})
    return f"{mine}, but {', '.join(sorted(others)) or 'nothing'}" if wrong else ""
