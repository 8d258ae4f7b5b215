"""An agent that somebody else has written for SPADE: it plays one role once, as `by_hand.py` has it.

    python by_hand_spade.py PORT JID ROLE PARTNERS DIRECTORY WAY

PARTNERS are a JSON object: the address of each other part. It prints what it has heard, as JSON, when it is
done. It uses SPADE alone.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys

import by_hand
import spade
from spade.behaviour import CyclicBehaviour
from spade.message import Message


class Agent(spade.agent.Agent):
    class Play(CyclicBehaviour):
        async def on_start(self) -> None:
            await self.say(self.agent.hand.begin())

        async def run(self) -> None:
            message = await self.receive(timeout=60)
            if message is None:
                return
            headers = dict(message._metadata)
            await self.say(self.agent.hand.hear(str(message.sender), headers, message.body or ""))

        async def say(self, sent: list[by_hand.Sent]) -> None:
            hand = self.agent.hand
            await asyncio.sleep(hand.waits if sent else 0)
            for to, headers, content in sent:
                await self.send(Message(to=to, body=content, metadata=headers))
            if hand.breaks:
                await asyncio.sleep(0.1)  # what it has said is on its way
                if hand.way == "returning":  # the same account, and nothing remembered
                    os.execv(sys.executable, [sys.executable, *sys.argv[:-1], "honest"])
                os._exit(0)

    async def setup(self) -> None:
        self.add_behaviour(self.Play())


async def main() -> None:
    port, jid, role, partners, directory, way = sys.argv[1:]
    agent = Agent(jid, "secret", port=int(port))
    agent.hand = by_hand.Hand(role, json.loads(partners), directory, way)
    await agent.start(auto_register=True)
    while agent.is_alive() and not agent.hand.over and not agent.hand.refused:
        await asyncio.sleep(0.02)
    print(json.dumps({"heard": agent.hand.heard, "refused": agent.hand.refused}), flush=True)
    await asyncio.to_thread(sys.stdin.read)  # it stays until it may go
    await agent.stop()


if __name__ == "__main__":
    spade.run(main())
