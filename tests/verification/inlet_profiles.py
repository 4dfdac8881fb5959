"""Inlets whose velocity varies over the patch and in time: shapes, tables, smooth starts, for grains and gas."""
import numpy as np
from scree_program import EXACT, Checks, Program

program, checks = Program(), Checks("profiles and starts of inlets")
RATE = 2500 * 0.2 * 0.4 * 0.03 * 0.01  # kg/s, of the mean velocity
LOWER, UPPER = 0.01, 0.04


def shape_mean(name, a, b, n=7):
    """Mean of a shape from a to b, by Gauss's rule on both sides of the middle."""
    f = {"parabolic": lambda s: 1.5 * (1 - s**2), "power": lambda s: (1 + 1 / n) * (1 - abs(s)) ** (1 / n)}[name]
    nodes, weights = np.polynomial.legendre.leggauss(60)
    across = lambda x: np.clip((2 * x - LOWER - UPPER) / (UPPER - LOWER), -1, 1)
    cuts = sorted({across(a), across(b), *([0.0] if across(a) < 0 < across(b) else [])})
    total = 0
    for low, high in zip(cuts, cuts[1:]):
        # s = -1 + t^8 near the edge, where the power law has a slope without end
        if name == "power":
            if high <= 0:
                t = np.sort([(1 + low) ** (1 / 8), (1 + high) ** (1 / 8)])
                x = 0.5 * (t[1] - t[0]) * nodes + t.mean()
                total += 0.5 * (t[1] - t[0]) * (weights * f(-1 + x**8) * 8 * x**7).sum()
            else:
                t = np.sort([(1 - low) ** (1 / 8), (1 - high) ** (1 / 8)])
                x = 0.5 * (t[1] - t[0]) * nodes + t.mean()
                total += 0.5 * (t[1] - t[0]) * (weights * f(1 - x**8) * 8 * x**7).sum()
        else:
            x = 0.5 * (high - low) * nodes + 0.5 * (high + low)
            total += 0.5 * (high - low) * (weights * f(x)).sum()
    return total / (across(b) - across(a))


for name in ("parabolic", "power"):
    run = program.run("inlet_profile.yaml", name, {"boundary_feed_profile_shape": name})
    x, top = run.fields["x_faces"], run.fields["velocity_y_face"][-1]
    expected = np.array([-0.4 * shape_mean(name, a, b) if a > LOWER - 1e-9 and b < UPPER + 1e-9 else 0 for a, b in zip(x, x[1:])])
    checks.below(f"{name}: greatest error of the velocity at the faces [m/s]", np.abs(top - expected).max(), 1e-9)
    checks.close(f"{name}: mass at the end, of the mean velocity [kg]", run.monitor["mass"][-1], RATE * 0.03, relative=1e-9)
    checks.below(f"{name}: error of the rate", np.abs(run.monitor["discharge_rate"][1:] / RATE + 1).max(), 1e-9)

run = program.run("inlet_profile.yaml", "table", {"boundary_feed_profile_at": "1 cm, 4 cm", "boundary_feed_profile_factor": "0.5, 1.5"})
x, top = run.fields["x_faces"], run.fields["velocity_y_face"][-1]
centre = (x[1:] + x[:-1]) / 2
expected = np.where((centre > LOWER) & (centre < UPPER), -0.4 * (0.5 + (centre - LOWER) / 0.03), 0)
checks.below("table: greatest error of the velocity at the faces [m/s]", np.abs(top - expected).max(), 1e-12)

# The rate at the end of each step is that of its time; the window begins at 5 ms, the start lasts 10 ms.
options = {"boundary_feed_rise_time": 0.01, "boundary_feed_from": 0.005, "boundary_feed_history_at": "0.02, 0.03",
           "boundary_feed_history_factor": "1, 0.4"}
run = program.run("inlet_profile.yaml", "rise", options)
t = run.monitor["time"][1:]
s = np.clip((t - 0.005) / 0.01, 0, 1)
factor = s**2 * (3 - 2 * s) * np.interp(t, [0.02, 0.03], [1, 0.4])
checks.below("rise: greatest error of the rate, over the full one", np.abs(-run.monitor["discharge_rate"][1:] / RATE - factor).max(), 1e-9)
checks.close("rise: mass error", run.monitor["mass_error"][-1], 0, absolute=1e-12)

# Gas alone through the same patch.
gas = {**EXACT, "gas": "incompressible", "boundary_bottom_kind": "open", "boundary_feed_kind": "gas_inlet", "boundary_feed_gas_velocity": 0.3,
       "boundary_feed_gas_profile_shape": "parabolic", "boundary_feed_gas_rise_time": 0.02, "end_time": 0.03}
run = program.run("inlet_profile.yaml", "gas", gas)
top, x = run.fields["gas_velocity_y_face"][-1], run.fields["x_faces"]
expected = np.array([-0.3 * shape_mean("parabolic", a, b) if a > LOWER - 1e-9 and b < UPPER + 1e-9 else 0 for a, b in zip(x, x[1:])])
checks.below("gas: greatest error of the velocity at the faces [m/s]", np.abs(top - expected).max(), 1e-9)
checks.below("gas: volume error", np.abs(run.monitor["gas_volume_error"]).max(), 1e-12)

for key, value in (("boundary_feed_profile_shape", "round"), ("boundary_feed_rise_time", -1), ("boundary_feed_profile_axis", "y")):
    more = {"boundary_feed_profile_at": "0, 1", "boundary_feed_profile_factor": "1, 1"} if key.endswith("axis") else {}
    run = program.run("inlet_profile.yaml", "wrong", {key: value, **more}, must_work=False)
    checks.true(f"{key} {value} is refused", run.code == 1 and key in run.errors, run.errors)
checks.verdict()
