// SPDX-License-Identifier: BSD-3-Clause
// Rows `proof_methods`: those of proofs.csv, with the orders and estimates of a method on the test
// problems as texts.
'use strict';
(() => {
  const { addRows, rowsOf, number } = odeum;

  addRows('proof_methods', async () => {
    const [methods, orders, estimates] = await Promise.all(
      ['proofs', 'proof_orders', 'proof_estimates'].map((name) =>
        rowsOf(name).then((rows) => d3.group(rows.objects(), (row) => row.solver)),
      ),
    );
    return [...methods].map(([solver, [row]]) => {
      const own = orders.get(solver) || [], estimated = estimates.get(solver) || [],
        ratios = estimated.map((each) => each.ratio_to_true_error);
      return {
        ...row, library: 'odeum',
        measured:
          own
            .map(
              (each) => `${number(each.measured_order)}${each.verdict === 'confirmed' ? '' : '*'}`,
            )
            .join(' ') || 'by cases',
        measured_tip:
          own.map((each) => `${each.test_problem}: ${each.verdict}`).join('; ') || row.needs,
        unconfirmed: own.filter((each) => each.verdict !== 'confirmed').length,
        estimate: estimated.length
          ? `${number(d3.min(ratios), 2)}–${number(d3.max(ratios), 2)}` +
            (row.estimates_well === 'yes' ? '' : ' ⚠')
          : '–',
        estimate_tip: estimated
          .map(
            (each) =>
              `${each.test_problem}: h^${each.measured_exponent.toFixed(2)} for ` +
              `h^${number(each.expected_exponent)}, ratio ${number(each.ratio_to_true_error, 2)}`,
          )
          .join('; '),
      };
    });
  });
})();
