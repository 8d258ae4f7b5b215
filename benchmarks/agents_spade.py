"""Two hand-written SPADE agents in one process that hand a ball to and fro; run by `agents.py`.

They are agents as SPADE has them, but for the connection to a server: what they send goes through SPADE's own
container. For each number that comes on standard input so many passes are made, and the delay of each, in ns,
comes back as one line of JSON.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
import time

import spade
from spade.agent import Agent
from spade.behaviour import CyclicBehaviour
from spade.message import Message

ONTOLOGY = {"performative": "inform", "protocol": "rally", "language": "json", "ontology": "Rally"}


class Local(Agent):
    """An agent that is not connected to a server."""

    async def _async_connect(self):
        return


class Rally(CyclicBehaviour):
    def __init__(self, other, delays, wanted, done):
        super().__init__()
        self.other, self.delays, self.wanted, self.done = other, delays, wanted, done

    async def run(self):
        message = await self.receive(timeout=60)
        if message is None:
            return
        now = time.perf_counter_ns()
        self.delays.append(now - json.loads(message.body)["t"])
        if len(self.delays) >= self.wanted[0]:
            self.done.set()
            return
        await self.send(ball(self.other))


def ball(to):
    """A message of the same size as ours."""
    message = Message(to=to)
    for name, value in ONTOLOGY.items():
        message.set_metadata(name, value)
    message.body = json.dumps({"t": time.perf_counter_ns()})
    return message


async def main():
    """Play as often as is asked."""
    delays, wanted, done = [], [0], asyncio.Event()
    names = ["left@localhost", "right@localhost"]
    agents = [Local(name, "secret") for name in names]
    for agent, other in zip(agents, reversed(names), strict=True):
        agent.add_behaviour(Rally(other, delays, wanted, done))
        await agent.start(auto_register=False)
    serve = agents[0].behaviours[0]
    print("ready", flush=True)
    loop = asyncio.get_running_loop()
    while line := await loop.run_in_executor(None, sys.stdin.readline):
        delays.clear()
        done.clear()
        wanted[0] = int(line)
        await serve.send(ball(names[1]))
        await done.wait()
        print(json.dumps(delays), flush=True)
    os._exit(0)


if __name__ == "__main__":
    spade.run(main(), embedded_xmpp_server=False)
