#!/usr/bin/env python3
"""Checks the layout: #include lines respect the arrows between the rooms, and the top level holds what was agreed.

Usage: check_includes.py [SOURCE_DIRECTORY]     (default: the checkout that this file is in)
"""
import fnmatch
import re
import subprocess
import sys
from pathlib import Path

# room: the rooms that it may include, besides itself
MAY_INCLUDE = {
    "math": set(),
    "closures": {"math"},
    "grid": {"math"},
    "boundary": {"math", "closures", "grid"},
    "assembly": {"math", "closures", "grid", "boundary"},
    "balances": {"math", "closures", "grid", "boundary", "assembly"},
    "kernels": {"math", "closures", "grid", "boundary", "assembly", "balances"},
    "model": {"math", "closures", "grid", "boundary", "assembly", "balances", "kernels"},
    "stepping": {"math", "closures", "grid", "boundary", "assembly", "balances", "model"},
    "config": {"math", "closures", "grid", "boundary", "assembly", "balances", "stepping"},
    "output": {"math", "grid"},
}
MAY_INCLUDE["app"] = set(MAY_INCLUDE)
WITHOUT_PETSC = {"math", "closures"}
PETSC = re.compile(r"petsc|slepc|mpi\.h$|hdf5")
TOP_LEVEL = {"CMakeLists.txt", "src", "include", "cases", "tests", "scripts", "docker", "README.md", "LICENSE"}
UNTRACKED = ("build*", "out")

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def complaint(room, header):
    """What is wrong with this include in this room, or None."""
    if room in WITHOUT_PETSC and PETSC.match(header):
        return "no PETSc, MPI or HDF5 in this room"
    if header.startswith(".."):
        return 'write "scree/<room>/<file>"'
    parts = header.split("/")
    if parts[0] != "scree":
        return None
    included = parts[1] if len(parts) > 2 else None
    if included not in MAY_INCLUDE:
        return "unknown room"
    if included != room and included not in MAY_INCLUDE[room]:
        return f"may include only: {', '.join(sorted(MAY_INCLUDE[room])) or 'nothing'}"
    return None


def check_rooms(root):
    for base in (root / "include/scree", root / "src"):
        for path in sorted(p for p in base.rglob("*") if p.suffix in (".hpp", ".cpp", ".h", ".ipp")):
            room = path.relative_to(base).parts[0]
            if room not in MAY_INCLUDE:
                yield f"{path.relative_to(root)}: not in a room"
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                problem = match and complaint(room, match.group(1))
                if problem:
                    yield f"{path.relative_to(root)}:{number}: {room} includes {match.group(1)}: {problem}"


def check_top_level(root):
    """Of the tracked files; of all files where this is no git checkout."""
    try:
        git = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True)
        names = {line.split("/")[0] for line in git.stdout.splitlines()}
    except (OSError, subprocess.CalledProcessError):
        names = {p.name for p in root.iterdir() if not any(fnmatch.fnmatch(p.name, u) for u in UNTRACKED)}
    for name in sorted(names - TOP_LEVEL):
        if not name.startswith("."):
            yield f"{name}: does not belong to the top level ({', '.join(sorted(TOP_LEVEL))})"


def main():
    if sys.argv[1:2] in (["-h"], ["--help"]):
        print(__doc__)
        return 0
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
    problems = [*check_rooms(root), *check_top_level(root)]
    print("\n".join(problems) or "Includes and top level are in order.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
