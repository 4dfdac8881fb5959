"""Wrong input: one line on stderr, from one rank, that names key, value and expectation; exit code not zero; nothing written."""
import os
import shutil

from scree_program import Checks, Program

CASE = "small_bin.yaml"
#: what: options, words that the line must have
OPTIONS = {
    "unknown key": ({"friction_tua": "1e-3"}, ["friction_tua", "1e-3", "friction_tau"]),
    "unknown attribute": ({"boundary_wall_speed": 1}, ["boundary_wall_speed", "known key"]),
    "bad unit": ({"friction_tau": "1 cm"}, ["friction_tau", "1 cm", "in s", "dimension"]),
    "no number": ({"particle_density": "heavy"}, ["particle_density", "heavy", "kg/m3"]),
    "out of range": ({"particle_restitution": 1.2}, ["particle_restitution", "1.2", "(0, 1]"]),
    "not positive": ({"friction_tau": -1}, ["friction_tau", "-1", "> 0"]),
    "above nu_max": ({"initial_fill_solids_fraction": 0.7}, ["initial_fill_solids_fraction", "0.7", "0.65"]),
    "bad choice": ({"friction_model": "sticky"}, ["friction_model", "sticky", "relaxed"]),
    "bad list": ({"gravity": "0"}, ["gravity", "0", "2 numbers"]),
    "plate off the grid": ({"plate_floor_position": "1.1 cm"}, ["plate_floor_position", "0.011", "grid plane"]),
    "finest above coarsest": ({"grid_finest": "2 cm", "grid_coarsest": "1 cm"}, ["grid_finest", "0.02 m", "grid_coarsest = 0.01 m"]),
    "finest alone": ({"grid_finest": "1 mm"}, ["grid_coarsest", "required"]),
    "unknown place to refine": ({"grid_finest": "1 mm", "grid_coarsest": "1 cm", "grid_fine_at": "lip"},
                                ["grid_fine_at", "lip", "openings", "floor", "orifice"]),
    "planes closer than the finest": ({"grid_finest": "1 mm", "grid_coarsest": "1 cm", "grid_fine_x": "1.02 cm"},
                                      ["grid_finest", "0.001 m", "0.01 m and 0.0102 m along x", "such as"]),
    "plate outside": ({"plate_floor_position": "0"}, ["plate_floor_position", "inside"]),
    "side not covered": ({"boundary_wall_patch": "2 cm, 9 cm"}, ["x_upper", "cover"]),
    "periodic side with a segment": ({"periodic": "x"}, ["boundary_", "periodic"]),
    "missing required": ({"boundary_more_kind": "open"}, ["boundary_more_side", "required"]),
    "inlet without its solids": ({"boundary_top_kind": "inlet"}, ["boundary_top_solids_fraction", "required"]),
    "probe outside": ({"probe_a_point": "1, 1"}, ["probe_a_point", "1", "box"]),
    "equilibrium without friction": ({"friction_model": "none", "initial_fill_profile": "equilibrium",
                                      "initial_fill_surface": "7 cm"}, ["initial_fill_profile", "equilibrium", "friction_model"]),
    "equilibrium without a surface": ({"initial_fill_profile": "equilibrium"}, ["initial_fill_surface", "required"]),
    "first step above the greatest": ({"time_step_initial": 1, "time_step_max": 0.5}, ["time_step_initial", "1", "time_step_max"]),
    "missing table": ({"initial_fill_table": "no/such/table"}, ["initial_fill_table", "no/such/table"]),
    "wrong window": ({"boundary_top_from": 1, "boundary_top_until": 0.5}, ["boundary_top_until", "0.5", "boundary_top_from"]),
    "missing restart": ({"restart": "no/such/run"}, ["no/such/run", "exist"]),
    "unknown field of a probe": ({"probe_a_point": "1 cm, 2 cm", "probe_a_fields": "solids_fracton"},
                                 ["probe_a_fields", "solids_fracton", "velocity_x"]),
    "unknown field of a line at -check": ({"line_a_from": "1 cm, 2 cm", "line_a_to": "1 cm, 3 cm", "line_a_fields": "gas_pressure",
                                           "check": None}, ["line_a_fields", "gas_pressure", "solids_fraction"]),
}
BOX = """dimension: 2
extent: "4 cm, 8 cm"
grid_cells: "4, 8"
gravity: "0, -9.81"
end_time: 0.02 s
boundary:
  left:  {side: x_lower, kind: wall_johnson_jackson}
  right: {side: x_upper, kind: wall_johnson_jackson}
  floor: {side: y_lower, kind: wall_johnson_jackson}
"""
TOP = "  top:   {side: y_upper, kind: open}\n"
FILL = """initial:
  everywhere: {order: 0, solids_fraction: 0, granular_temperature: 1e-4}
  fill: {order: 1, box: "0, 4 cm, 0, 4 cm", solids_fraction: 0.58}
"""
#: what: text of a case file, words that the line must have; FILE stands for its name
FILES = {
    "tab": (BOX + TOP + FILL + "particle:\n\tdensity: 2500\n\tdiameter: 1 mm\n", ["FILE:15:", "blanks", "tab"]),
    "open brace": (BOX + "  top: {side: y_upper, kind: open\n" + FILL, ["FILE:11:", "'}'"]),
    "bad YAML": ("grid: {x_edges: [0, 1\n  - nonsense: : :\n", ["FILE:2:", "YAML"]),
    "open quote": (BOX + TOP + FILL + "output_dir: \"out\n", ["FILE:14:13", "quote"]),
    "UTF-16": ((BOX + TOP + FILL).encode("utf-16"), ["FILE:1:1", "UTF-8"]),
    "initial region twice": (BOX + TOP + FILL + '  fill: {box: "4 cm, 6 cm, 0, 4 cm", solids_fraction: 0.3}\n',
                             ["FILE:14:3", "initial_fill", "once", "line 13"]),
    "segment twice": (BOX + TOP + "  floor: {side: y_lower, kind: open}\n" + FILL, ["FILE:11:3", "boundary_floor", "line 9"]),
    "key twice": (BOX + TOP + FILL + "end_time: 1 s\n", ["FILE:14:1", "end_time", "line 5"]),
    "key twice, nested and flat": (BOX + TOP + FILL + "initial_fill_order: 2\n", ["FILE:14", "initial_fill_order", "FILE:13"]),
    "wrong value in a file": (BOX + TOP + FILL + "friction:\n  tau: 1 cm\n", ["FILE:15", "friction_tau", "1 cm", "in s"]),
    "pocket": (BOX + TOP + """  lid:   {side: y_upper, kind: wall_free_slip, patch: "2 cm, 4 cm", order: 1}
  blow:  {side: y_lower, kind: gas_inlet, gas_velocity: 0.1, patch: "2 cm, 4 cm", order: 1}
plate: {middle: {axis: x, position: 2 cm}}
gas: incompressible
""", ["FILE:12", "boundary_blow_gas_velocity", "open side", "plates"]),
}

