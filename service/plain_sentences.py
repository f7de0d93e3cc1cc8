"""Sentences that only have texts and small numbers put into them, written without Fluent's evaluation.

Fluent evaluates a message with an environment for errors, references, locales and functions: a tenth of a
millisecond, twenty times for a verdict. Most messages need none of these.
"""

from __future__ import annotations

from collections.abc import Mapping

from fluent.syntax import ast

UNGROUPED = 1000
"""Every language writes whole numbers below it with their digits alone."""


def plainly_written(pattern: ast.SyntaxNode, values: Mapping[str, str | int]) -> str | None:
    """Return what Fluent makes of a pattern that it has read; None where only Fluent can tell."""
    parts: list[str] = []
    for element in pattern.elements if isinstance(pattern, ast.Pattern) else (pattern,):
        if isinstance(element, ast.TextElement):
            parts.append(element.value)
            continue
        text = _put_in(element.expression if isinstance(element, ast.Placeable) else element, values)
        if text is None:
            return None
        parts.append(text)
    return "".join(parts)


def _put_in(expression: ast.SyntaxNode, values: Mapping[str, str | int]) -> str | None:
    if isinstance(expression, ast.VariableReference):
        value = values.get(expression.id.name)
        if isinstance(value, str):
            return value
        return str(value) if value is not None and 0 <= value < UNGROUPED else None
    return _chosen(expression, values) if isinstance(expression, ast.SelectExpression) else None


def _chosen(choice: ast.SelectExpression, values: Mapping[str, str | int]) -> str | None:
    """The variant that a text names, or else the usual one; which one a number takes is the language's."""
    if not isinstance(choice.selector, ast.VariableReference):
        return None
    value = values.get(choice.selector.id.name)
    keys = [entry.key.name if isinstance(entry.key, ast.Identifier) else None for entry in choice.variants]
    if not isinstance(value, str) or None in keys:
        return None
    place = keys.index(value) if value in keys else [entry.default for entry in choice.variants].index(True)
    return plainly_written(choice.variants[place].value, values)
