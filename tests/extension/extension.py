"""A rheology, a drag law, a kind of boundary and a transported scalar from outside of src/ do what they say."""
import json
import subprocess

import jsonschema
import numpy as np
import yaml
from scree_program import Checks, Program

MU_G, DIAMETER, NU = 1.8e-5, 4e-4, 0.5  # Pa s, m, -
PRESSURE, WIDTH, HEIGHT, DEPTH = 80.0, 0.02, 0.04, 0.01  # Pa, m; DEPTH is output_depth
DECAY, DIFFUSIVITY, TIME = 2.0, 1e-4, 0.5  # 1/s, m2/s, s
F, NU_MIN, NU_MAX = 0.05, 0.5, 0.65  # of (18): F in Pa, r = 2, s = 5


def volumes(fields):
    return np.outer(np.diff(fields["y_faces"]), np.diff(fields["x_faces"]))


def check_fixed_bed(program, checks):
    run = program.run("fixed.yaml", "fixed")
    fields = run.fields
    # drag law: (1-nu) grad p = beta w with beta = 18 mu nu/d^2 (1-nu)^-3; the screen lets the gas in at 80 Pa
    beta = 18 * MU_G * NU / DIAMETER**2 * (1 - NU) ** -3
    slip = (1 - NU) * PRESSURE / HEIGHT / beta
    # nu^2 + darcy_solids_fraction^2 stands for nu^2 in the drag: 2e-6 of it
    checks.close("gas through screen and bed [m3/s]", run.monitor["gas_flux_middle"][-1],
                 (1 - NU) * slip * WIDTH * DEPTH, relative=1e-5)
    # tracer: the mean decays, the difference of the halves decays and spreads
    tracer, x = fields["tracer"], 0.5 * (fields["x_faces"][1:] + fields["x_faces"][:-1])
    first = run.first_fields["tracer"]
    checks.close("mean of the tracer at first", first.mean(), 2, absolute=1e-12)
    dt, steps = 1e-3, round(TIME / 1e-3)
    checks.close("mean of the tracer, decayed", tracer.mean(), 2 * (1 + DECAY * dt) ** -steps, relative=1e-6)
    # exact solution of the scheme: modes of the four cells between walls that nothing passes
    cells, width = len(x), x[1] - x[0]
    matrix = np.eye(cells) * 2 - np.eye(cells, k=1) - np.eye(cells, k=-1)
    matrix[0, 0] = matrix[-1, -1] = 1
    step = np.linalg.inv(np.eye(cells) * (1 + DECAY * dt) + DIFFUSIVITY * dt / width**2 * matrix)
    expected = np.linalg.matrix_power(step, steps) @ np.where(x < 0.01, 3.0, 1.0)
    checks.below("tracer against the scheme's own solution, greatest difference",
                 np.abs(tracer - expected[np.newaxis, :]).max(), 1e-4)


def deficit(fields):
    """What the tracer on the particles is short of 2, relative."""
    carried = fields["solids_fraction"] * volumes(fields)
    return 1 - (carried * fields["tracer"]).sum() / (2 * carried.sum())


def check_falling_bed(program, checks):
    coarse = program.run("falling.yaml", "coarse_steps", {"time_step_max": 4e-3})
    run = program.run("falling.yaml", "fine_steps", {"time_step_max": 5e-4})
    fields = run.fields
    nu = fields["solids_fraction"]
    solids = (nu * volumes(fields)).sum()
    brought = 0.2 * 0.2 * 0.2 * WIDTH  # nu v t width [m2]
    checks.close("particles brought in and kept by the screen, volume [m2]", solids, brought, relative=1e-12)
    # The advective form is the conservative one up to the change of nu in a step: a deficit of first order in time.
    checks.below("tracer on them short of 2, steps of 0.5 ms at most, relative", abs(deficit(fields)), 2e-3)
    # steps are adaptive: few of them are as long as they may be
    checks.below("the same over that of steps of 4 ms at most", deficit(fields) / deficit(coarse.fields), 0.5)
    checks.above("greatest nu, of the bed on the screen", nu.max(), NU_MIN)
    where = nu > NU_MIN + 1e-3
    p_c = F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** 5
    checks.below("rheology: p_f = p_c, greatest difference, relative",
                 np.abs(fields["frictional_pressure"][where] / p_c[where] - 1).max(), 1e-10)


def check_schema(program, checks):
    schema = json.loads(subprocess.run([program.scree, "-schema"], capture_output=True, text=True, check=True).stdout)
    for name in ("fixed.yaml", "falling.yaml"):
        case = yaml.safe_load((program.here / name).read_text())
        wrong = [error.message for error in jsonschema.Draft202012Validator(schema).iter_errors(case)]
        checks.equal(f"{name} against the schema of this program", wrong, [])


def check_refusals(program, checks):
    wrong = program.run("fixed.yaml", "wrong_kind", {"boundary_below_kind": "sieve"}, must_work=False)
    checks.true("the list of kinds names the new one", wrong.code != 0 and "screen" in wrong.errors, wrong.errors)
    wrong = program.run("fixed.yaml", "wrong_value", {"initial_bed_tracer": "-1"}, must_work=False)
    checks.true("the new unknown has a range", wrong.code != 0 and "initial_bed_tracer" in wrong.errors, wrong.errors)
    wrong = program.run("fixed.yaml", "wrong_model", {"gas": "none"}, must_work=False)
    checks.true("a model that the program lacks is one line", wrong.code != 0 and "gas darcy" in wrong.errors,
                wrong.errors)


program, checks = Program(), Checks("parts from outside: rheology, drag law, boundary kind, transported scalar")
check_fixed_bed(program, checks)
check_falling_bed(program, checks)
check_schema(program, checks)
check_refusals(program, checks)
checks.verdict()
