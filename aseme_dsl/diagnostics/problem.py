"""Problem: the facts of a diagnostic as data. Its texts are made from the fields when they are rendered."""

from __future__ import annotations

from inspect import get_annotations
from typing import Any, ClassVar, Literal, NamedTuple, Self, dataclass_transform


class _ByName(NamedTuple):
    """A field that is given by its name only, or left out."""

    default: object


def by_name(*, default: object, kw_only: Literal[True]) -> Any:
    """A field that is given by its name only, or left out: subclasses may have fields without a default."""
    return _ByName(default)


@dataclass_transform(frozen_default=True, field_specifiers=(by_name,))
class Problem:
    """Base class of the problems that a diagnostic can report; the subject, places and so on are its fields.

    A subclass has a `code`, and declares its fields as a dataclass does. It defines `message` (one fact,
    lower case, no full stop) and, if the user can do something, `hint` (one action). Several classes may
    share a code. Only the renderers read these texts; all other code compares the class and its fields.

    This is not a `dataclass`: `asemec` creates hundreds of these classes at each start. A dataclass takes
    0.7 ms to create, this takes 0.01 ms.
    """

    code: ClassVar[str]
    _fields: ClassVar[tuple[str, ...]] = ()
    _named: ClassVar[tuple[str, ...]] = ()

    def __init_subclass__(cls) -> None:
        own = get_annotations(cls)
        fields = [name for name, kind in own.items() if not str(kind).startswith("ClassVar")]
        for name in fields:
            if isinstance(marked := vars(cls).get(name), _ByName):
                setattr(cls, name, marked.default)
                cls._named = (*cls._named, name)
        cls._fields = (*cls._fields, *(name for name in fields if name not in cls._named))

    def __init__(self, *values: object, **named: object) -> None:
        given = dict(zip(self._fields, values, strict=False)) | named
        if len(given) != len(values) + len(named) or not given.keys() <= {*self._fields, *self._named}:
            raise TypeError(f"{type(self).__name__} has the fields {', '.join(self._fields)}")
        for name in self._fields:
            if name not in given and not hasattr(type(self), name):
                raise TypeError(f"{type(self).__name__} needs `{name}`")
        vars(self).update(given)

    @property
    def message(self) -> str:
        """What is wrong, in the words of the file, with names in backquotes."""
        raise NotImplementedError

    @property
    def hint(self) -> str | None:
        """What to do about it."""
        return None

    def but(self, **changes: object) -> Self:
        """The same with other values of some fields."""
        return type(self)(**(vars(self) | changes))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} does not change: `but` makes another one")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Problem) and other._values() == self._values()

    def __hash__(self) -> int:
        return hash(self._values())

    def _values(self) -> tuple[object, ...]:
        return (type(self), *(getattr(self, name) for name in (*self._fields, *self._named)))

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name in (*self._fields, *self._named))
        return f"{type(self).__name__}({fields})"


__all__ = ["Problem", "by_name"]
