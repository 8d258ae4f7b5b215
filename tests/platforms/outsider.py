"""A SPADE agent written by hand, as somebody else would, in a process of its own.

    python outsider.py HOST PORT JID

Commands are lines of JSON on its standard input: {"to": …, "metadata": {…}, "body": …}. What it receives are
lines of JSON on its standard output. It uses SPADE alone.
"""

from __future__ import annotations

import asyncio
import json
import sys

import spade
from spade.behaviour import CyclicBehaviour
from spade.message import Message


class Outsider(spade.agent.Agent):
    class Listen(CyclicBehaviour):
        async def run(self) -> None:
            message = await self.receive(timeout=60)
            if message is not None:
                said = {"from": str(message.sender), "metadata": message._metadata, "body": message.body}
                print(json.dumps(said), flush=True)

    class Speak(CyclicBehaviour):
        async def run(self) -> None:
            line = await asyncio.to_thread(sys.stdin.readline)
            if not line:
                await self.agent.stop()
                return
            said = json.loads(line)
            await self.send(Message(to=said["to"], body=said["body"], metadata=said["metadata"]))

    async def setup(self) -> None:
        self.add_behaviour(self.Listen())
        self.add_behaviour(self.Speak())


async def main() -> None:
    # SPADE connects to the host of the address: the tests' server is on another port of it.
    agent = Outsider(sys.argv[3], "secret", port=int(sys.argv[2]))
    await agent.start(auto_register=True)
    print(json.dumps({"ready": str(agent.client.boundjid.full)}), flush=True)
    while agent.is_alive():
        await asyncio.sleep(0.1)


if __name__ == "__main__":
    spade.run(main())
