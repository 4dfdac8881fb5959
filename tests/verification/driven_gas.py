"""Gas that is driven along periodic axes by a mean pressure gradient, given or adjusted so that its flow is held."""
import numpy as np
from gas_relations import BUOYANT, pressure_gradient, settling_slip
from scree_program import EXACT, Checks, Program, centres

program, checks = Program(), Checks("mean pressure gradient and flow of gas along periodic axes")
HEIGHT, MU, CELLS, GRADIENT = 0.02, 1.8e-3, 16, 9.0

# The balances of a uniform channel have the parabola lifted by dy^2/8 as their solution, see T18.
run = program.run("driven_channel.yaml", "poiseuille", {**EXACT, "mean_pressure_gradient": f"-{GRADIENT}, 0"})
y, u = centres(run.fields["y_faces"]), run.fields["gas_velocity_x_face"]
exact = GRADIENT / (2 * MU) * (y * (HEIGHT - y) + (HEIGHT / CELLS) ** 2 / 4)
checks.below("Poiseuille: greatest error of u, relative", np.abs(u / exact[:, None] - 1).max(), 1e-6)
checks.below("Poiseuille: greatest p_g, over the gradient times the length", np.abs(run.fields["gas_pressure"]).max() / (GRADIENT * 0.04), 1e-8)
checks.close("Poiseuille: mean velocity in monitor.csv [m/s]", run.monitor["mean_gas_velocity_x"][-1], exact.mean(), relative=1e-6)
checks.equal("Poiseuille: gradient in monitor.csv [Pa/m]", run.monitor["mean_pressure_gradient_x"][-1], -GRADIENT)

held = program.run("driven_channel.yaml", "held_channel",
                   {**EXACT, "mean_gas_velocity": f"{exact.mean()}, 0", "end_time": 60, "time_step_max": 0.2})
checks.close("Poiseuille, flow held: mean velocity [m/s]", held.monitor["mean_gas_velocity_x"][-1], exact.mean(), relative=1e-9)
checks.close("Poiseuille, flow held: gradient [Pa/m]", held.monitor["mean_pressure_gradient_x"][-1], -GRADIENT, relative=1e-6)

# Through particles held fast: the drop is that of the drag, T9.
for gas in ("incompressible", "darcy"):
    U, nu, d = 0.1, 0.3, 4e-4
    slip = U / (1 - nu)
    gradient = pressure_gradient(nu, slip, d)
    more = {**EXACT, "gas": gas, "solids": "fixed"}
    if gas == "darcy":
        more["gas_darcy_solids_fraction"] = 1e-6
    run = program.run("driven_bed.yaml", f"fixed_{gas}", {**more, "mean_pressure_gradient": f"{-gradient}, 0"})
    checks.close(f"fixed, {gas}: superficial velocity [m/s]", run.monitor["mean_gas_velocity_x"][-1], U, relative=1e-6)
    checks.close(f"fixed, {gas}: across [m/s]", run.monitor["mean_gas_velocity_y"][-1], 0, absolute=1e-9)
    run = program.run("driven_bed.yaml", f"fixed_held_{gas}", {**more, "mean_gas_velocity": f"{U}, 0"})
    checks.close(f"fixed, {gas}, flow held: velocity [m/s]", run.monitor["mean_gas_velocity_x"][-1], U, relative=1e-9)
    checks.close(f"fixed, {gas}, flow held: gradient [Pa/m]", run.monitor["mean_pressure_gradient_x"][-1], -gradient, relative=1e-6)

# A suspension that the gas carries: the drop is the weight, the slip that of settling, and nothing falls freely.
for gas in ("incompressible", "darcy"):
    nu, d, U = 0.3, 4e-4, 0.5
    more = {"gas": gas, "gas_darcy_solids_fraction": 1e-6} if gas == "darcy" else {}
    run = program.run("driven_bed.yaml", f"carried_{gas}", {**EXACT, **more, "mean_gas_velocity": f"0, {U}"})
    monitor, slip = run.monitor, settling_slip(nu, d)
    checks.close(f"carried, {gas}: superficial velocity [m/s]", monitor["mean_gas_velocity_y"][-1], U, relative=1e-9)
    checks.close(f"carried, {gas}: gradient against the weight [Pa/m]", monitor["mean_pressure_gradient_y"][-1], -nu * BUOYANT, relative=1e-6)
    checks.close(f"carried, {gas}: velocity of the particles [m/s]", run.fields["velocity_y_face"].mean(), U / (1 - nu) - slip, relative=1e-6)
    checks.below(f"carried, {gas}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)

# Without it both phases fall: the momentum of both is that of the weight.
run = program.run("driven_bed.yaml", "falls", {**EXACT, "end_time": 0.1})
momentum = 0.3 * 2900 * run.fields["velocity_y_face"].mean() + 0.7 * 1.3 * run.fields["gas_velocity_y_face"].mean()
checks.close("not held: momentum of both phases [kg/(m2 s)]", momentum, -BUOYANT * 0.3 * 0.1, relative=1e-6)

# What holds the flow goes on after a restart.
options = {"mean_gas_velocity": "0, 0.5", "end_time": 0.2, "checkpoint_interval": 0.1}
whole = program.run("driven_bed.yaml", "whole", options)
half = program.run("driven_bed.yaml", "half", {**options, "end_time": 0.1})
rest = program.run("driven_bed.yaml", "rest", {**options, "restart": half.directory})
for column in ("mean_pressure_gradient_y", "mean_gas_velocity_y"):
    checks.equal(f"restart: {column}, bit for bit", rest.monitor[column][-1], whole.monitor[column][-1])

for options, key in (({"mean_pressure_gradient": "0, 5"}, "mean_pressure_gradient"), ({"mean_gas_velocity": "0, 5"}, "mean_gas_velocity")):
    run = program.run("driven_channel.yaml", "wrong", options, must_work=False)
    checks.true(f"{key} along an axis with sides is refused", run.code == 1 and f"{key}" in run.errors and "periodic y" in run.errors, run.errors)
checks.verdict()
