"""What scripts and tests take from each other's modules is there: imports, and attributes of imported modules. Read
from the source, so that a script which only long runs reach is looked at too."""
import ast
import functools
import importlib.util
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "scripts"
NOT_NEEDED = {"paraview"}  # where it is missing, a script of its own is of no use
SHARED = (SCRIPTS, SCRIPTS / "paper", ROOT / "tests" / "support")  # where imports are looked for besides their folder


@functools.lru_cache(maxsize=None)
def tree_of(path):
    return ast.parse(path.read_text(), str(path))


def module_file(name, folders):
    """The source of a module of the repository; None where it is none of ours."""
    for folder in folders:
        stem = folder.joinpath(*name.split("."))
        for path in (stem.with_suffix(".py"), stem / "__init__.py"):
            if path.exists():
                return path
    return None


def bound(node):
    """The names that a module or a function binds, without those of functions in it."""
    names = set()
    if isinstance(node, (ast.FunctionDef, ast.Lambda)):
        names.update(argument.arg for argument in ast.walk(node.args) if isinstance(argument, ast.arg))
    for child in inside(node):
        if isinstance(child, (ast.FunctionDef, ast.ClassDef)):
            names.add(child.name)
        elif isinstance(child, (ast.Import, ast.ImportFrom)):
            names.update((alias.asname or alias.name).split(".")[0] for alias in child.names)
        elif isinstance(child, ast.Name) and isinstance(child.ctx, ast.Store):
            names.add(child.id)
    return names


def inside(node):
    """What stands in a module or function, without the bodies of functions and classes in it."""
    for child in ast.iter_child_nodes(node):
        yield child
        if not isinstance(child, (ast.FunctionDef, ast.Lambda, ast.ClassDef)):
            yield from inside(child)


@functools.lru_cache(maxsize=None)
def offers(path, name):
    """Whether a module has a name: its own, a submodule, or one that the package loads when asked (HOMES)."""
    tree = tree_of(path)
    if name in bound(tree) or name.startswith("__"):
        return True
    if path.name != "__init__.py":
        return False
    late = {key.value for node in ast.walk(tree) if isinstance(node, ast.Dict) for key in node.keys
            if isinstance(key, ast.Constant)}
    return name in late or (path.parent / f"{name}.py").exists()


def is_installed(module):
    package = module.split(".")[0]
    return package in NOT_NEEDED or importlib.util.find_spec(package) is not None


def problems(path):
    """What a file names that is not there, as `line: text`."""
    folders = (path.parent, *SHARED)
    tree, modules = tree_of(path), {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                source = module_file(alias.name, folders)
                if source:
                    modules[alias.asname or alias.name] = source
                elif not is_installed(alias.name):
                    yield f"{node.lineno}: no module {alias.name}"
        elif isinstance(node, ast.ImportFrom) and not node.level:
            source = module_file(node.module, folders)
            if not source:
                if not is_installed(node.module):
                    yield f"{node.lineno}: no module {node.module}"
                continue
            for alias in node.names:
                submodule = module_file(f"{node.module}.{alias.name}", folders)
                if submodule:
                    modules[alias.asname or alias.name] = submodule
                elif not offers(source, alias.name):
                    yield f"{node.lineno}: no {node.module}.{alias.name}"
    yield from attribute_problems(tree, modules)


def attribute_problems(node, modules):
    for child in ast.iter_child_nodes(node):
        known = modules
        if isinstance(child, (ast.FunctionDef, ast.Lambda)):
            imported = {alias.asname or alias.name for part in ast.walk(child)
                        if isinstance(part, (ast.Import, ast.ImportFrom)) for alias in part.names}
            local = bound(child) - imported  # a variable that hides a module
            known = {name: source for name, source in modules.items() if name not in local}
        if isinstance(child, ast.Attribute) and isinstance(child.value, ast.Name) and child.value.id in known:
            if not offers(known[child.value.id], child.attr):
                yield f"{child.lineno}: no {child.value.id}.{child.attr}"
        yield from attribute_problems(child, known)


class Names(unittest.TestCase):
    def test_scripts_and_tests_name_what_is_there(self):
        files = [path for folder in (SCRIPTS, ROOT / "tests") for path in sorted(folder.rglob("*.py"))]
        self.assertGreater(len(files), 50)
        found = [f"{path.relative_to(ROOT)}:{problem}" for path in files for problem in problems(path)]
        self.assertEqual(found, [])

    def test_commands_without_an_extension_too(self):
        for command in SCRIPTS.glob("scree-*"):
            self.assertEqual(list(problems(command)), [], command.name)

    def test_what_is_not_there_is_found(self):
        faults = {
            "import scree_output": "1: no module scree_output",
            "from scree import nothing": "1: no scree.nothing",
            "from scree import output\noutput.field_at(1)": "2: no output.field_at",
            "from scree import output as o\ndef f(x):\n    return o.field_at(x)": "3: no o.field_at",
            "import scree\nscree.close": "2: no scree.close",
            "from scree import output\ndef f(output):\n    return output.parent": "",
            "import scree\nscree.open, scree.sweep": "",
        }
        with tempfile.TemporaryDirectory() as folder:
            for number, (text, expected) in enumerate(faults.items()):
                path = Path(folder) / f"made_up_{number}.py"
                path.write_text(text + "\n")
                self.assertEqual(list(problems(path)), [expected] if expected else [], text)


if __name__ == "__main__":
    unittest.main()
