"""T11: terminal velocity of thin suspensions, and their mixture law at finite nu: (1-nu) w g rho = drag."""
from gas_relations import check_balances, settling_slip
from scree_program import EXACT, Checks, Program

TABLE = {1e-3: 726.4, 4e-4: 321.24, 1e-4: 61.835}  # d [m]: [cm/s]

program, checks = Program(), Checks("particles that float in rising gas", "T11")
for d, speed in TABLE.items():
    checks.close(f"reference d {d} m, nu -> 0 [cm/s]", settling_slip(1e-12, d) * 100, speed, relative=1e-4)
    for gas, floor in (("incompressible", {}), ("darcy", {"gas_darcy_solids_fraction": 1e-8})):
        for nu in (1e-2, 1e-4) if gas == "incompressible" else (1e-4,):
            name = f"d {d} m, {gas}, nu {nu}"
            flow = (1 - nu) * settling_slip(nu, d)
            run = program.run("terminal_velocity.yaml", f"{gas}_{d}_{nu}",
                              {**EXACT, **floor, "gas": gas, "particle_diameter": d, "boundary_floor_gas_velocity": flow,
                               "initial_everywhere_solids_fraction": nu})
            # 3 m and more from the ends nothing has come from there
            v, found = run.fields["velocity_x_face"][5], run.fields["solids_fraction"][4:6].mean()
            # volume flux of both phases is that of the gas at the inlet
            slip = (flow - v) / (1 - found)
            exact = settling_slip(found, d)
            checks.below(f"{name}: speed left over slip", abs(v) / exact, 1e-3)
            checks.close(f"{name}: slip [m/s]", slip, exact, relative=1e-4)
            if nu == 1e-4:
                checks.close(f"{name}: slip against the table [cm/s]", slip * 100, speed, relative=1e-3)
            check_balances(checks, name, run, gas)
checks.verdict()
