"""Roles that play a library protocol with methods of their behaviours, and what they say."""

from __future__ import annotations

from typing import Any

from aseme_dsl.backends.jade_like import BACKEND
from tests.runtime.playing import SECOND, Played
from tests.support.generated import Generated, generate

KITCHEN = """\
system Kitchen
import protocols
srm boss {
  plays PROTOCOL.OPENER
  liveness { boss = OPENER . Rest }
  activities { Rest takes 1s }
}
srm cook {
  plays PROTOCOL.ANSWERER
  liveness { cook = ANSWERER~ }
}
team Kitchen { ann : boss  bob, cid : cook }
"""

BROKERED = """\
system Town
import protocols
srm asker {
  plays PROTOCOL.client
  liveness { asker = client . Rest }
  activities { Rest takes 1s }
}
srm middle {
  plays PROTOCOL.MIDDLE
  liveness { middle = MIDDLE~ }
}
srm doer {
  plays PROTOCOL.provider
  liveness { doer = provider~ }
}
team Town { ann : asker  max : middle  bob, cid : doer }
"""

MIDDLES = {"brokering": "broker", "recruiting": "recruiter"}


def kitchen(protocol: str, opener: str, answerer: str) -> Generated:
    """A protocol between `ann`, who opens it, and `bob` and `cid`."""
    return _generated(KITCHEN, PROTOCOL=protocol, OPENER=opener, ANSWERER=answerer)


def town(protocol: str) -> Generated:
    """A protocol in which `max` looks for a provider among `bob` and `cid`, for `ann`."""
    return _generated(BROKERED, PROTOCOL=protocol, MIDDLE=MIDDLES[protocol])


def _generated(text: str, **names: str) -> Generated:
    for word, name in names.items():
        text = text.replace(word, name)
    return generate(text, backend=BACKEND)


def behaviour(made: Generated, role: str, name: str, **methods: Any) -> dict[str, type[Any]]:
    """The user's class of a role's agent, which uses a participant's behaviour with these methods."""
    generated: Any = made.package.AGENTS[role]
    behaviours = __import__(generated.main.__module__, fromlist=["x"])
    kind = type(name, (getattr(behaviours, name),), methods)
    return {generated.own: type(generated.own, (generated,), {"setup": lambda agent: agent.use(kind)})}


def logs(played: Played, agent: str = "ann") -> list[str]:
    return [f"{r['time'] // SECOND} {r['text']}" for r in played.of("log", agent=agent)]


def heard(name: str) -> Any:
    """A method that logs the messages that it is given."""

    def method(self: Any, found: Any) -> None:
        items = found if isinstance(found, list) else [found]
        self.log(f"{name}: {', '.join(f'{item.performative} of {item.sender}' for item in items)}")

    return method


def messages(played: Played) -> list[str]:
    return [
        f"{r['time'] // SECOND} {r['agent']} {r['performative']} {r['message']}"  # type: ignore[operator]
        for r in played.of("agent_message")
    ]
