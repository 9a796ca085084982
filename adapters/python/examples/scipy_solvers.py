# SPDX-License-Identifier: BSD-3-Clause
"""What SciPy's solvers are worth on a problem: the error of each against its truth, at one tolerance, by its evaluations."""
from scipy.integrate import solve_ivp

import odeum


def brusselator(t, y):
    x, z = y
    return [1 + x**2 * z - 4 * x, 3 * x - x**2 * z]


problem = odeum.problem(brusselator, [1.5, 3.0], (0, 20))
for method in ("RK23", "RK45", "DOP853", "Radau", "BDF", "LSODA"):
    solution = solve_ivp(brusselator, (0, 20), [1.5, 3.0], method=method, rtol=1e-6, atol=1e-6)
    judged = odeum.judge(problem, solution)
    print(f"{method:7} {solution.nfev:6} evaluations, error {judged.error:.1e}, likeliest {judged.likeliest or 'not known'}")
    # The worst, BDF, has a thousand tolerances of 1e-6 at the steep flanks of the solution.
    assert judged.error < 1e-2, judged
    if method == "RK45":
        assert judged.likeliest == "dormand_prince54", judged

of_odeum = odeum.run(problem, solver=["dormand_prince54", "cvode/bdf"], tol=1e-6).rows
for row in of_odeum:
    print(f"{row['library']}/{row['solver']}: {row['rhs_evaluations']:.0f} evaluations, error {row['error_max']:.1e}")
