"""Formulas: formulas and expressions, from their tokens to trees."""
