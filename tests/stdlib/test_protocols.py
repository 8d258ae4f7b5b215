"""Every protocol of the library, through each of its ends: what is said, to whom, and how it ended."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.diagrams.sequence.sequence_svg import drawn
from aseme_dsl.project.playing.sniff import Sniffer
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.diagrams.overlaps import overlaps
from tests.runtime.playing import SECOND, Played, play
from tests.stdlib.hostile import endings
from tests.stdlib.library import PROTOCOLS, Act, Protocol, act, disagreement, generated, kind_of, protocol
from tests.support.generated import analysis_of, generate

PICTURES = Path(__file__).parents[2] / "docs" / "pictures"
LIMIT = 2 * 3600 * SECOND
"""No conversation of these is longer, whatever happens."""


@dataclass(frozen=True)
class End:
    """One end of a protocol: what goes otherwise, and how it has ended then."""

    protocol: str
    name: str
    ends: str
    acts: Mapping[str, Act] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.protocol}: {self.name}"


NEVER = act(3600)
"""So long that nobody waits for it."""

ENDS = (
    End("request", "done", "DONE"),
    End(
        "request",
        "asked by name",
        "DONE",
        {"PrepareOrder": act(asked="bob", says=("Order", {"id": "1", "what": "soup"}))},
    ),
    End("request", "refused", "REFUSED", {"ConsiderOrder": act(willing=False)}),
    End("request", "failed", "FAILED", {"PerformOrder": act(succeeded=False)}),
    End("request", "no answer", "TIMED_OUT", {"ConsiderOrder": NEVER}),
    End("request", "no outcome", "TIMED_OUT", {"PerformOrder": NEVER}),
    End("request", "taken back", "CANCELLED", {"AwaitOutcome": act(1, withdrawn=True)}),
    End(
        "request",
        "cannot be stopped",
        "FAILED",
        {"AwaitOutcome": act(1, withdrawn=True), "StopOrder": act(stopped=False)},
    ),
    End("request", "the other is lost", "LOST", {"PerformOrder": act(breaks=True)}),
    End("request", "the one who asked is lost", "", {"AwaitOutcome": act(1, breaks=True)}),
    End("request_when", "done", "DONE"),
    End("request_when", "refused", "REFUSED", {"ConsiderInstruction": act(willing=False)}),
    End("request_when", "the condition never holds", "FAILED", {"AwaitCondition": act(5, hopeless=True)}),
    End("request_when", "failed", "FAILED", {"PerformInstruction": act(succeeded=False)}),
    End("request_when", "no answer", "TIMED_OUT", {"ConsiderInstruction": NEVER}),
    End("request_when", "no outcome", "TIMED_OUT", {"AwaitCondition": act(2 * 3600)}),
    End("request_when", "taken back", "CANCELLED", {"AwaitOutcome": act(1, withdrawn=True)}),
    End("request_when", "the other is lost", "LOST", {"PerformInstruction": act(breaks=True)}),
    End("request_when", "the one who asked is lost", "", {"AwaitOutcome": act(1, breaks=True)}),
    End("query", "done", "DONE"),
    End(
        "query",
        "whether it is so",
        "DONE",
        {"PrepareQuestion": act(yes_or_no=True, says=("Question", {"id": "1"}))},
    ),
    End("query", "refused", "REFUSED", {"ConsiderQuestion": act(willing=False)}),
    End("query", "nobody knows", "FAILED", {"FindAnswer": act(known=False)}),
    End("query", "no answer", "TIMED_OUT", {"ConsiderQuestion": NEVER}),
    End("query", "taken back", "CANCELLED", {"FindAnswer": NEVER, "AwaitAnswer": act(1, withdrawn=True)}),
    End("query", "the other is lost", "LOST", {"FindAnswer": act(breaks=True)}),
    End("query", "the one who asked is lost", "", {"FindAnswer": NEVER, "AwaitAnswer": act(1, breaks=True)}),
    End("propose", "accepted", "DONE"),
    End("propose", "rejected", "REFUSED", {"ConsiderIdea": act(wanted=False)}),
    End("propose", "no answer", "TIMED_OUT", {"ConsiderIdea": NEVER}),
    End("propose", "taken back", "CANCELLED", {"AwaitReply": act(0.5, withdrawn=True)}),
    End("propose", "the other is lost", "LOST", {"ConsiderIdea": act(breaks=True)}),
    End(
        "propose",
        "the one who offered is lost",
        "",
        {"ConsiderIdea": NEVER, "AwaitReply": act(1, breaks=True)},
    ),
    End("subscribe", "enough", "CANCELLED"),
    End("subscribe", "refused", "REFUSED", {"ConsiderSubscription": act(willing=False)}),
    End(
        "subscribe",
        "the source fails",
        "FAILED",
        {"WatchSource": act(2, broken=[False, True], says=("News", {"value": "cold"}))},
    ),
    End("subscribe", "no answer", "TIMED_OUT", {"ConsiderSubscription": NEVER}),
    End("subscribe", "the other is lost", "LOST", {"WatchSource": act(2, breaks=True)}),
    End("subscribe", "the one who listens is lost", "", {"ReadNews": act(1, breaks=True)}),
    End("contract_net", "done", "DONE"),
    End("contract_net", "nobody can", "REFUSED", {"EvaluateJob": act(able=False)}),
    End("contract_net", "nobody answers in time", "NOBODY", {"EvaluateJob": act(5, able=True)}),
    End("contract_net", "failed", "FAILED", {"CarryOut": act(succeeded=False)}),
    End("contract_net", "no outcome", "TIMED_OUT", {"CarryOut": NEVER}),
    End("contract_net", "taken back", "CANCELLED", {"AwaitOutcome": act(1, withdrawn=True)}),
    End("contract_net", "the contractor is lost", "LOST", {"CarryOut": act(breaks=True)}),
    End("contract_net", "the manager is lost", "", {"AwaitOutcome": act(1, breaks=True)}),
    End(
        "contract_net",
        "a late proposal",
        "DONE",
        {
            "EvaluateJob": act(
                {"bob": 0.1, "cid": 3, "dan": 0.1}, able={"bob": True, "cid": True, "dan": False}
            )
        },
    ),
    End("contract_net", "two winners", "DONE", {"AnnounceJob": act(wanted=2, says=("Job", {"id": "1"}))}),
    End(
        "contract_net",
        "nobody is wanted",
        "NOBODY",
        {"AnnounceJob": act(wanted=0, says=("Job", {"id": "1"}))},
    ),
    End(
        "contract_net",
        "one of two winners fails",
        "FAILED",
        {
            "AnnounceJob": act(wanted=2, says=("Job", {"id": "1"})),
            "CarryOut": act(5, succeeded={"bob": True, "cid": False}),
        },
    ),
    End(
        "contract_net", "taken back before the award", "CANCELLED", {"CollectProposals": act(withdrawn=True)}
    ),
    End(
        "contract_net",
        "taken back at the award",
        "CANCELLED",
        {"AwardContract": act(withdrawn=True)},
    ),
    End(
        "contract_net",
        "one does not answer",
        "DONE",
        {"EvaluateJob": act({"bob": 0.1, "cid": 0.2, "dan": 3600}, able=True)},
    ),
    End("iterated_contract_net", "done", "DONE"),
    End(
        "iterated_contract_net",
        "one does not answer",
        "DONE",
        {"EvaluateJob": act({"bob": 0.1, "cid": 0.2, "dan": 3600}, able=True)},
    ),
    End("iterated_contract_net", "nobody can", "REFUSED", {"EvaluateJob": act(able=False)}),
    End("iterated_contract_net", "failed", "FAILED", {"CarryOut": act(succeeded=False)}),
    End("iterated_contract_net", "no outcome", "TIMED_OUT", {"CarryOut": NEVER}),
    End("iterated_contract_net", "taken back", "CANCELLED", {"AwaitOutcome": act(1, withdrawn=True)}),
    End("iterated_contract_net", "the contractor is lost", "LOST", {"CarryOut": act(breaks=True)}),
    End("iterated_contract_net", "the manager is lost", "", {"DecideRound": act(breaks=True)}),
    End("auction", "sold", "DONE"),
    End(
        "auction",
        "two at one price, then the other one",
        "DONE",
        {
            "DecideOffer": act(
                {"bob": 0.1, "cid": 0.2},
                interested={"bob": [True, False], "cid": [True, True, False]},
            )
        },
    ),
    End("auction", "nobody wants it", "NOBODY", {"DecideOffer": act(interested=False)}),
    End(
        "auction",
        "below the reserve",
        "NOBODY",
        {"OpenAuction": act(lot="a clock", price=10.0, step=5.0, reserve=100.0)},
    ),
    End("auction", "not paid", "REFUSED", {"Pay": act(solvent=False)}),
    End("auction", "no payment", "TIMED_OUT", {"Pay": NEVER}),
    End("auction", "the winner is lost", "LOST", {"Pay": act(breaks=True)}),
    End("auction", "the auctioneer is lost", "", {"CollectOffers": act(1, breaks=True)}),
    End("dutch_auction", "sold", "DONE"),
    End("dutch_auction", "nobody wants it", "NOBODY", {"DecideOffer": act(interested=False)}),
    End(
        "dutch_auction",
        "two while the next price is called",
        "DONE",
        {"CallPrice": act(0.5), "DecideOffer": act({"bob": 2.1, "cid": 2.2}, interested=True)},
    ),
    End("dutch_auction", "two at once", "DONE", {"DecideOffer": act(0.1, interested=True)}),
    End("dutch_auction", "not paid", "REFUSED", {"Pay": act(solvent=False)}),
    End("dutch_auction", "no payment", "TIMED_OUT", {"Pay": NEVER}),
    End("dutch_auction", "the winner is lost", "LOST", {"Pay": act(breaks=True)}),
    End("dutch_auction", "the auctioneer is lost", "", {"CollectOffers": act(1, breaks=True)}),
    End("brokering", "done", "DONE"),
    End("brokering", "refused", "REFUSED", {"ConsiderErrand": act(willing=False)}),
    End("brokering", "the second one can", "DONE", {"WeighErrand": act(able={"cid": False, "dan": True})}),
    End("brokering", "nobody known", "NOBODY", {"ChooseProvider": act(found=False)}),
    End("brokering", "nobody can", "NOBODY", {"WeighErrand": act(able=False)}),
    End("brokering", "all fail", "FAILED", {"RunErrand": act(succeeded=False)}),
    End(
        "brokering",
        "the first one is lost",
        "DONE",
        {"RunErrand": act(1, breaks={"cid": True, "dan": False}, succeeded=True)},
    ),
    End("brokering", "taken back", "CANCELLED", {"AwaitResult": act(1, withdrawn=True)}),
    End("brokering", "no answer", "TIMED_OUT", {"ConsiderErrand": NEVER}),
    End("brokering", "no result", "NOBODY", {"RunErrand": NEVER}),
    End("brokering", "the broker is lost", "LOST", {"AwaitProvider": act(1, breaks=True)}),
    End("brokering", "the client is lost", "", {"AwaitResult": act(1, breaks=True)}),
    End("recruiting", "done", "DONE"),
    End("recruiting", "refused", "REFUSED", {"ConsiderErrand": act(willing=False)}),
    End("recruiting", "the second one can", "DONE", {"WeighErrand": act(able={"cid": False, "dan": True})}),
    End("recruiting", "nobody known", "NOBODY", {"ChooseProvider": act(found=False)}),
    End("recruiting", "nobody can", "NOBODY", {"WeighErrand": act(able=False)}),
    End("recruiting", "all fail", "FAILED", {"RunErrand": act(succeeded=False)}),
    End(
        "recruiting",
        "the first one is lost",
        "LOST",
        {"RunErrand": act(1, breaks={"cid": True, "dan": False}, succeeded=True)},
    ),
    End("recruiting", "taken back", "CANCELLED", {"AwaitResult": act(1, withdrawn=True)}),
    End("recruiting", "no answer", "TIMED_OUT", {"ConsiderErrand": NEVER}),
    End("recruiting", "no result", "TIMED_OUT", {"RunErrand": NEVER}),
    End("recruiting", "the recruiter is lost", "LOST", {"ChooseProvider": act(1, breaks=True)}),
    End("recruiting", "the client is lost", "", {"AwaitResult": act(1, breaks=True)}),
    End("resource", "given back", "RETURNED"),
    End("resource", "renewed", "RETURNED", {"ExpressNeed": act(renewed=True), "UseResource": act(27)}),
    End("resource", "refused", "REFUSED", {"ConsiderNeed": act(willing=False)}),
    End("resource", "the lease is over", "EXPIRED", {"UseResource": NEVER}),
    End("resource", "no answer", "WITHDRAWN", {"ConsiderNeed": NEVER}),
    End("resource", "the keeper is lost", "LOST", {"ConsiderNeed": act(1, breaks=True)}),
    End("resource", "the holder is lost", "", {"UseResource": act(1, breaks=True)}),
)


def played(end: End) -> Played:
    item = protocol(end.protocol)
    made = generated(item.name)
    acts = {**item.acts, **end.acts}
    assert set(acts) == set(item.acts), "an activity that the protocol does not have"
    return play(made, {name: kind_of(made, name, what) for name, what in acts.items()}, until=LIMIT)


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_two_lines_are_a_role(item: Protocol) -> None:
    """`plays X.y`, and its place in the formula."""
    found = analysis_of(item.text())
    assert found.diagnostics == (), render_text(found.diagnostics)
    assert found.system is not None
    used = {node.activity for chart in found.system.iacs for node in chart.states if node.activity}
    assert used == set(item.acts)


def test_one_role_may_play_all_of_them() -> None:
    """What has one name in two of them gets another one with `as`; activities of one name do the same."""
    protocols = [item for item in PROTOCOLS if item.library == "protocols"]
    first = [next(iter(item.parts.values())) for item in protocols]
    other = [list(item.parts.values())[-1] for item in protocols]
    lines = ["system All", "import protocols"]
    for role, parts, formula in (("boss", first, " . "), ("hand", other, "~ || ")):
        named = [f"{part}_{number}" for number, part in enumerate(parts)]
        together = zip(protocols, parts, named, strict=True)
        plays = (f"plays {item.name}.{part} as {name}" for item, part, name in together)
        end = "~" if "~" in formula else ""
        lines += [f"srm {role} {{", *plays, f"liveness {{ {role} = {formula.join(named)}{end} }} }}"]
    lines += ["srm middle { plays brokering.broker  liveness { middle = broker~ } }"]
    lines += ["team T { ann : boss  bob, cid : hand  dan : middle }"]
    found = analysis_of("\n".join(lines))
    assert found.diagnostics == (), render_text(found.diagnostics)
    run = play("\n".join(lines), until=LIMIT)
    conversations = [record["conversation"] for record in run.of("conversation", what="open")]
    assert [name.partition("-")[0] for name in conversations] == [item.name for item in protocols]
    assert "ann" not in {agent.name for agent in run.result.agents if not agent.finished}


@pytest.mark.parametrize("end", ENDS, ids=str)
def test_it_ends(end: End) -> None:
    run = played(end)
    said = endings(run)
    item = protocol(end.protocol)
    assert said.get(next(iter(item.parts)), "") == end.ends
    assert disagreement(item, said) == ""
    assert "NONE" not in said.values()
    broken = "lost" in end.name
    assert bool(run.of("error")) == broken
    assert "UNCONFIRMED" not in said.values()  # on a network without faults
    left = [agent for agent in protocol(end.protocol).parts if not _is_over(run, agent)]
    assert left == [], f"{left} still wait"


def _is_over(run: Played, agent: str) -> bool:
    """Whether an agent has ended, well or not, or was never asked."""
    took_part = any(record["what"] in ("open", "join") for record in run.of("conversation", agent=agent))
    ended = any(item.name == agent and (item.finished or item.failure) for item in run.result.agents)
    return ended or not took_part


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_what_is_said(item: Protocol, snapshot: Snapshot) -> None:
    """All conversations of a protocol, message by message."""
    lines: list[str] = []
    for end in ENDS:
        if end.protocol == item.name:
            run = played(end)
            lines += [f"{end.name}:", *(f"  {line}" for line in said(run)), ""]
    snapshot("\n".join(lines), f"{item.name}.txt")


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_the_pictures_of_the_documentation(item: Protocol, request: pytest.FixtureRequest) -> None:
    """What is said if all goes well, as `asemec sniff` draws it."""
    run = played(next(end for end in ENDS if end.protocol == item.name))
    sniffer = Sniffer()
    sniffer.header(run.of("header")[0])
    diagram = sniffer.diagram([row for record in run.records for row in sniffer.rows(record)])
    lifelines = tuple(replace(line, role=item.parts[line.name]) for line in diagram.lifelines)
    picture = drawn(replace(diagram, title=item.name, lifelines=lifelines))
    assert overlaps(picture) == []
    path = PICTURES / f"talk_{item.name}.svg"
    if request.config.getoption("--snapshot-update"):
        path.write_text(picture, "utf-8")
    assert path.read_text("utf-8") == picture, "if the new one is right: --snapshot-update"


def test_an_order_to_somebody_who_ends_without_it_is_not_understood() -> None:
    item = protocol("request")
    napping = """responder_role = Nap | responder }
      activities { Nap takes 5s }
      control responder_role { enter Nap : [true]  enter responder : else }"""
    made = generate(item.text().replace("responder_role = responder }", napping))
    acts = {**item.acts, "PrepareOrder": act(2, says=("Order", {"id": "1"}))}
    run = play(made, {name: kind_of(made, name, what) for name, what in acts.items()}, until=LIMIT)
    assert said(run) == [
        "2 s ann request Order (id 1) to bob",
        "5 s bob did not expect request Order: bob has ended",
        "5 s bob not_understood Order (id 1) to ann",
        "5 s ann ended NOT_UNDERSTOOD",
    ]


def said(run: Played) -> list[str]:
    """Who said what to whom, what came amiss, and how it ended."""
    lines = []
    for record in run.records:
        moment = f"{record['time'] / SECOND:g} s"
        match record["kind"]:
            case "agent_message":
                members = ", ".join(f"{key} {value}" for key, value in record["content"].items() if value)
                what = f"{record['performative']} {record['message']}"
                to = ", ".join(record["to"]) or "nobody"
                lines.append(f"{moment} {record['agent']} {what} ({members}) to {to}")
            case "unexpected":
                what = f"{record['performative']} {record['message']}"
                lines.append(f"{moment} {record['agent']} did not expect {what}: {record['reason']}")
            case "fault" | "error":
                lines.append(f"{moment} {record['agent']} {record['kind']}: {record['reason']}")
            case "log":
                lines.append(f"{moment} {record['agent']} {record['text']}")
    return lines


def test_a_library_is_known_wherever_one_stands(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """What it was called from another folder says nothing of where it is."""
    text = protocol("propose").text()
    assert analyse(Source("team.aseme", text)).diagnostics == ()
    monkeypatch.chdir(tmp_path)
    assert analyse(Source("team.aseme", text)).diagnostics == ()
    monkeypatch.undo()
    assert analyse(Source("team.aseme", text)).diagnostics == ()


def test_news_that_come_while_one_is_read_wait_for_it() -> None:
    """Each is read to its end, also where they come quicker than they are read."""
    reads, watches = act(5, withdrawn=[False, False, False, True]), protocol("subscribe").acts["WatchSource"]
    end = End("subscribe", "", "CANCELLED", {"ReadNews": reads, "WatchSource": Act(1, {}, watches.says)})
    run = played(end)
    read = run.of("activity", activity="ReadNews")
    assert [record["what"] for record in read] == ["start", "end"] * 4
    assert endings(run) == {"ann": "CANCELLED", "bob": "CANCELLED"}
