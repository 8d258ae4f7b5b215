"""The page for people who come from JADE names every class of its behaviours and protocols once."""

from __future__ import annotations

import re

import pytest

from tests.docs.pages import ROOT

CLASSES = {
    "jade.core.behaviours": """
        ActionExecutor BaseInitiator Behaviour BehaviourList ComplexBehaviour CompositeBehaviour
        CyclicBehaviour DataStore FSMBehaviour LoaderBehaviour NonDeterministicBehaviour OneShotBehaviour
        OntologyServer OutcomeManager ParallelBehaviour ReceiverBehaviour SenderBehaviour SequentialBehaviour
        SerialBehaviour SimpleBehaviour ThreadedBehaviourFactory TickerBehaviour WakerBehaviour
        WrapperBehaviour
    """,
    "jade.proto": """
        AchieveREInitiator AchieveREResponder CommunicativeAction ContractNetInitiator ContractNetResponder
        FIPAProtocolNames FIPARequestInitiator FIPARequestResponder FipaContractNetInitiatorBehaviour
        FipaContractNetResponderBehaviour FipaQueryInitiatorBehaviour FipaQueryResponderBehaviour
        FipaRequestInitiatorBehaviour FipaRequestResponderBehaviour HandlerSelector Initiator Interaction
        IteratedAchieveREInitiator MessageGroup MessageHandler MessageSelector MsgReceiver ProposeInitiator
        ProposeResponder Protocol ProtocolDrivenBehaviour ProtocolMessageHandler ReplySender Responder
        SSContractNetResponder SSIteratedAchieveREResponder SSResponder SSResponderDispatcher
        SimpleAchieveREInitiator SimpleAchieveREResponder Standard StateResetter SubscriptionInitiator
        SubscriptionResponder TwoPh0Initiator TwoPh1Initiator TwoPh2Initiator TwoPhConstants TwoPhInitiator
        TwoPhResponder Waker
    """,
}
"""What the two packages have had in the history of JADE's sources."""


@pytest.mark.parametrize("package", CLASSES)
def test_each_class_of_jade_has_a_counterpart_or_a_reason(package: str) -> None:
    text = (ROOT / "docs" / "howto" / "run-jade-behaviours.md").read_text("utf-8")
    table = text.partition(f"### Classes of `{package}`")[2].split("\n#", 1)[0]
    rows = [line.split("|")[1:3] for line in table.splitlines() if line.startswith("| `")]
    named = [name for first, _ in rows for name in re.findall(r"`(\w+)`", first)]
    assert sorted(named) == sorted(CLASSES[package].split())
    assert all(second.strip() for _, second in rows)
    assert all(" because " in second for _, second in rows if second.strip().startswith("none"))
