"""H3: stiff p_c. At given steps Newton's iterations grow less than twofold, whether the fill starts at rest or, at nu = .6
with p_c = 1.6e6 Pa and more, as a spring that throws its surface off; steps are many times those of the wave."""
import numpy as np
from scree_program import Checks, Program

RHO_S, NU_MIN, NU_MAX, DX = 2900.0, 0.5, 0.65, 8e-2 / 24
MATERIALS = {"p_c of Table 2": (0.05, 5), "F x 1000": (50, 5), "s = 8": (0.05, 8), "F / 1e9": (5e-11, 5)}


def wave_speed(nu, F, s):
    return np.sqrt(F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** s * (2 / (nu - NU_MIN) + s / (NU_MAX - nu)) / RHO_S)


def bin_of(program, name, material, options):
    F, s = MATERIALS[material]
    return program.run("stiff.yaml", name.replace(" ", "_").replace("/", "by"),
                       {"solver": "direct", "friction_pressure_constant": F, "friction_pressure_exponent_s": s, **options})


def newton(run):
    return run.summary["newton_iterations"] / run.summary["steps"]


program, checks = Program(), Checks("p_c a thousand times stiffer, s = 8, and packed to nu_max", "H3")
UNIFORM = {"initial_fill_profile": "uniform", "initial_fill_solids_fraction": 0.6, "end_time": 0.04}
for start, options, materials in (
        ("at rest, dt 0.2 ms", {"time_step_initial": 2e-4, "end_time": 0.015}, MATERIALS),
        ("at rest, dt 1 ms", {"end_time": 0.04}, MATERIALS),
        ("nu = 0.6, dt 0.2 ms", {**UNIFORM, "time_step_initial": 2e-4}, ["p_c of Table 2", "F x 1000", "s = 8"])):
    soft = None
    for material in materials:
        name = f"{start}, {material}"
        run = bin_of(program, f"{start}_{material}", material, options)
        soft = soft or run
        monitor = run.monitor
        checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), NU_MAX - 1e-9)
        checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
        checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
        checks.below(f"{name}: Newton iterations a step over those of Table 2", newton(run) / newton(soft), 2)
        checks.below(f"{name}: steps over those of Table 2", run.summary["steps"] / soft.summary["steps"], 2)
        F, s = MATERIALS[material]
        c = wave_speed(run.first_fields["solids_fraction"].max(), F, s)
        dt = np.median(monitor["dt"][1:])
        if material != "p_c of Table 2" and start != "at rest, dt 0.2 ms":
            checks.above(f"{name}: median step over that of the wave, dx/c = {DX / c:.1e} s", dt / (DX / c), 1)
            checks.hard_case("H3", f"small bin, {material}, {start}", run,
                             measured=f"Newton a step {newton(run):.2f} against {newton(soft):.2f}; median step "
                                      f"{dt / (DX / c):.0f} dx/c",
                             bound="< 2x; dt not tied to the wave", without=f"explicit step: dx/c = {DX / c:.1e} s")
checks.verdict()
