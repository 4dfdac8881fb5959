"""`scree -schema`: all case files of the repository and their effective cases hold against the JSON schema; wrong keys and
values do not, and the program refuses them as well."""
import json
import subprocess
from pathlib import Path

import jsonschema
import yaml

from case_reader import effective_cases
from scree_program import Checks, Program

ROOT = Path(__file__).resolve().parents[2]
#: Additions to small_bin.yaml that neither the schema nor the program takes.
WRONG = [
    "frction: {tau: 1}", "friction: {tua: 1}", "friction_tua: 1", "friction: {tau: -1}", "friction: {tau: 0}",
    "friction: {tau: heavy}", "friction: {tau: nan}", "friction: {tau: yes}", "friction: {model: sticky}",
    "friction: {angle: 28.5}", "particle: {restitution: 1.2}", "solids_fraction_max: 0.8", "dimension: 4",
    "grid_refine: 1.5", "grid_refine: 0", "time_step_adaptive: maybe", "gravity: [0, nan]", "gravity: {x: 0}",
    "boundary: {lid: {side: y_upper, knd: open}}", "boundary: {lid: {side: up, kind: open}}",
    "boundary_lid: {side: y_upper, kind: [open, open]}", "boundary_lid_knd: open", "bondary: {lid: {side: y_upper}}",
    "probe: {p: {point: [here]}}", "plate: {p: {axis: y, position: low}}", "define: 1",
    "grid: {finest: 1 mm, coarsest: 1 cm, growth: 1}", "grid: {finest: small, coarsest: 1 cm}",
    "grid: {finest: 1 mm, coarsest: 0}", "grid: {finst: 1 mm, coarsest: 1 cm}",
    "grid: {finest: 1 mm, coarsest: 1 cm, fine_at: {lip: 1}}", "petsc: 1", "output: {dri: a}",
]
#: Additions that both take, each way to write a key.
RIGHT = [
    "friction: {tau: 1 ms}", "friction_tau: ${t}\ndefine: {t: 1 ms}", "friction: {pressure: {exponent: {r: 2}}}",
    "friction_angle: 28.5 deg", "friction_angle: 0.5", "time: {step: {adaptive: no}}", "time_step_adaptive: off",
    "petsc: {snes_monitor: , ksp: {type: gmres}, anything: 1}", "petsc:", "snes: {rtol: 1e-9}", "ksp_type: gmres",
    "boundary: {top: {gas: {pressure: 1}}}\ngas: darcy", "boundary_top: {gas_pressure: 1}", "boundary_top_gas_pressure: 1",
    "boundary: {my_side: {side: y_upper, kind: open}}", "boundary: {top_until: 1e9}", "initial: {fill: {velocity: '0, 1'}}",
    "gas: {density: 1.2}", "probe: {p: {point: [1 cm, 2 cm], fields: [velocity, solids_fraction]}}",
    "probe: {p: {point: [1 cm, 2 cm], fields: velocity}}", "grid: {refine: 2}",
    "grid: {finest: 1 mm, coarsest: [5 mm, 1 cm], growth: 1.3, fine_at: [openings, fill], fine_x: 2 cm}",
    "grid_finest: 0.001\ngrid_coarsest: 1 cm\ngrid: {fine: {at: floor, y: [1 cm, 2 cm]}}", "granular_temperature: {floor: 0}",
]

program, checks = Program(), Checks("JSON schema of case files")
scree = str(Path(program.scree).resolve())
schema = json.loads(subprocess.run([scree, "-schema"], capture_output=True, text=True, check=True).stdout)
jsonschema.Draft202012Validator.check_schema(schema)
checks.equal("dialect", schema["$schema"], "https://json-schema.org/draft/2020-12/schema")
validator = jsonschema.Draft202012Validator(schema)


def complaints(text):
    return [f"{'.'.join(map(str, error.absolute_path))}: {error.message[:80]}" for error in validator.iter_errors(yaml.safe_load(text))]


# Those of tests/extension are for a program with parts of its own.
files = sorted(path for path in [*ROOT.glob("cases/*/*.yaml"), *ROOT.glob("tests/**/*.yaml")]
               if path.parent.name != "extension")
checks.above("case files", len(files), 50)
for path, (accepted, effective) in zip(files, effective_cases(program, files)):
    text = path.read_text()
    checks.equal(f"{path.relative_to(ROOT)}", complaints(text), [])
    if accepted:
        checks.equal(f"{path.relative_to(ROOT)}, as understood", complaints(effective), [])

base = program.here / "small_bin.yaml"
additions = [*((True, addition) for addition in RIGHT), *((False, addition) for addition in WRONG)]
paths = [program.work / f"case_{index}.yaml" for index in range(len(additions))]
for path, (_, addition) in zip(paths, additions):
    path.write_text(f"based_on: {base}\n{addition}\n")
for path, (expected, addition), (accepted, said) in zip(paths, additions, effective_cases(program, paths)):
    found = complaints(path.read_text())
    what = "right" if expected else "wrong"
    checks.true(f"{what} for the schema: {addition!r}", (not found) == expected, found)
    checks.true(f"{what} for the program: {addition!r}", accepted == expected, said)

table = subprocess.run([scree, "-print_options"], capture_output=True, text=True, check=True).stdout.splitlines()[2:]
keys = [row.split("|")[2].strip().strip("`").replace("<name>_", "") for row in table]
checks.equal("options without a definition in the schema", [key for key in keys if key not in schema["$defs"]], [])
tau = schema["$defs"]["friction_tau"]
checks.equal("default, unit and text of an option", (tau["default"], "[s]" in tau["description"], "relaxation" in tau["description"]),
             (1e-3, True, True))
checks.verdict()
