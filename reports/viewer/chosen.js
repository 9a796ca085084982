// SPDX-License-Identifier: BSD-3-Clause
// What the comparison draws: curves of chosen solvers on a case.
'use strict';
(() => {
  const {
    idOf, facts, sameError, colourOf, shapeOf, number, settingText, duration, plural, shorten,
    statusText, functions, frontOf,
  } = odeum;

  const horizontal = {
    step: ['step', (run) => run.step],
    evaluations: ['evaluations of f', (run) => run.rhs_evaluations],
    time: ['time of a solve', (run) => run.wall_ns_min],
    steps: ['steps', (run) => run.steps],
    tolerance: ['tolerance', (run) => (run.mode === 'adaptive' ? run.setting : NaN)],
  };
  const vertical = {
    error: ['largest error, absolute', (run) => run.error_max],
    rms: ['error, root mean square', (run) => run.error_rms],
    energy: ['error of the energy, relative', (run) => run.energy_error],
  };

  // Runs by "library/solver:mode"; those of the timed study where the time is asked for.
  const runsOf = (data, x) => {
    const groups = new Map();
    const add = (key, run) => {
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(run);
    };
    if (x === 'time')
      for (const run of data.timed) {
        const mode = run.setting_kind === 'tol' ? 'adaptive' : 'fixed';
        add(`${idOf(run)}:${mode}`, {
          ...run, mode, timed: true, error_max: run.error,
          step: mode === 'fixed' ? run.setting : NaN,
        });
      }
    else for (const run of data.runs) add(`${idOf(run)}:${run.mode}`, run);
    return groups;
  };

  // The solvers shown at first: the fastest of each library at the middle error and own ones at the
  // others; without times, those of fewest evaluations.
  const sensible = (id, data) => {
    const key = (row) => `${idOf(row)}:${row.setting_kind === 'tol' ? 'adaptive' : 'fixed'}`;
    const rows = facts.fastest.filter((row) => row.case === id);
    // A library that does not reach the middle error has the row that is fastest at the smallest
    // error it reaches.
    const reached = (row) =>
      sameError(row.error, 1e-6) ||
      (row.error > 1e-6 &&
        !rows.some((other) => other.library === row.library && other.error < 0.5 * row.error));
    const picked = rows
      .filter(
        (row) =>
          reached(row) ||
          (row.library === 'odeum' && (sameError(row.error, 1e-3) || sameError(row.error, 1e-9))),
      )
      .map(key);
    if (picked.length) return [...new Set(picked)];
    const least = new Map();
    for (const run of data.runs)
      if (
        run.error_max <= 1e-6 * Math.max(1, facts.caseOf.get(id).scale) &&
        !(least.get(run.library)?.rhs_evaluations <= run.rhs_evaluations)
      )
        least.set(run.library, run);
    const found = [...least.values()].map((run) => `${idOf(run)}:${run.mode}`);
    return found.length
      ? found
      : [...runsOf(data, 'step').keys()].filter((k) => k.startsWith('odeum/')).slice(0, 6);
  };
  // The solvers on the Pareto front of time and error; of evaluations and error without times.
  const front = (data) => {
    const timed = data.timed.filter((run) => run.repetitions > 0 && run.error >= 0);
    const best = timed.length
      ? frontOf(timed, 'wall_ns_min', 'error')
      : frontOf(data.runs.filter((run) => run.error_max > 0), 'rhs_evaluations', 'error_max');
    const modeOf = (row) => row.mode || (row.setting_kind === 'tol' ? 'adaptive' : 'fixed');
    return [...new Set(best.map((row) => `${idOf(row)}:${modeOf(row)}`))];
  };

  const verdictOf = (data, key) => data.orders.find((row) => `${idOf(row)}:${row.mode}` === key);
  const curveOf = (c, data, key, x, y, more) => {
    const [id, mode] = key.split(':'), solver = facts.solverOf.get(id),
      runs = runsOf(data, x).get(key) || [];
    const order = verdictOf(data, key);
    const points = runs
      .map((run) => ({
        x: horizontal[x][1](run), y: vertical[y][1](run), run: { ...run, case: c.id },
      }))
      .filter((p) => p.x > 0 && p.y > 0 && p.y <= 100 * c.scale);
    return {
      key, name: `${id}${mode === 'fixed' && solver?.adaptive ? ' (fixed step)' : ''}${more}`,
      colour: colourOf(id.split('/')[0]), shape: shapeOf(solver),
      dashed: mode === 'adaptive' && x !== 'time' && x !== 'tolerance', points, runs, order,
      window:
        x === 'step' && order && order.step_coarsest > 0
          ? [order.step_finest, order.step_coarsest]
          : null,
    };
  };

  // Colour means library and shape family: curves that share both are told apart by full and hollow
  // marks and by the lightness of their colour.
  const toldApart = (curves) => {
    const lightness = [
      (c) => c, (c) => `color-mix(in oklab, ${c} 55%, var(--ink))`,
      (c) => `color-mix(in oklab, ${c} 65%, var(--paper))`,
    ];
    const counts = new Map();
    return curves.map((curve) => {
      const key = `${curve.colour} ${curve.shape}`, k = counts.get(key) || 0;
      counts.set(key, k + 1);
      const colour = lightness[Math.floor(k / 2) % lightness.length](curve.colour);
      return { ...curve, colour, filled: k % 2 === 1 };
    });
  };

  const orderText = (order) =>
    !order
      ? ''
      : Number.isFinite(order.measured_order)
        ? `order ${order.measured_order.toFixed(2)} (claimed ${number(order.claimed_order)}): ` +
          `${order.verdict}`
        : order.no_order === 'unstable'
          ? 'unstable at the steps tried.' +
            functions.needed_step(order.case, order.library, order.solver, order.step_finest)
          : `${order.verdict}${order.reason ? `: ${order.reason}` : ''}`;
  const tellRun = (run, curve) =>
    [
      idOf(run), `${settingText(run)}: error ${number(run.error_max)}`,
      [
        run.timed ? duration(run.wall_ns_min) : '', plural(run.rhs_evaluations, 'evaluation'),
        plural(run.steps, 'step'),
      ]
        .filter(Boolean)
        .join(', '),
      shorten(statusText(run, facts.caseOf.get(run.case).scale), 110),
      curve ? shorten(orderText(curve.order), 110) : '',
    ].filter(Boolean);

  Object.assign(odeum, {
    horizontal, vertical, runsOf, sensible, front, curveOf, toldApart, orderText, tellRun,
  });
})();
