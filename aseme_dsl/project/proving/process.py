"""Process: answers one question of an editor about all runs of a system, in a process of its own.

It reads one line of JSON: `path` and `text` of the file with the system, `asked`, `of`, `robots`, `seconds`
and `states`. `asked` are names of what to answer, `of` the team or protocols to explore; all if none.

It writes lines of JSON: `{"told": …}` when it begins with something. The last is `{"problem": …}` or
`{"results": […], "files": […]}`. It ends at once when its input is closed: it never outlives the editor.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from collections.abc import Callable, Mapping

from aseme_dsl import outside
from aseme_dsl.diagnostics import Severity, has_errors
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.playing.operate import OperateError
from aseme_dsl.project.proving.prove import NotThere, prove
from aseme_dsl.project.proving.results import Result
from aseme_dsl.proofs.explore.search import Limits
from aseme_dsl.runtime.version.loading import LoadError
from aseme_dsl.source import Source


def main() -> None:
    """Answer, and end."""
    output = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # the code of the system may print
    asked = outside.loads(sys.stdin.buffer.readline())
    threading.Thread(target=_end_with_the_editor, daemon=True).start()

    def say(line: Mapping[str, object]) -> None:
        print(json.dumps(line), file=output, flush=True)

    assert isinstance(asked, dict)
    say(answer(asked, lambda text: say({"told": text})))


def answer(asked: Mapping[str, object], told: Callable[[str], None]) -> dict[str, object]:
    """The last line."""
    names, of = asked["asked"], asked["of"]
    assert isinstance(names, list) and isinstance(of, list)
    compiled = compile_root(Source(str(asked["path"]), str(asked["text"])))
    wrong = [item for item in compiled.diagnostics if item.severity is Severity.ERROR]
    if compiled.system is None or has_errors(wrong):
        return {"problem": wrong[0].message if wrong else "the file declares no system"}
    limits = Limits(int(str(asked["states"])), float(str(asked["seconds"])))
    try:
        found = prove(compiled, names, int(str(asked["robots"])), limits, told, only=of, must_be_there=False)
    except (NotThere, LoadError, OperateError) as problem:
        return {"problem": str(problem)}
    return {"results": [_written(item) for item in found], "files": list(compiled.depends)}


def _written(item: Result) -> dict[str, object]:
    """A result with the parts of its scenario apart."""
    case = item.case
    scenario = None if case is None else {"title": case.title, "roles": case.roles, "text": case.text}
    return {**item.as_json, "scenario": scenario}


def _end_with_the_editor() -> None:
    while os.read(sys.stdin.fileno(), 1024):  # without a lock, which would be held when the process ends
        pass
    os._exit(0)


if __name__ == "__main__":
    main()

__all__ = ["answer", "main"]
