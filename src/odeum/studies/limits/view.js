// SPDX-License-Identifier: BSD-3-Clause
// Rows `steps_judged`: those of largest_steps.csv that were run, with `agreement` between the
// measured and the predicted step, its `colour`, `any` where a run was bounded at the largest step
// that was tried, a quarter of the window, and the eigenvalue as a text.
'use strict';
(() => {
  const { addRows, functions, number, rowsOf } = odeum;

  // The search ends within 0.5 % or one step of the window; a spectrum that moves does the rest.
  const allowed = 1.05;
  functions.step_agreement = () => allowed - 1;

  addRows('steps_judged', async () => {
    const colours = {
      'as predicted': 'confirmed', larger: 'higher', smaller: 'lower', 'no theory': '',
      'not bounded': 'failed',
    };
    const agreementOf = (row, any) => {
      if (row.status !== 'ok') return 'not bounded';
      if (Number.isNaN(row.predicted_step)) return 'no theory';
      if (row.largest_stable_step > allowed * row.predicted_step) return 'larger';
      return !any && row.largest_stable_step * allowed < row.predicted_step
        ? 'smaller'
        : 'as predicted';
    };
    const eigenvalueOf = ({ eigenvalue_re: re, eigenvalue_im: im }, imaginary) => {
      if (Number.isNaN(re)) return '–';
      if (im === 0) return number(re);
      return `${imaginary ? '' : `${number(re)} `}± ${number(Math.abs(im))}i`;
    };
    return (await rowsOf('largest_steps'))
      .objects()
      .filter((row) => row.status !== 'not_applicable')
      .map((row) => {
        const any = row.status === 'ok' && row.largest_stable_step > 0.249 * row.window,
          agreement = agreementOf(row, any),
          size = Math.hypot(row.eigenvalue_re, row.eigenvalue_im);
        // A real part that rounding left is none.
        const imaginary = row.eigenvalue_im !== 0 && Math.abs(row.eigenvalue_re) <= 1e-7 * size;
        return {
          ...row, any: any ? 'yes' : 'no', agreement, colour: colours[agreement], size,
          kind: row.eigenvalue_im === 0 ? 'real' : imaginary ? 'imaginary' : 'complex',
          eigenvalue: eigenvalueOf(row, imaginary),
        };
      });
  });
})();
