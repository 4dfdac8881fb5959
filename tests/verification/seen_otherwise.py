"""T20, invariances: the same scene mirrored, turned, in other units, on other numbers of ranks and from a moving frame
has the same answer."""
import numpy as np
from scree_program import COLUMN, EXACT, Checks, Program, norm

CASE = "seen_otherwise.yaml"
SCALARS = ("solids_fraction", "granular_temperature", "frictional_pressure_ratio", "gas_pressure")
VECTORS = ("velocity", "gas_velocity")
OTHER = {"x": "y", "y": "x"}
#: Each rank factors all of the matrix: what is looked at is the program, and MUMPS on several ranks waits much.
ON_EACH = {"pc_type": "redundant"}


def components(fields):
    """The unknowns: (name, axis or None) -> array over [y, x]."""
    result = {(name, None): fields[name] for name in SCALARS if name in fields}
    result.update({(name, a): fields[f"{name}_{a}_face"] for name in VECTORS for a in "xy" if f"{name}_{a}_face" in fields})
    return result


def difference(a, b):
    """Greatest difference of two states over the greatest value of each unknown; a vector counts as one."""
    size = {}
    for (name, _), value in a.items():
        size[name] = max(size.get(name, 0), np.abs(value).max())
    return max(np.abs(value - b[key]).max() / size[key[0]] for key, value in a.items())


def mirrored(state):
    return {(name, a): (-1 if a == "x" else 1) * value[:, ::-1] for (name, a), value in state.items()}


def turned(state):
    """x and y exchanged."""
    return {(name, a and OTHER[a]): value.T for (name, a), value in state.items()}


program, checks = Program(), Checks("one scene seen otherwise: gas, friction, T, walls, plate", "T20")
run = program.run(CASE, "itself", EXACT, ranks=1)
scene = components(run.fields)
checks.above("the scene itself moves: greatest v_y [m/s]", np.abs(run.fields["velocity_y_face"]).max(), 0.1)
checks.above("and its left and right are not alike", difference(mirrored(scene), scene), 0.1)

mirror = {"gravity": "-1, -9.81", "boundary_jet_patch": "2 cm, 3 cm", "boundary_wall_side": "x_upper",
          "boundary_stick_side": "x_lower", "plate_shelf_openings": "1.5 cm, 4 cm",
          "initial_heap_box": "2.5 cm, 4 cm, 3 cm, 5 cm", "initial_heap_velocity": "-0.1, -0.2"}
other = program.run(CASE, "mirrored", {**EXACT, **mirror})
checks.below("mirrored, relative", difference(scene, mirrored(components(other.fields))), 1e-10)

turn = {"grid_cells": "12, 8", "extent": "6 cm, 4 cm", "gravity": "-9.81, 1", "boundary_floor_side": "x_lower",
        "boundary_jet_side": "x_lower", "boundary_wall_side": "y_lower", "boundary_wall_velocity": "0.1, 0",
        "boundary_stick_side": "y_upper", "boundary_top_side": "x_upper", "plate_shelf_axis": "x",
        "initial_bed_box": "0, 4 cm, 0, 4 cm", "initial_heap_box": "3 cm, 5 cm, 0, 1.5 cm",
        "initial_heap_velocity": "-0.2, 0.1"}
other = program.run(CASE, "turned", {**EXACT, **turn})
checks.below("x and y exchanged, relative", difference(scene, turned(components(other.fields))), 1e-10)

for ranks in (2, 3):
    other = program.run(CASE, f"ranks_{ranks}", {**EXACT, **ON_EACH}, ranks=ranks)
    checks.below(f"{ranks} ranks, relative", difference(scene, components(other.fields)), 1e-10)

# The same numbers with units: what is read is the same but for rounding.
units = {"extent": "40 mm, 0.06 m", "end_time": "5 ms", "gravity": "100 cm/s^2, -981 cm/s^2",
         "friction_tau": "1 ms", "particle_density": "2.9 g/cm^3", "particle_diameter": "1000 um",
         "gas_density": "1.3e-3 g/cm^3", "gas_viscosity": "1.8e-4 poise", "friction_pressure_constant": "0.5 dyn/cm^2",
         "friction_angle": "0.49741883681838395 rad",
         "boundary_jet_gas_velocity": "80 cm/s", "boundary_wall_velocity": "0, 10 cm/s",
         "initial_everywhere_granular_temperature": "1 cm^2/s^2", "initial_heap_velocity": "10 cm/s, -20 cm/s",
         "wall_slip_regularisation": "3 mm/s", "void_drag_time": "10 ms", "time_step_initial": "100 us"}
other = program.run(CASE, "units", {**EXACT, **units})
checks.below("in cgs and other units, relative", difference(scene, components(other.fields)), 1e-10)

