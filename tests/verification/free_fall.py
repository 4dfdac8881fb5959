"""T14, free fall: the steady jet below an inlet, with both schemes of advection and their orders; a falling slab."""
import numpy as np
from scree_program import COLUMN, DIRECT, EXACT, Checks, Program, centres, norm

V0, NU0, G = 0.6, 0.52, 9.81
TABLE = {0.5: .460972, 1: .418349, 2: .359692, 5: .269426}  # h [cm]: nu


def speed(h):
    return np.sqrt(V0**2 + 2 * G * h)


program, checks = Program(), Checks("free fall", "T14")
for h, nu in TABLE.items():
    checks.close(f"reference nu at {h} cm", NU0 * V0 / speed(h / 100), nu, absolute=1e-6)
# At an inlet both schemes take the prescribed values without a slope, which van_albada pays with a first-order shift of the
# whole jet by half a cell of acceleration; the order of van_albada is taken from 1 cm below the inlet on, and up to
# 1 cm above the open side, whose control volume of half a cell is of first order.
for scheme, order, bound in (("upwind", 1, 1e-3), ("van_albada", 2, 1e-4)):
    errors = {"nu": [], "v": []}
    for cells in (60, 120, 240):
        last = program.run("falling_jet.yaml", f"{scheme}_{cells}", {**EXACT, **COLUMN, "advection": scheme, "grid_cells": cells}).fields
        h, h_face = 0.06 - centres(last["x_faces"]), 0.06 - last["x_faces"]
        nu, v = last["solids_fraction"], -last["velocity_x_face"]
        margin = cells // 6 if scheme == "van_albada" else 0
        start, part = cells - margin, slice(margin, cells - margin)
        squared = v[start] ** 2 + 2 * G * (h_face - h_face[start])
        errors["v"].append(norm(np.sqrt(squared[part]) - v[part]))
        errors["nu"].append(norm((nu - NU0 * V0 / np.sqrt(0.5 * (squared[1:] + squared[:-1])))[part]))
    checks.order(f"{scheme}: L2 error of nu on 60, 120, 240 cells", errors["nu"], order, bound)
    checks.order(f"{scheme}: L2 error of v on 60, 120, 240 cells [m/s]", errors["v"], order, 2 * bound)
    for place, exact in TABLE.items():
        found = np.interp(place / 100, h[::-1], nu[::-1])
        checks.close(f"{scheme}: nu at {place} cm, 240 cells", found, exact, absolute=1.5e-3)

for scheme in ("upwind", "van_albada"):
    run = program.run("falling_slab.yaml", f"slab_{scheme}", {**DIRECT, **COLUMN, "advection": scheme})
    last, first = run.fields, run.first_fields
    x, nu, t = centres(last["x_faces"]), last["solids_fraction"], last["time"]
    fall = np.sum(x * first["solids_fraction"]) / np.sum(first["solids_fraction"]) - np.sum(x * nu) / np.sum(nu)
    checks.close(f"slab, {scheme}: fall of its centre [m]", fall, G * t**2 / 2, relative=2e-2)
    checks.below(f"slab, {scheme}: mass error", np.abs(run.monitor["mass_error"]).max() / run.monitor["mass"][0], 1e-12)
    checks.above(f"slab, {scheme}: least nu ever", run.monitor["solids_fraction_min"].min(), -1e-9)
    checks.below(f"slab, {scheme}: greatest nu ever", run.monitor["solids_fraction_max"].max(), 0.5 + 1e-3)
    # momentum of all faces, each with the mass that its balance gives it: the mean of its two cells
    nu_face, v = 0.5 * (nu[1:] + nu[:-1]), last["velocity_x_face"][1:-1]
    checks.close(f"slab, {scheme}: mean velocity [m/s]", np.sum(nu_face * v) / np.sum(nu_face), -G * t,
                 relative=2e-4)  # the front crosses a cell a step, and some of it leaves
checks.verdict()
