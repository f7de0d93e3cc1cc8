"""One idea, one name: no class name stands in two modules, no file name says the same of three."""

import ast
from collections import Counter

from tests.architecture.sources import modules


def test_no_two_modules_define_a_class_of_one_name() -> None:
    defined = Counter(
        name
        for tree in modules().values()
        for name in {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    )
    assert {name: count for name, count in defined.items() if count > 1} == {}


def test_no_file_name_stands_more_than_twice() -> None:
    names = Counter(path.name for path in modules() if path.name != "__init__.py")
    assert {name: count for name, count in names.items() if count > 2} == {}