program, checks = Program(), Checks("wrong input")


def complain(what, case, options, words, directory=None):
    """One run that must fail with one line."""
    if program.ranks > 1 and what not in ON_RANKS:
        return
    directory = directory or program.work / what.replace(" ", "_")
    before = sorted(directory.rglob("*")) if directory.is_dir() else None
    run = program.run(case, "", {"output_dir": directory, **options}, must_work=False, timeout=240)
    ours = [line for line in run.errors.splitlines() if "scree:" in line]
    noise = [line for line in run.errors.splitlines() if "PETSC ERROR" in line or "terminate called" in line]
    if program.ranks == 1:
        noise = [line for line in run.errors.splitlines() if line not in ours]
    line = ours[0] if ours else ""
    missing = [word for word in words if word not in line]
    after = sorted(directory.rglob("*")) if directory.is_dir() else None
    checks.true(f"{what}: '{line}'", len(ours) == 1 and not noise and not missing and run.code > 0 and before == after,
                f"lines {len(ours)}, noise {noise[:2]}, missing {missing}, exit {run.code}, written {before != after}")


#: On several ranks: one of each way on which the program comes to know.
ON_RANKS = ("unknown key", "plate off the grid", "missing table", "missing restart", "unknown field of a probe",
            "unknown field of a line at -check", "tab", "pocket", "output directory cannot be made", "existing run",
            "restart with another grid", "truncated checkpoint", "no HDF5 file")


