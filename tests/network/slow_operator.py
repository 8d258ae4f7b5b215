"""An operator who stops in the midst of a swap: `python slow_operator.py PHASE WHEN ARGUMENTS…`.

It is `asemec ARGUMENTS…`, but says `now` on standard output and waits for a line when it is in a phase of the
swap (`ready`, `prepare`, `commit`, `finish`). WHEN is `before` any robot has been asked, in the `midst`, when
half of them have answered, or `after` all have.
"""

from __future__ import annotations

import sys
from typing import Any

from aseme_dsl.cli import main
from aseme_dsl.project.operating import swapping


def stopping(phase: str, when: str) -> None:
    """Have swaps of this process stop once."""
    ask_each: Any = swapping.ask_each
    stopped = False

    def asked(requests: dict[Any, Any], *seconds: float) -> dict[Any, Any]:
        nonlocal stopped
        if stopped or not any(said.get("phase") == phase for said in requests.values()):
            return dict(ask_each(requests, *seconds))
        stopped = True
        first = {"before": 0, "midst": len(requests) // 2, "after": len(requests)}[when]
        parts = list(requests.items())
        found = dict(ask_each(dict(parts[:first]), *seconds))
        print("now", flush=True)
        sys.stdin.readline()
        return found | dict(ask_each(dict(parts[first:]), *seconds))

    swapping.ask_each = asked


if __name__ == "__main__":
    phase, when, *arguments = sys.argv[1:]
    stopping(phase, when)
    sys.exit(main(arguments))
