"""An agent that somebody else has written for mango: it plays one role once, as `by_hand.py` has it.

    python by_hand_mango.py PORT NAME ROLE PARTNERS DIRECTORY WAY

PARTNERS are a JSON object: the address of each other part, as host:port/name. It prints what it has heard, as
JSON, when it is done. It uses mango alone.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
from typing import Any

import by_hand
import mango


class Agent(mango.Agent):
    def __init__(self, hand: by_hand.Hand) -> None:
        super().__init__()
        self.hand = hand

    def on_ready(self) -> None:
        self.say(self.hand.begin())

    def handle_message(self, content: Any, meta: dict[str, Any]) -> None:
        host, port = meta["sender_addr"]
        headers = {name.replace("_", "-"): str(value) for name, value in meta.items()}
        headers["performative"] = meta["performative"].name.replace("_", "-")
        text = content if isinstance(content, str) else json.dumps(content)
        self.say(self.hand.hear(f"{host}:{port}/{meta['sender_id']}", headers, text))

    def say(self, sent: list[by_hand.Sent]) -> None:
        self.schedule_instant_task(self.send_all(sent))

    async def send_all(self, sent: list[by_hand.Sent]) -> None:
        await asyncio.sleep(self.hand.waits if sent else 0)
        for address, headers, content in sent:
            place, _, name = address.partition("/")
            host, _, port = place.rpartition(":")
            meta: dict[str, Any] = {key.replace("-", "_"): value for key, value in headers.items()}
            meta["performative"] = mango.Performatives[meta["performative"].replace("-", "_")]
            to = mango.AgentAddress((host, int(port)), name)
            message = mango.create_acl(content, to, self.addr, meta)
            await self.send_message(message, to)
        if self.hand.breaks:
            if self.hand.way == "returning":  # the same place, and nothing remembered
                os.execv(sys.executable, [sys.executable, *sys.argv[:-1], "honest"])
            os._exit(0)


async def main() -> None:
    port, name, role, partners, directory, way = sys.argv[1:]
    container = mango.create_tcp_container(addr=("127.0.0.1", int(port)), codec=mango.JSON())
    hand = by_hand.Hand(role, json.loads(partners), directory, way)
    agent = container.register(Agent(hand), suggested_aid=name)
    async with mango.activate(container):
        while not agent.hand.over and not agent.hand.refused:
            await asyncio.sleep(0.02)
        await asyncio.sleep(0.2)
        print(json.dumps({"heard": agent.hand.heard, "refused": agent.hand.refused}), flush=True)
        await asyncio.to_thread(sys.stdin.read)  # it stays until it may go


if __name__ == "__main__":
    asyncio.run(main())
