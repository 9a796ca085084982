// SPDX-License-Identifier: BSD-3-Clause
// Rows `drift_series`: a run's error of one quantity, in one row: how it began and ended, the worst
// on the way, the power of the time with which it grows; `chosen` for the quantity that stands for
// a case, its energy where that is kept, else the first; `mark`, `colour` and `tip` of its cell.
'use strict';
(() => {
  const {
    addRows, rowsOf, number, idOf, blocks, checkKeys, facts, emptyText, html, legendOf, linkOf,
    plot, rangeOf,
  } = odeum;

  addRows('drift_series', async () => {
    const rows = await rowsOf('drift'), of = (name) => rows.column(name);
    if (!rows.length) return [];
    const [cases, libraries, solvers, quantities, times, errors, values] = [
      'case', 'library', 'solver', 'invariant', 'time', 'relative_error', 'value',
    ].map(of);
    const rounding = 1e-11;
    // The largest error of the last decade of time over that of the decade before.
    const powerOf = (from, to) => {
      const end = d3.max(d3.range(from, to), (i) => times[i]);
      let before = 0, now = 0;
      for (let i = from; i < to; ++i) {
        if (Number.isNaN(errors[i])) continue;
        if (times[i] > end / 10) now = Math.max(now, errors[i]);
        else if (times[i] > end / 100) before = Math.max(before, errors[i]);
      }
      return before === 0 ? (now === 0 ? 0 : NaN) : Math.log10(now / before);
    };
    const series = [];
    for (let from = 0, to; from < rows.length; from = to) {
      for (
        to = from + 1;
        to < rows.length &&
        [cases, libraries, solvers, quantities].every((column) => column[to] === column[from]);
      )
        to += 1;
      const last = to - 1, status = of('status')[last],
        worst = d3.max(errors.slice(from, to)) ?? NaN;
      if (status === 'not_applicable') continue;
      const power = powerOf(from, to), grows = worst > rounding && power > 0.25;
      const size = worst === 0 ? '0' : String(Math.floor(Math.log10(worst) + 0.5));
      const growth = !grows ? '' : power <= 0.75 ? '~' : power <= 1.5 ? '↗' : '⇑';
      series.push({
        case: cases[from], library: libraries[from], solver: solvers[from],
        invariant: quantities[from], status, detail: of('detail')[last], step: of('step')[from],
        time: times[last], worst, end: errors[last], first_value: values[from],
        last_value: values[last], power,
        mark: status === 'ok' ? (size + growth).replace('-', '−') : '✗',
        tip:
          `${quantities[from]}, step ${number(of('step')[from])}, to t = ` +
          `${number(times[last])}: at most ${number(worst, 2)}, at the end ` +
          number(errors[last]) +
          (worst > rounding && !Number.isNaN(power) ? `; grows as t^${power.toFixed(1)}` : '') +
          (status === 'ok' ? '' : `; ${status} ${of('detail')[last]}`),
      });
    }
    const kept = d3.rollup(
      series,
      (some) => (some.some((each) => each.invariant === 'energy') ? 'energy' : some[0].invariant),
      (each) => each.case,
    );
    return series.map((each) => ({
      ...each, chosen: each.invariant === kept.get(each.case) ? 'yes' : 'no',
    }));
  });

  // Rows `drift_oscillator`: the errors of the harmonic oscillator at the end of a run.
  addRows('drift_oscillator', async () => {
    const series = (await rowsOf('drift_series'))
      .objects()
      .filter((each) => each.case === 'osc_undamped');
    return [...d3.group(series, idOf).values()].map((some) => {
      const [energy, amplitude, phase] = ['energy', 'amplitude', 'phase'].map((name) =>
        some.find((each) => each.invariant === name && each.status === 'ok'),
      );
      const all = energy && amplitude && phase,
        { library, solver, status, step } = some[some.length - 1];
      // The row has the magnitude of the change; its sign follows from the first and the last
      // value.
      return {
        library, solver, status: all ? '' : status, step,
        amplitude: all
          ? (amplitude.last_value < amplitude.first_value ? -1 : 1) * amplitude.end
          : NaN,
        phase: all ? phase.last_value : NaN,
        frequency: all ? phase.end : NaN,
        energy: all ? energy.end : NaN,
      };
    });
  });

  //   ```errors_in_time   the error of a quantity against time, a line for each solver, a chart for
  //                       each case
  //   cases: kepler_e06   on the page of a case: that case
  //   quantity: energy    default: the energy, or else the first that is kept
  blocks.errors_in_time = async (host, spec, context) => {
    checkKeys(spec, 'errors_in_time', ['cases', 'quantity']);
    const kinds = [
      { name: 'other peers', colour: 'var(--dim)', dashed: true },
      { name: 'other own methods', colour: 'var(--s1)' },
      { name: 'symplectic', colour: 'var(--s0)' },
    ];
    const kindOf = (solver, library) =>
      facts.solverOf.get(solver)?.family === 'symplectic' || facts.symplectic?.includes(solver)
        ? 2
        : library === 'odeum'
          ? 1
          : 0;
    const curveOf = ([solver, some]) => {
      // Above 100 the solution is lost, and what follows is off the chart as well.
      const lost = some.findIndex((row) => row.relative_error >= 100),
        kind = kindOf(solver, some[0].library);
      return {
        ...kinds[kind], name: solver, kind, bare: true, faint: kind < 2,
        points: (lost < 0 ? some : some.slice(0, lost + 1)).map((run) => ({
          x: run.time, y: Math.min(run.relative_error, 100), run,
        })),
      };
    };
    const charts = [];
    for (const id of context.caseId ? [context.caseId] : spec.cases.split(/,\s*/)) {
      const rows = (await rowsOf('drift', id))
        .objects()
        .filter((row) => row.case === id && row.relative_error > 1e-17 && row.time > 0);
      const quantity =
        spec.quantity ||
        (rows.some((row) => row.invariant === 'energy') ? 'energy' : rows[0]?.invariant);
      const curves = [
        ...d3.group(rows.filter((row) => row.invariant === quantity), idOf),
      ].map(curveOf);
      if (curves.length)
        charts.push({ id, quantity, curves: d3.sort(curves, (curve) => curve.kind) });
    }
    if (!charts.length) return emptyText(host, spec);
    const grid = html('div', { class: charts.length > 1 ? 'panels' : 'single' }),
      used = new Set(charts.flatMap(({ curves }) => curves.map((curve) => curve.kind)));
    host.append(
      grid,
      legendOf(
        kinds
          .map((kind) => ({ ...kind, bare: true }))
          .filter((_, k) => used.has(k))
          .reverse(),
      ),
    );
    const pictures = charts.map(({ id, quantity }) => {
      const picture = html('div', { class: 'picture' });
      grid.append(
        html(
          'figure', {},
          html(
            'figcaption', {}, context.caseId ? '' : linkOf('case', id),
            context.caseId ? quantity : `: ${quantity}`,
          ),
          picture,
        ),
      );
      return picture;
    });
    charts.forEach(({ quantity, curves }, k) => {
      const points = curves.flatMap((curve) => curve.points);
      plot(pictures[k], {
        height: 380, nameless: true, description: `relative error of ${quantity} against time`,
        x: {
          ...rangeOf(points.map((p) => p.x), 1.2),
          label: 'time',
        },
        y: {
          ...rangeOf(points.map((p) => p.y), 2),
          label: `relative error: ${quantity}`,
        },
        curves,
        tell: (run, curve) => [
          curve.name, `t = ${number(run.time)}: ${number(run.relative_error)}`,
        ],
      });
    });
    return null;
  };
})();