for what, (options, words) in OPTIONS.items():
    complain(what, CASE, options, words)
for kind, place in (("probe", {"probe_a_point": "1 cm, 2 cm"}), ("line", {"line_a_from": "0, 0", "line_a_to": "0, 9 cm"})):
    for check in ({}, {"check": None}):
        complain(f"{kind} of a field that is not there{' under -check' if check else ''}", CASE,
                 {**place, f"{kind}_a_fields": "gas_pressure", **check}, [f"{kind}_a_fields", "gas_pressure", "solids_fraction"])

for what, (text, words) in FILES.items():
    path = program.work / f"{what.replace(' ', '_').replace(',', '')}.yaml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    complain(what, path, {}, [word.replace("FILE", path.name) for word in words])
complain("missing case file", program.work / "none.yaml", {}, ["none.yaml", "readable"])
complain("no case file", None, {}, ["case file"])
complain("missing file of overrides", CASE, {"options_file_yaml": program.work / "none.yaml"}, ["none.yaml", "readable"])

odd = program.work / "odd.yaml"
odd.write_text(BOX + TOP + FILL + "particle: {diameter: 0.5}\n")
said = program.run(odd, "odd", {"check": None}, ranks=1).log.splitlines()
checks.true("a particle as large as the box gets a remark", said[0].startswith("# particle_diameter = 0.5 m is odd"), said[0])
os.environ["PETSC_OPTIONS"] = "-friction_tau 1"
complain("an option of ours where PETSc looks", CASE, {}, ["friction_tau", "PETSC_OPTIONS"])
del os.environ["PETSC_OPTIONS"]

tiny = {"grid_x_cells": "1, 3", "grid_y_cells": "1, 8", "end_time": 1e-4}
(program.work / "a_file").write_text("in the way\n")
complain("output directory is a file", CASE, tiny, ["a_file"], program.work / "a_file")
complain("output directory cannot be made", CASE, tiny, ["a_file/out"], program.work / "a_file" / "out")
done = program.run(CASE, "done", tiny)
complain("existing run", CASE, tiny, ["done", "already"], done.directory)

remarks = [line for line in program.run(CASE, "misspelt", {**tiny, "snes_atoll": 1, "snes_atol": 1e-6}, ranks=1).log.splitlines() if "not used" in line]
checks.equal("remarks on PETSc's options", remarks, ["snes_atoll is not used: PETSc has not asked for it"])

later = {**tiny, "end_time": 2e-4}
complain("restart with another grid", CASE, {**later, "grid_y_cells": "1, 9", "restart": done.directory},
         ["is of another case", "cells along y"])
complain("restart with another model", CASE, {**later, "friction_model": "critical_state", "restart": done.directory},
         ["is of another case"])
complain("end_time before the restart", CASE, {**tiny, "end_time": 5e-5, "restart": done.directory}, ["end_time"])
broken = program.work / "broken"
shutil.copytree(done.directory / "checkpoints", broken)
file = sorted(broken.glob("*.h5"))[-1]
file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
complain("truncated checkpoint", CASE, {**later, "restart": broken}, ["cannot be used"])
foreign = program.work / "foreign"
foreign.mkdir()
shutil.copy(sorted((done.directory / "fields").glob("*.h5"))[-1], foreign / "00000001.h5")
complain("foreign HDF5 file", CASE, {**later, "restart": foreign}, ["not a checkpoint of Scree"])
(foreign / "00000001.h5").write_text("no HDF5\n")
complain("no HDF5 file", CASE, {**later, "restart": foreign}, ["not an HDF5 file"])
checks.verdict()
