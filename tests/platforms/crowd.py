"""One process of a crowd over SPADE: each of its agents asks others, in other processes, and answers others.

    python -m tests.platforms.crowd PORT PROCESS PROCESSES AGENTS EACH WIDTH [untraced]

Every agent has `EACH` conversations as the one who asks and as many as the one who is asked, `WIDTH` of them
at once: request, inform, confirm. Waits for a line on its standard input, and says at the end, as JSON, what
was right and wrong, and how much time and processor time passed since the line.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import sys
import threading
import time
from collections import Counter
from typing import Any

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.platform.over_spade import SpadePlatform
from aseme_dsl.runtime.team.team import Setup, Team
from aseme_dsl.runtime.transport.reliable_delivery import Post
from aseme_dsl.runtime.transport.settings import Xmpp
from tests.support.generated import generate

TEXT = """
system Crowd
message Question { int n }
message Answer   { int n  int square }
message Thanks   { int n  int square }
aip ask {
  participant asker {
    var n : int = 0
    sends    request Question by Ask, confirm Thanks
    receives inform Answer
    process  = Ask . Wait
  }
  participant helper {
    sends    inform Answer
    receives request Question, confirm Thanks
    process  = Await . Rest
  }
  control asker {
    leave Wait : inform Answer a from helper [a.n == n and a.square == n * n]
                 / send confirm Thanks { n = a.n, square = a.square } to helper
  }
  control helper {
    enter Rest : request Question q from asker
                 / send inform Answer { n = q.n, square = q.n * q.n } to asker
    leave Rest : confirm Thanks from asker
  }
}
srm peer {
  plays ask.asker, ask.helper
  liveness { peer = asker~[WIDTH] || helper~[WIDTH] }
  activities {
    Ask writes n
    Wait takes 60min  Rest takes 60min  Await takes 60min
  }
}
"""


def asked_by(me: int, k: int, processes: int, agents: int) -> int:
    """Whom the k-th question of an agent goes to: each gets as many as it asks, from other processes."""
    process = (me // agents + 1 + k % (processes - 1)) % processes
    return process * agents + (me + k // (processes - 1)) % agents


def main() -> None:
    """Take part, and say how it was."""
    port, process, processes, agents, each, width = (int(word) for word in sys.argv[1:7])
    crowd = generate(TEXT.replace("WIDTH", str(width)))
    names = [f"a{n}" for n in range(processes * agents)]
    mine = names[process * agents : (process + 1) * agents]
    settings = Xmpp(port=port, password="secret", register=True, verify=False)
    link = PlatformLink(SpadePlatform(settings, names), "Crowd", names)
    go = threading.Event()
    numbers: Counter[str] = Counter()
    lock = threading.Lock()

    class Ask:
        async def execute(self, context: Context) -> None:
            while not go.is_set():
                await asyncio.sleep(0.02)
            with lock:
                k = numbers[context.agent]
                numbers[context.agent] += 1
            while k >= each:
                await asyncio.sleep(60)
            n = int(context.agent[1:]) * each + k
            context.set_variable("n", n)
            to = names[asked_by(n // each, n % each, processes, agents)]
            context.send("request", crowd.message("Question", n=n), to)

    post = Post(
        link, crowd.messages.SCHEMA, crowd.package.MODEL, [chart.PLAN for chart in crowd.charts.values()]
    )
    records: list[dict[str, Any]] = []
    kept = {"conversation", "unexpected", "fault", "lost", "error"}
    left = itertools.count(1)
    over = threading.Event()

    def keep(record: dict[str, Any]) -> None:
        if record["kind"] in kept and not over.is_set():  # a loaded machine is slow to end its activities
            records.append(record)

    team = Team(
        [(name, crowd.charts["peer"]) for name in names],
        {"Ask": Ask},
        Setup(
            messages={name: getattr(crowd.messages, name) for name in ("Question", "Answer", "Thanks")},
            schema=crowd.messages.SCHEMA,
            path=[crowd.folder],
            here=tuple(mine),
            transport=post,
            clock="real",
            listeners=() if "untraced" in sys.argv else (keep,),
        ),
    )
    leave = team.conversations.left

    def counted(agent: Any, branch: str, completed: bool = False) -> None:
        leave(agent, branch, completed)
        if next(left) == 2 * each * len(mine):
            over.set()

    team.conversations.left = counted  # type: ignore[method-assign]
    said: dict[str, Any] = {}

    def begin() -> None:
        while len([peer for peer in post.peers().values() if peer.alive]) < len(names) - len(mine):
            time.sleep(0.05)
        print("ready", flush=True)
        sys.stdin.readline()
        said["cpu"], said["wall"] = -time.process_time(), -time.monotonic()
        go.set()
        over.wait()
        said["cpu"] += time.process_time()
        said["wall"] += time.monotonic()
        print("done", flush=True)
        sys.stdin.readline()
        team.driver.stop("over")

    threading.Thread(target=begin, daemon=True).start()
    result = team.run()
    what = Counter(f"{r['what']} {r['participant']}" for r in records if r["kind"] == "conversation")
    wrong = [r for r in records if r["kind"] != "conversation"]
    mixed = len({r["conversation"] for r in records if r["kind"] == "conversation" and r["what"] == "open"})
    said |= {"what": what, "wrong": wrong[:5], "opened": mixed, "failed": result.failed}
    print(json.dumps(said), flush=True)


if __name__ == "__main__":
    main()
