"""H16: a layer on an inclined plane, friction of S:S + eps^2 alone. Below atan(sin phi) = 25.5 degrees it rests but for the
creep that eps leaves, which has an exact solution; above it flows. Tau/p is tan(theta) at every depth, so that (20) gives

    D = d v/d y = sqrt(2) eps x/sqrt(1 - x^2),  x = tan(theta)/sin(phi).

Layers are let go cold and warm, from a solids fraction that is not that of equilibrium: they bounce at first. Above some
22 degrees collisions of smooth particles keep alive a flow that a bounce has begun, since their shear stress is a smaller
share of their pressure than that of friction. So 25 degrees is tried with friction between particles."""
import numpy as np
from scree_program import Checks, Program

G, PHI = 9.81, np.radians(28.5)


def gravity(degrees):
    angle = np.radians(degrees)
    return f"{G * np.sin(angle):.9g}, {-G * np.cos(angle):.9g}"


def dense(fields):
    """Heights, speeds down the plane and solids fractions of the cells that are a bed."""
    nu, v = fields["solids_fraction"][:, 0], fields["velocity"][:, 0, 0]
    y = 0.5 * (fields["y_faces"][1:] + fields["y_faces"][:-1])
    return y[nu > 0.5], v[nu > 0.5], nu[nu > 0.5]


def creep(degrees, eps):
    x = np.tan(np.radians(degrees)) / np.sin(PHI)
    return np.sqrt(2) * eps * x / np.sqrt(1 - x**2)


program, checks = Program(), Checks("layers on slopes", "H16")
for start, T in (("cold", 1e-10), ("warm", 1e-4)):
    for angle in (5, 15, 20, 25):
        for eps, share in ((1e-2, 0.1), (1e-3, 0.5)) if start == "cold" and angle < 25 else ((1e-2, 0.1),):
            run = program.run("slopes.yaml", f"{start}_{angle}_{eps}", {
                "gravity": gravity(angle), "friction_strain_rate_floor": eps, "end_time": 4 if angle == 25 else 2,
                "particle_friction": 0.3 if angle == 25 else 0,
                "initial_layer_granular_temperature": T})
            y, v, nu = dense(run.fields)
            checks.close(f"{start}, {angle} degrees, eps {eps:g}/s: shear rate over that of the creep at the end",
                         np.polyfit(y, v, 1)[0] / creep(angle, eps), 1, absolute=share)
            checks.above(f"{start}, {angle} degrees, eps {eps:g}/s: depth of the bed over that at the start",
                         np.sum(nu) / (40 * 0.6), 0.98)
    run = program.run("slopes.yaml", f"{start}_30", {
        "gravity": gravity(30), "friction_strain_rate_floor": 1e-2, "initial_layer_granular_temperature": T, "end_time": 1})
    checks.above(f"{start}, 30 degrees: mean speed at 1 s [m/s]", run.monitor["speed_max_weighted"][-1], 0.25)
checks.verdict()
