"""Cluster: runs in virtual time on the workers of a Dask cluster, which get a copy of the files."""

from __future__ import annotations

import io
import pickle
import platform
import threading
import zipfile
from collections.abc import Callable, Iterator, Sequence
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, TypeVar

from aseme_dsl import outside
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from distributed import Client

JobT = TypeVar("JobT")
ResultT = TypeVar("ResultT")

PATIENCE = 10
"""So many seconds a scheduler has to answer, and to have its first worker."""
LARGEST = 50_000_000
"""So many bytes of files are copied to the workers at most."""
KEPT = 4
"""So many archives stay unpacked on a worker."""


@dataclass(frozen=True, slots=True)
class Cluster:
    """Where the scheduler of a cluster listens, such as `tcp://10.0.0.1:8786`."""

    address: str


class ClusterError(Exception):
    """The cluster cannot be used; the text says why."""


@dataclass(frozen=True, slots=True)
class Copied:
    """A folder of which the workers get a copy. `without` are folders in it that they do not need."""

    folder: Path
    without: tuple[Path, ...] = ()


def play_there(
    cluster: Cluster,
    play: Callable[[JobT], ResultT],
    jobs: Sequence[JobT],
    copied: Sequence[Copied],
    told: Callable[[], None],
) -> list[ResultT]:
    """What `play` makes of the jobs, in their order; `told` is called after each.

    A path in a job that is inside one of the folders `copied` means the copy on the worker.

    Raises:
        ClusterError: the cluster does not answer, has no worker, other versions, or has lost its workers; or
            the folders are too large.
    """
    try:
        import distributed
    except ImportError as missing:
        raise ClusterError(
            "a cluster needs Dask's distributed: pip install 'aseme-dsl[cluster]'"
        ) from missing

    roots = [item.folder.absolute() for item in copied]
    try:
        archive = _packed(copied)
    except OSError as problem:
        raise ClusterError(f"the project's files cannot be copied: {problem}") from problem
    with _connected(cluster) as client:
        _check_versions(client)
        [there] = client.scatter([archive], broadcast=True)
        digest = sha256(archive).hexdigest()
        futures = [
            client.submit(_play_here, digest, there, _written((play, job), roots), pure=False) for job in jobs
        ]
        try:
            for future in distributed.as_completed(futures, loop=client.loop):
                future.result()
                told()
            found: list[ResultT] = client.gather(futures)
            return found
        except (distributed.scheduler.KilledWorker, distributed.CancelledError, OSError) as problem:
            raise ClusterError(f"the cluster {cluster.address} has lost runs: {problem}") from problem
        finally:
            client.cancel(futures)


def _connected(cluster: Cluster) -> Client:
    import distributed

    try:
        client = distributed.Client(cluster.address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as problem:
        raise ClusterError(f"no scheduler of a Dask cluster answers at {cluster.address}") from problem
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError as problem:
        client.close()
        raise ClusterError(f"the cluster {cluster.address} has no worker") from problem
    return client


def _check_versions(client: Client) -> None:
    """Other versions could give other results."""
    try:
        theirs: dict[str, tuple[str, str]] = client.run(_versions)
    except ImportError as problem:
        raise ClusterError(f"a worker of the cluster does not have this aseme-dsl: {problem}") from problem
    ours = _versions()
    for worker, (program, python) in theirs.items():
        if (program, python) != ours:
            raise ClusterError(
                f"the worker {worker} has aseme-dsl {program} on Python {python}; here are {ours[0]} and"
                f" {ours[1]}"
            )


def _versions() -> tuple[str, str]:
    """The versions of aseme-dsl and Python."""
    from importlib.metadata import version

    return version("aseme-dsl"), ".".join(platform.python_version_tuple()[:2])


# ---- the copies ----------------------------------------------------------------------------------


def _packed(copied: Sequence[Copied]) -> bytes:
    """The files of the folders, as a ZIP archive: they lie to each other as they do here."""
    size = 0
    written = io.BytesIO()
    with zipfile.ZipFile(written, "w", zipfile.ZIP_DEFLATED) as archive:
        for item in copied:
            for path in _files(item.folder, {folder.absolute() for folder in item.without}):
                size += path.stat().st_size
                if size > LARGEST:
                    raise ClusterError(
                        f"{item.folder} has more than {LARGEST // 1_000_000} MB of files, and each worker"
                        " gets a copy: move what the runs do not need out of it"
                    )
                if (name := _below(path)) not in archive.NameToInfo:
                    archive.writestr(zipfile.ZipInfo(name), outside.read_bytes(path))
    return written.getvalue()


def _below(path: Path) -> str:
    return path.relative_to(path.anchor).as_posix()


def _files(folder: Path, without: set[Path]) -> Iterator[Path]:
    """The files of a folder, without hidden ones, environments and what Python has compiled."""
    if not folder.is_dir():
        return
    for path in sorted(folder.absolute().iterdir()):
        if path.name.startswith(".") or path.name == "__pycache__" or path in without:
            continue
        if path.is_dir() and not path.is_symlink() and not (path / "pyvenv.cfg").exists():
            yield from _files(path, without)
        elif path.is_file():
            yield path


class _Writer(pickle.Pickler):
    """Writes a path inside one of the folders so that it can be read as that of a copy."""

    def __init__(self, file: io.BytesIO, roots: Sequence[Path]) -> None:
        super().__init__(file)
        self._roots = roots

    def persistent_id(self, item: object) -> str | None:
        if not isinstance(item, Path):
            return None
        path = item.absolute()
        return _below(path) if any(path.is_relative_to(root) for root in self._roots) else None


class _Reader(pickle.Unpickler):
    """Reads such paths as those in the copies below `here`."""

    def __init__(self, file: io.BytesIO, here: Path) -> None:
        super().__init__(file)
        self._here = here

    def persistent_load(self, written: str) -> Path:
        return self._here / written


def _written(item: object, roots: Sequence[Path]) -> bytes:
    written = io.BytesIO()
    _Writer(written, roots).dump(item)
    return written.getvalue()


# ---- on the worker -------------------------------------------------------------------------------

_ALONE = threading.Lock()
"""A run imports the project's modules: in each process there is one at a time."""


_UNPACKED: dict[str, TemporaryDirectory[str]] = {}
"""The folders of the last archives, by digest."""


def _play_here(digest: str, archive: bytes, job: bytes) -> object:
    """Play one job on a worker, where each archive is unpacked once."""
    with _ALONE:
        if digest not in _UNPACKED:
            while len(_UNPACKED) >= KEPT:
                _UNPACKED.pop(next(iter(_UNPACKED))).cleanup()
            _UNPACKED[digest] = _unpacked(archive)
        play, item = _Reader(io.BytesIO(job), Path(_UNPACKED[digest].name)).load()
        return play(item)


def _unpacked(archive: bytes) -> TemporaryDirectory[str]:
    folder = TemporaryDirectory(prefix="asemec-")
    with zipfile.ZipFile(io.BytesIO(archive)) as files:
        files.extractall(folder.name)
    return folder


__all__ = ["Cluster", "ClusterError", "Copied", "play_there"]
