"""Plates that come, go and slide: what they close, when, and that steps end at these times."""
import numpy as np
from scree_program import Checks, Program

program, checks = Program(), Checks("plates that come, go and slide")
ROW = 6  # of the faces in the plane of the gate
NOTHING = 1e-9  # of a velocity that a linear solver finds [m/s]


def passes(monitor, time):
    """Whether a step ends at that time."""
    return bool(np.abs(monitor["time"] - time).min() <= 1e-12)


run = program.run("moving_plate.yaml", "opens", {"plate_gate_until": 0.0123})
monitor = run.monitor
checks.true("opens: a step ends then", passes(monitor, 0.0123))
checks.equal("opens: flux before", float(np.abs(monitor["flux_gate"][monitor["time"] <= 0.0123 - 1e-9]).max()), 0.0)
checks.above("opens: mass that has come through [kg]", np.trapz(monitor["flux_gate"], monitor["time"]), 1e-3)
checks.below("opens: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)

run = program.run("moving_plate.yaml", "closes", {"plate_gate_from": 0.02})
monitor = run.monitor
checks.true("closes: a step ends then", passes(monitor, 0.02))
checks.above("closes: least flux between the first steps and then [kg/s]", monitor["flux_gate"][(monitor["time"] > 2e-3) & (monitor["time"] < 0.02)].min(), 1e-3)
checks.equal("closes: flux after", float(np.abs(monitor["flux_gate"][monitor["time"] > 0.02 + 1e-9]).max()), 0.0)

# Drawn out to the right with 1 m/s from 5 ms on: face i is open from when the end passes its centre.
drawn = {"plate_gate_slide_speed": 1, "plate_gate_slide_from": 0.005, "plate_gate_span": "0, 4 cm",
         "solver": "direct"}  # orderings of ILU tell left from right
run = program.run("moving_plate.yaml", "drawn", drawn)
centres = 0.0025 + 0.005 * np.arange(8)
opens = 0.005 + centres
checks.equal("drawn out: steps end when faces open", [passes(run.monitor, t) for t in opens if t < 0.05], [True] * 8)
for fields in run.all_fields():
    time, v = fields["time"], fields["velocity_y_face"][ROW]
    closed = opens > time + 1e-9
    checks.below(f"drawn out, {time:g} s: velocity at closed faces [m/s]", np.abs(v[closed]).max(initial=0.0), NOTHING)
    if np.any(opens < time - 1e-3):
        checks.below(f"drawn out, {time:g} s: greatest velocity at open faces [m/s]", v[opens < time - 1e-3].max(), -5e-3)
checks.below("drawn out: mass error", np.abs(run.monitor["mass_error"]).max(), 1e-12)

# The same gate seen in a mirror; and pushed in until it has closed half of the box, then it stays.
left = program.run("moving_plate.yaml", "drawn_left", {**drawn, "plate_gate_slide_speed": -1})
for fields, mirrored in zip(run.all_fields(), left.all_fields()):
    if fields["time"] < 0.031:  # later Newton's method ends on one side of a bend or the other, by rounding
        checks.below(f"drawn out to the left, {fields['time']:g} s: greatest difference of nu in the mirror",
                     np.abs(mirrored["solids_fraction"][:, ::-1] - fields["solids_fraction"]).max(), 1e-12)
run = program.run("moving_plate.yaml", "pushed", {"plate_gate_slide_speed": 2, "plate_gate_span": "-4 cm, 0", "plate_gate_slide_until": 0.01})
v = run.fields["velocity_y_face"][ROW]
checks.below("pushed in: velocity at closed faces [m/s]", np.abs(v[:4]).max(), NOTHING)
checks.below("pushed in: greatest velocity at open faces [m/s]", v[4:].max(), -0.05)

# What slides drags the grains along, a hole moves with its plate.
hole = program.run("moving_plate.yaml", "hole", {"plate_gate_kind": "wall_no_slip", "plate_gate_openings": "0, 1 cm", "plate_gate_span": "-4 cm, 4 cm",
                                                  "plate_gate_slide_speed": 1, "plate_gate_slide_until": 0.02, "end_time": 0.02})
checks.above("hole: greatest velocity of the grains on the plate along it [m/s]", hole.all_fields()[-2]["velocity_x_face"][ROW].max(), 0.01)
v = hole.fields["velocity_y_face"][ROW]
checks.below("hole: velocity at closed faces [m/s]", np.abs(v[[0, 1, 2, 3, 6, 7]]).max(), NOTHING)

# With gas, whose volume is kept where faces open.
run = program.run("moving_plate.yaml", "gas", {**drawn, "gas": "incompressible", "end_time": 0.02})
checks.below("with gas: gas volume error", np.abs(run.monitor["gas_volume_error"]).max(), 1e-12)
checks.below("with gas: mass error", np.abs(run.monitor["mass_error"]).max(), 1e-12)

# A run that is restarted between two events is as it was.
whole = program.run("moving_plate.yaml", "whole", {**drawn, "checkpoint_interval": 0.016, "end_time": 0.03})
half = program.run("moving_plate.yaml", "half", {**drawn, "checkpoint_interval": 0.016, "end_time": 0.016})
rest = program.run("moving_plate.yaml", "rest", {**drawn, "checkpoint_interval": 0.016, "end_time": 0.03, "restart": half.directory})
checks.equal("restart: nu at the end, bit for bit", bool(np.array_equal(rest.fields["solids_fraction"], whole.fields["solids_fraction"])), True)

for options, key in (({"plate_gate_from": 2, "plate_gate_until": 1}, "plate_gate_until"),
                     ({"plate_gate_slide_speed": 1, "plate_gate_slide_axis": "y"}, "plate_gate_slide_axis"),
                     ({"plate_gate_slide_speed": 1, "plate_gate_slide_until": -1}, "plate_gate_slide_until"),
                     ({"gas": "incompressible", "boundary_bottom_kind": "gas_inlet", "boundary_bottom_gas_velocity": 0.1, "plate_gate_from": 0.01},
                      "boundary_bottom_gas_velocity")):
    run = program.run("moving_plate.yaml", "wrong", options, must_work=False)
    checks.true(f"{options} is refused", run.code == 1 and key in run.errors, run.errors)
checks.verdict()
