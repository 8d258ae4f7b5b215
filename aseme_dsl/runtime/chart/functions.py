"""Functions: those of the document, which are Python functions, found by `module:name`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib import import_module

TYPES: dict[str, tuple[type, ...]] = {
    "bool": (bool,),
    "int": (int,),
    "double": (int, float),
    "string": (str,),
    "bytes": (bytes,),
    "duration": (int,),
}
"""The Python types of the types that are built into the language; a bool is not a number."""


class FunctionError(Exception):
    """A function of the document cannot be found, or gives something else than it declares."""


def is_of_library(target: str) -> bool:
    """Whether the function `module:name` comes with this package."""
    return target.startswith("aseme_dsl.runtime.library.")


def find_function(target: str) -> Callable[..., object]:
    """The Python function `module:name`.

    Raises:
        FunctionError: there is no such module or function.
    """
    module, _, name = target.partition(":")
    try:
        function = getattr(import_module(module), name)
    except (ImportError, AttributeError) as error:
        raise FunctionError(f"no function {name} in module {module}: {error}") from error
    if not callable(function):
        raise FunctionError(f"{target} is not a function")
    return function  # type: ignore[no-any-return]


def function_errors(plan: str, functions: Iterable[tuple[str, str, str, str]]) -> list[str]:
    """Why functions of a plan cannot be called, each `(name, "module:name", result, place)`."""
    errors: list[str] = []
    for name, target, _, at in functions:
        try:
            find_function(target)
        except FunctionError as problem:
            errors.append(f"{plan}: {at}: E541: the function {name}: {problem}")
        except Exception as problem:  # its module raises when it is imported
            module = target.partition(":")[0]
            text = f"module {module} cannot be imported: {type(problem).__name__}: {problem}"
            errors.append(f"{plan}: {at}: E541: the function {name}: {text}")
    return errors


def results_of(declared: str) -> tuple[type, ...]:
    """The Python types of a declared result; anything for a message or an enum."""
    return TYPES.get(declared, (object,))


def checked(name: str, value: object, expected: tuple[type, ...]) -> object:
    """What a function has given, if it is of the expected types.

    Raises:
        FunctionError: it is not.
    """
    if not isinstance(value, expected) or (isinstance(value, bool) and bool not in expected):
        raise FunctionError(f"{name} gave {value!r}, which is not a {expected[-1].__name__}")
    return value


def function_at(target: str, name: str, declared: str) -> Callable[..., object]:
    """The function `module:name`, which is looked for at the first call, and whose results are checked."""
    found: list[Callable[..., object]] = []
    expected = results_of(declared)

    def call(*arguments: object) -> object:
        if not found:
            found.append(find_function(target))
        return checked(name, found[0](*arguments), expected)

    call.called = name  # type: ignore[attr-defined]
    return call


__all__ = [
    "TYPES",
    "FunctionError",
    "checked",
    "find_function",
    "function_at",
    "function_errors",
    "results_of",
]
