"""New: the skeleton of a project, small and running."""

from __future__ import annotations

import keyword
import re
from pathlib import Path
from string import Template

from aseme_dsl.project.files.write import DISK, Disk, Written, write_new

_TEMPLATES = Path(__file__).resolve().parent / "templates" / "project"
_SUFFIX = ".template"


class BadName(ValueError):
    """A project cannot have this name; the text says why."""


def new_project(folder: Path, name: str | None = None, disk: Disk = DISK) -> Written:
    """Write the skeleton of a project into `folder`, which need not exist; nothing there is overwritten.

    The system is called `name`, or as the folder: `my-patrol` gives `MyPatrol` in `my_patrol.aseme`.

    Raises:
        BadName: no system can be called so.
    """
    words = _words(name or folder.resolve().name)
    system = "".join(word[:1].upper() + word[1:] for word in words)
    module = "_".join(word.lower() for word in words)
    files: dict[Path, bytes] = {}
    for template in sorted(_TEMPLATES.rglob(f"*{_SUFFIX}")):
        inside = template.relative_to(_TEMPLATES).as_posix().removesuffix(_SUFFIX).replace("NAME", module)
        path = folder / (".gitignore" if inside == "gitignore" else inside)
        files[path] = Template(template.read_text("utf-8")).substitute(system=system, module=module).encode()
    return write_new(files, disk)


def _words(name: str) -> list[str]:
    """The words of a name: `my-patrol`, `my_patrol`, `MyPatrol` and `my patrol` are all `my`, `patrol`."""
    spaced = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name)
    words = re.findall(r"[A-Za-z0-9]+", spaced)
    if not words or not words[0][0].isalpha() or not name.isascii():
        raise BadName(f"{name!r} cannot name a system: letters, digits and - are wanted, a letter first")
    if keyword.iskeyword("".join(word[:1].upper() + word[1:] for word in words)):
        raise BadName(f"{name!r} cannot name a system: it means something else in Python")
    return words
