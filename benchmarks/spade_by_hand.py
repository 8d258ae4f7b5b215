"""The conversations of `tests/platforms/crowd.py` by SPADE agents as one writes them by hand.

Called in the same way. Each agent has a behaviour that receives everything and remembers, by conversation,
what it has asked.
"""

from __future__ import annotations

import asyncio
import json
import sys
import time

import spade
from spade.behaviour import CyclicBehaviour, OneShotBehaviour
from spade.message import Message

from tests.platforms.crowd import asked_by

PORT, PROCESS, PROCESSES, AGENTS, EACH, WIDTH = (int(word) for word in sys.argv[1:7])
FINISHED = 0


def message(
    to: str, performative: str, conversation: str, reply_with: str, answers: str, content: object
) -> Message:
    """An agent message with FIPA's parameters."""
    metadata = {
        "performative": performative,
        "conversation-id": conversation,
        "protocol": "ask",
        "ontology": "Crowd",
        "language": "json",
        "reply-with": reply_with,
    }
    if answers:
        metadata["in-reply-to"] = answers
    return Message(to=to, body=json.dumps(content), metadata=metadata)


class Peer(spade.agent.Agent):
    """Asks, answers and confirms."""

    def __init__(self, number: int) -> None:
        super().__init__(f"a{number}@localhost", "secret", port=PORT)
        self.number = number
        self.asked: dict[str, int] = {}
        self.answered: dict[str, int] = {}
        self.sent = 0
        self.begun = 0

    def next_name(self) -> str:
        self.sent += 1
        return f"a{self.number}-{self.sent}"

    async def ask(self, behaviour: CyclicBehaviour) -> None:
        """Begin the next conversation."""
        k = self.begun
        if k < EACH:
            self.begun += 1
            n = self.number * EACH + k
            conversation = f"ask-a{self.number}-{k}"
            self.asked[conversation] = n
            to = f"a{asked_by(self.number, k, PROCESSES, AGENTS)}@localhost"
            await behaviour.send(message(to, "request", conversation, self.next_name(), "", {"n": n}))

    class Ask(OneShotBehaviour):
        async def run(self) -> None:
            for _ in range(WIDTH):
                await self.agent.ask(self)

    class Listen(CyclicBehaviour):
        async def run(self) -> None:
            global FINISHED
            got = await self.receive(timeout=10)
            if got is None:
                return
            agent = self.agent
            performative, conversation = got.get_metadata("performative"), got.get_metadata("conversation-id")
            content = json.loads(got.body)
            n, answers, sender = content["n"], got.get_metadata("reply-with"), str(got.sender)
            if performative == "request":
                agent.answered[conversation] = n
                answer = {"n": n, "square": n * n}
                await self.send(message(sender, "inform", conversation, agent.next_name(), answers, answer))
            elif performative == "inform":
                assert agent.asked.pop(conversation) == n and content["square"] == n * n
                await self.send(message(sender, "confirm", conversation, agent.next_name(), answers, content))
                FINISHED += 1
                await agent.ask(self)
            elif performative == "confirm":
                assert agent.answered.pop(conversation) == n
                FINISHED += 1


async def main() -> None:
    """Take part, and say how it was."""
    agents = [Peer(PROCESS * AGENTS + number) for number in range(AGENTS)]
    for agent in agents:
        await agent.start(auto_register=True)
        agent.add_behaviour(agent.Listen())
    await asyncio.sleep(1.0)
    print("ready", flush=True)
    await asyncio.to_thread(sys.stdin.readline)
    cpu, wall = time.process_time(), time.monotonic()
    for agent in agents:
        agent.add_behaviour(agent.Ask())
    while FINISHED < 2 * EACH * AGENTS:
        await asyncio.sleep(0.02)
    cpu, wall = time.process_time() - cpu, time.monotonic() - wall
    print("done", flush=True)
    await asyncio.to_thread(sys.stdin.readline)
    print(json.dumps({"cpu": cpu, "wall": wall}), flush=True)


if __name__ == "__main__":
    spade.run(main())
