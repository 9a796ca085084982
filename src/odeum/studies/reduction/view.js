// SPDX-License-Identifier: BSD-3-Clause
// Rows `reduction_solvers`: a solver each, with the most that its order lacks of the claimed one at
// any stiffness, and whether it gives a usable error where the problem is stiff (λ ≤ −10⁴, where hλ
// is large at every step).
'use strict';
(() => {
  const { addRows, rowsOf, idOf } = odeum;

  addRows('reduction_solvers', async () => {
    const rows = (await rowsOf('order_reduction'))
      .objects()
      .filter((row) => row.verdict !== 'not_applicable');
    return [...d3.group(rows, idOf)].map(([solver, some]) => ({
      solver, usable: some.some((row) => row.lambda <= -1e4 && row.error_finest < 1) ? 'yes' : 'no',
      lost: d3.max(some, (row) => row.claimed_order - row.measured_order) ?? NaN,
    }));
  });
})();
