"""Run the code cells of notebooks and store what they show.

Usage: python tools/notebooks.py docs/notebooks/*.ipynb

The cells run in this process, one namespace for each notebook; of the last expression of a cell the text,
the HTML and the LaTeX are kept, as Jupyter does. So a test can hold the stored
outputs without a Jupyter server.
"""

import ast
import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

_REPRESENTATIONS = {"text/html": "_repr_html_", "text/latex": "_repr_latex_"}


def executed(notebook: dict[str, Any]) -> dict[str, Any]:
    """The notebook with the outputs that its code cells have now."""
    namespace: dict[str, Any] = {"__name__": "__main__"}
    cells, count = [], 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            count += 1
            outputs = _outputs("".join(cell["source"]), namespace, count)
            cell = {**cell, "execution_count": count, "outputs": outputs}
        cells.append(cell)
    return {**notebook, "cells": cells}


def written(notebook: dict[str, Any]) -> str:
    """The notebook as its file stands."""
    return json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def _outputs(source: str, namespace: dict[str, Any], count: int) -> list[dict[str, Any]]:
    body = ast.parse(source).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), f"cell {count}", "exec"), namespace)  # noqa: S102 - our own cells
        shown = None
        if last is not None:
            code = compile(ast.Expression(last.value), f"cell {count}", "eval")
            shown = eval(code, namespace)  # noqa: S307
    found: list[dict[str, Any]] = []
    if printed.getvalue():
        lines = printed.getvalue().splitlines(keepends=True)
        found.append({"name": "stdout", "output_type": "stream", "text": lines})
    if shown is not None:
        found.append(_result(shown, count))
    return found


def _result(shown: object, count: int) -> dict[str, Any]:
    data = {"text/plain": repr(shown)}
    for kind, method in _REPRESENTATIONS.items():
        show = getattr(shown, method, None)
        text = show() if show else None
        if text:
            data[kind] = text
    lines = {kind: text.splitlines(keepends=True) for kind, text in data.items()}
    return {"data": lines, "execution_count": count, "metadata": {}, "output_type": "execute_result"}


def main(paths: list[str]) -> None:
    """Run notebooks and store their outputs."""
    for path in map(Path, paths):
        notebook = json.loads(path.read_text(encoding="utf-8"))
        path.write_text(written(executed(notebook)), encoding="utf-8")
        print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
