"""Wheels: the Python packages that a bundle brings along for the architecture of its robots."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from aseme_dsl.project.deploying.bundle import BundleError
from aseme_dsl.project.settings.configuration import Configuration

ARCHITECTURES = ("x86_64", "aarch64", "armv7l")
_TAGS = ("linux_{}", "manylinux2014_{}", *(f"manylinux_2_{number}_{{}}" for number in range(17, 37)))
_EXTRA = re.compile(r";.*\bextra\s*==\s*['\"](\w+)['\"]")
_EXCLUDED = re.compile(r"platform_machine\s*!=\s*['\"](\w+)['\"]")


def wheels_for(configuration: Configuration, architecture: str, python: str) -> Mapping[str, bytes]:
    """The wheels of asemec, Zenoh and the project's requirements, by file name, with all that they need.

    They are for Linux on this architecture, and CPython of this version, such as `3.11`.

    Raises:
        BundleError: pip fails.
    """
    with tempfile.TemporaryDirectory() as folder:
        own = _own_wheel(Path(folder) / "own")
        wanted = [*_needs(architecture), *_project_needs(configuration)]
        place = Path(folder) / "wheels"
        place.mkdir()
        words = ["download", "--quiet", "--only-binary=:all:", "--dest", str(place)]
        words += ["--implementation", "cp", "--python-version", python]
        for abi in (f"cp{python.replace('.', '')}", "abi3", "none"):
            words += ["--abi", abi]
        for tag in _TAGS:
            words += ["--platform", tag.format(architecture)]
        requirements = configuration.folder / "requirements.txt"
        if requirements.is_file():
            words += ["-r", str(requirements)]
        _pip([*words, *wanted])
        files = [own, *place.glob("*.whl")]
        return {path.name: path.read_bytes() for path in sorted(files)}


def this_architecture() -> str:
    """That of this machine."""
    return platform.machine().lower().replace("amd64", "x86_64").replace("arm64", "aarch64")


def _needs(architecture: str) -> Iterator[str]:
    """What asemec needs on such a machine, and Zenoh.

    pip looks at the machine that it runs on, and this may be another one.
    """
    for line in metadata.requires("aseme-dsl") or ():
        extra, excluded = _EXTRA.search(line), _EXCLUDED.search(line)
        if (extra is None or extra[1] == "zenoh") and (excluded is None or excluded[1] != architecture):
            yield line.partition(";")[0].strip()


def _project_needs(configuration: Configuration) -> Sequence[str]:
    """`dependencies` of the project itself."""
    if configuration.path is None:
        return ()
    project = tomllib.loads(configuration.path.read_text("utf-8")).get("project", {})
    found = project.get("dependencies", []) if isinstance(project, dict) else []
    own = re.compile(r"aseme[-_.]dsl\b", re.IGNORECASE)
    return [item for item in found if isinstance(item, str) and not own.match(item)]


def _own_wheel(place: Path) -> Path:
    """The wheel of asemec itself: built from its folder where it is installed from one."""
    place.mkdir()
    said = metadata.distribution("aseme-dsl").read_text("direct_url.json")
    source = f"aseme-dsl=={metadata.version('aseme-dsl')}"
    if said is not None:
        address = urlparse(json.loads(said)["url"])
        source = unquote(address.path) if address.scheme == "file" else address.geturl()
    _pip(["wheel", "--quiet", "--no-deps", "--wheel-dir", str(place), source])
    (found,) = place.glob("*.whl")
    return found


def _pip(words: Sequence[str]) -> None:
    command = [sys.executable, "-m", "pip", *words, "--no-input", "--disable-pip-version-check"]
    # With this, the same source gives the same wheel.
    environment = {**os.environ, "SOURCE_DATE_EPOCH": "1577836800"}
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        raise BundleError(f"pip failed: {(done.stderr or done.stdout).strip()[-1000:]}")