# Another system of units altogether: numbers of cgs. With gas one number has a unit in the code, 1e-5 m/s, the limit of
# 1/sqrt(T) in (1.8).
CM, G = 100, 1000  # [1/m], [1/kg]
cgs = {"extent": "4, 6", "gravity": "100, -981", "particle_density": 2.9, "particle_diameter": 0.1,
       "friction_pressure_constant": 0.5, "boundary_jet_patch": "1, 2", "boundary_wall_velocity": "0, 10",
       "plate_shelf_position": 2, "plate_shelf_openings": "0, 2.5", "initial_everywhere_granular_temperature": 1,
       "initial_bed_box": "0, 4, 0, 4", "initial_heap_box": "0, 1.5, 3, 5", "initial_heap_velocity": "10, -20",
       "granular_temperature_floor": 1e-10, "wall_slip_regularisation": 0.3}
gas = {"gas_density": 1.3e-3, "gas_viscosity": 1.8e-4, "boundary_jet_gas_velocity": 80}
factor = {"solids_fraction": 1, "granular_temperature": CM**2, "frictional_pressure_ratio": 1, "gas_pressure": G / CM,
          "velocity": CM, "gas_velocity": CM}
vacuum = {"gas": "none", "gas_viscous_stress": "no", "boundary_jet_kind": "wall_free_slip",
          "boundary_jet_gas_velocity": 0, "boundary_stick_gas_wall": "free_slip"}
for name, here, there, bound in (("without gas", vacuum, {**cgs, **vacuum}, 1e-10),
                                 ("with gas", {}, {**cgs, **gas}, 1e-6)):
    one = components(program.run(CASE, f"si_{name}".replace(" ", "_"), {**EXACT, **here}).fields) if here else scene
    other = components(program.run(CASE, f"cgs_{name}".replace(" ", "_"), {**EXACT, **there}).fields)
    other = {key: value / factor[key[0]] for key, value in other.items()}
    checks.below(f"in the numbers of cgs, {name}, relative", difference(one, other), bound)

# From a moving frame. Along y nothing varies, and the speed that way is not felt; along x the wave is carried over the
# cells, which costs what advection errs: the difference falls with the order of the scheme.
LENGTH, WAY, END = 0.04, 0.01, 5e-3
wave = program.work / "wave.txt"
x = np.linspace(0, LENGTH, 4097)
np.savetxt(wave, np.column_stack([x, 0.55 + 0.03 * np.sin(2 * np.pi * x / LENGTH)]), fmt="%.17g")

# On two ranks what the scene does not have: periodic axes, a single axis, a bed with its surface.
carried = {"initial_everywhere_table": wave, "initial_everywhere_velocity": "2, 0.3", "initial_everywhere_gas_velocity": "2, 0.3"}
let_down = {"granular_temperature": "transport", "initial_fill_granular_temperature": 1e-4, "initial_fill_profile": "uniform",
            "initial_fill_solids_fraction": 0.6, "end_time": 5e-3, "time_step_initial": 1e-4}
for name, case, options in (("periodic box", "moving_frame.yaml", carried), ("column let down", "column_at_rest.yaml", let_down)):
    one, two = (components(program.run(case, f"{name}_{ranks}".replace(" ", "_"), {**EXACT, **ON_EACH, **options},
                                       ranks=ranks).fields) for ranks in (1, 2))
    checks.above(f"{name} moves: greatest v_x [m/s]", np.abs(one["velocity", "x"]).max(), 0.1)
    checks.below(f"{name} on 2 ranks, relative", difference(one, two), 1e-10)


def seen(name, cells, speed, **more):
    """From a frame that moves with -speed, steps in proportion to the cells."""
    text = ", ".join(str(component) for component in speed)
    line = {"dimension": 1, "periodic": "x", "extent": LENGTH, "grid_cells": cells, **COLUMN} if len(speed) == 1 else {}
    fields = program.run("moving_frame.yaml", name, {**EXACT, **line, "initial_everywhere_table": wave,
                         "initial_everywhere_velocity": text, "initial_everywhere_gas_velocity": text,
                         "time_step_initial": 2 * END / cells, **more}).fields
    state = {(name, None): fields[name] for name in SCALARS}
    for axis, component in zip("xy", speed):
        state.update({(name, axis): fields[f"{name}_{axis}_face"] - component for name in VECTORS})
    # the last face along x is the first one
    way = round(speed[0] * END / LENGTH * cells)
    return {key: np.roll(value[..., :cells], -way, axis=-1) for key, value in state.items()}


checks.below("from a frame that moves where nothing varies, relative",
             difference(seen("still", 32, (0, 0)), seen("along_y", 32, (0, WAY / END))), 1e-10)
for scheme, order, bound, grids in (("upwind", 1, 5e-2, (64, 128, 256)), ("van_albada", 2, 5e-3, (32, 64, 128))):
    errors = {}
    for cells in grids:
        still = seen(f"still_{scheme}_{cells}", cells, (0,), advection=scheme)
        moving = seen(f"along_x_{scheme}_{cells}", cells, (WAY / END,), advection=scheme)
        for key, value in still.items():
            errors.setdefault(key[0], []).append(norm(value - moving[key]) / np.abs(value).max())
    for name, found in errors.items():
        checks.order(f"from a moving frame, {scheme}: L2 difference of {name} on {', '.join(map(str, grids))} "
                     "cells, over its maximum", found, order, bound)
checks.verdict()
