"""Terms: z3's numbers and formulas, with Python's arithmetic, and logic that is short where it can be."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

Formula = Any
"""A Python bool or a boolean expression of z3."""


class Terms:
    """Makes the terms of one context of z3."""

    def __init__(self, z3: Any, context: Any) -> None:
        self._z3 = z3
        self._context = context

    def real(self, number: Fraction | int) -> Any:
        """A real number as z3 writes it."""
        return self._z3.RealVal(str(Fraction(number)), self._context)

    def same_sort(self, left: Any, right: Any) -> tuple[Any, Any]:
        """Both as real numbers, if one of them is one."""
        if self.is_whole_number(left) and self._z3.is_real(right):
            return self._z3.ToReal(left), right
        if self.is_whole_number(right) and self._z3.is_real(left):
            return left, self._z3.ToReal(right)
        return left, right

    def is_whole_number(self, value: Any) -> bool:
        """Whether a term is an integer of z3."""
        return bool(self._z3.is_int(value))

    def equal(self, left: object, right: object) -> Any:
        """When two terms are equal."""
        left, right = self.same_sort(left, right)
        return left == right

    def compared(self, operator: str, left: Any, right: Any) -> Any:
        """When a comparison holds."""
        left, right = self.same_sort(self.boolean(left), self.boolean(right))
        match operator:
            case "==":
                return left == right
            case "!=":
                return left != right
            case "<":
                return left < right
            case "<=":
                return left <= right
            case ">":
                return left > right
        return left >= right

    def boolean(self, value: Any) -> Any:
        """A bool of Python as a term."""
        return self._z3.BoolVal(value, self._context) if isinstance(value, bool) else value

    def built_in(self, name: str, arguments: list[Any]) -> Any:
        """The result of a built-in function of the language."""
        if name == "abs":
            (value,) = arguments
            return self._z3.If(value >= 0, value, -value)
        left, right = self.same_sort(*arguments)
        return self._z3.If(left <= right if name == "min" else left >= right, left, right)

    def chosen(self, test: Any, yes: Any, no: Any) -> Any:
        """One of two values."""
        if isinstance(test, bool):
            return yes if test else no
        yes, no = self.same_sort(self.boolean(yes), self.boolean(no))
        return self._z3.If(test, yes, no)

    def to_real(self, value: Any) -> Any:
        """A term as a real number."""
        return self._z3.ToReal(value) if self.is_whole_number(value) else value

    def floor_division(self, left: Any, right: Any) -> Any:
        """Python's `//`: z3 rounds down only for positive divisors."""
        return self._z3.If(right > 0, left / right, (-left) / (-right))

    def modulo(self, left: Any, right: Any) -> Any:
        """Python's `%`: of the divisor's sign."""
        if self.is_whole_number(left) and self.is_whole_number(right):
            return self._z3.If(right > 0, left % right, -((-left) % (-right)))
        left, right = self.to_real(left), self.to_real(right)
        return left - right * self._z3.ToReal(self._z3.ToInt(left / right))

    # ---- logic that is short where it can be ----------------------------------------------------

    def not_(self, part: Formula) -> Formula:
        """Negation."""
        return (not part) if isinstance(part, bool) else self._z3.Not(part)

    def and_(self, *parts: Formula) -> Formula:
        """Conjunction."""
        found = [part for part in parts if part is not True]
        if any(part is False for part in found):
            return False
        return True if not found else found[0] if len(found) == 1 else self._z3.And(found)

    def or_(self, *parts: Formula) -> Formula:
        """Disjunction."""
        found = [part for part in parts if part is not False]
        if any(part is True for part in found):
            return True
        return False if not found else found[0] if len(found) == 1 else self._z3.Or(found)

    def implies(self, condition: Formula, consequence: Formula) -> Formula:
        """Implication."""
        return self.or_(self.not_(condition), consequence)


__all__ = ["Formula", "Terms"]
