"""The Python that CCMorse brings along runs in Python 3.9: no syntax and no library of later ones.

Where a python3.9 is installed it imports the builder, too.
"""

import ast
import os
import shutil
import subprocess
import sys
import unittest

from support import PYTHON, SCRIPTS, environment

# What came to the standard library after 3.9, and what might be reached for: names of modules,
# of functions of modules, of methods, and of keywords of functions.
MODULES = {"tomllib", "asyncio.taskgroups"}
OF_MODULES = {
    ("itertools", "pairwise"), ("itertools", "batched"), ("math", "cbrt"), ("math", "exp2"),
    ("math", "sumprod"), ("inspect", "get_annotations"), ("contextlib", "aclosing"),
    ("contextlib", "chdir"), ("enum", "StrEnum"),
    ("sys", "stdlib_module_names"), ("sys", "exception"), ("sys", "orig_argv"), ("types", "NoneType"),
    ("types", "EllipsisType"), ("types", "UnionType"), ("typing", "Self"), ("typing", "TypeAlias"),
    ("typing", "ParamSpec"), ("typing", "override"), ("datetime", "UTC"), ("operator", "call"),
    ("statistics", "correlation"), ("asyncio", "timeout"), ("asyncio", "Runner"),
    ("asyncio", "TaskGroup")}
METHODS = {"bit_count", "hardlink_to", "add_note", "get_identifiers", "is_junction", "walk_up"}
KEYWORDS = {"zip": {"strict"}, "dataclass": {"slots", "kw_only"}, "bisect": {"key"},
            "bisect_left": {"key"}, "bisect_right": {"key"}, "insort": {"key"},
            "TemporaryDirectory": {"ignore_cleanup_errors", "delete"},
            "NamedTemporaryFile": {"delete_on_close"}, "Popen": {"process_group"},
            "extractall": {"filter"}, "rmtree": {"onexc"}, "check_output": {"process_group"}}
BUILTINS = {"aiter", "anext", "EncodingWarning", "BaseExceptionGroup", "ExceptionGroup"}


def too_new(text):
    """What of a program's text is newer than 3.9, as [(line, what)]."""
    try:
        tree = ast.parse(text, feature_version=(3, 9))
    except SyntaxError as error:
        return [(error.lineno, error.msg)]
    found = []
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            names = ([alias.name for alias in node.names] if isinstance(node, ast.Import) else
                     [node.module or ""])
            found += [(node.lineno, name) for name in names if name in MODULES]
            if isinstance(node, ast.ImportFrom):
                found += [(node.lineno, alias.name) for alias in node.names
                          if (node.module, alias.name) in OF_MODULES]
        elif isinstance(node, ast.Attribute):
            of = node.value.id if isinstance(node.value, ast.Name) else None
            if (of, node.attr) in OF_MODULES or node.attr in METHODS:
                found.append((node.lineno, node.attr))
        elif isinstance(node, ast.Name) and node.id in BUILTINS:
            found.append((node.lineno, node.id))
        elif isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", None))
            given = {keyword.arg for keyword in node.keywords}
            found += [(node.lineno, "%s(%s=)" % (name, key))
                      for key in given & KEYWORDS.get(name, set())]
        elif isinstance(node, (ast.arg, ast.AnnAssign)) and node.annotation is not None:
            found += _unions(node.annotation)
        elif isinstance(node, ast.FunctionDef) and node.returns is not None:
            found += _unions(node.returns)
    return found


def _unions(annotation):
    # `int | None` is computed where the function is made, and cannot be before 3.10.
    return [(node.lineno, "a type with |") for node in ast.walk(annotation)
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr)]


def programs():
    for top in (PYTHON, SCRIPTS):
        for folder, _, files in os.walk(top):
            for file in sorted(files):
                if file.endswith(".py"):
                    yield os.path.join(folder, file)


def _has_python39():
    found = shutil.which("python3.9")  # which may be there and start none
    return found is not None and subprocess.run(
        [found, "-c", ""], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        check=False).returncode == 0


class Python39(unittest.TestCase):
    def test_nothing_is_newer_than_3_9(self):
        count = 0
        for path in programs():
            with open(path, encoding="utf-8") as file:
                self.assertEqual(too_new(file.read()), [], path)
            count += 1
        self.assertGreater(count, 50)

    def test_what_is_newer_is_found(self):
        for text in ("match x:\n  case 1: pass", "zip(a, b, strict=True)", "import tomllib",
                     "from itertools import pairwise", "def f(x: int | None): pass",
                     "def f() -> int | None: pass", "try:\n  pass\nexcept* OSError:\n  pass",
                     "(5).bit_count()", "x: int | str = 3", "sys.exception()"):
            self.assertTrue(too_new(text), text)
        self.assertEqual(too_new("if (n := 3) > 2: print(f'{n=}', {**{}} | {}, 'x'.removeprefix)"),
                         [])

    @unittest.skipUnless(_has_python39(), "no python3.9 here")
    def test_python_3_9_itself(self):
        result = subprocess.run(
            ["python3.9", "-B", "-m", "morse.builder.run",
             os.path.join(SCRIPTS, "default_scene.py")], env=environment(),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('"robots"', result.stdout)


if __name__ == "__main__":
    sys.exit(unittest.main())
