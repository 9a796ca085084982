// SPDX-License-Identifier: BSD-3-Clause
// A run's solution over time beside the exact one, in the state plane, its error and its energy
// (trajectories/solutions.hpp). Values are rounded to a thousandth of the range, logarithms to a
// hundredth.
'use strict';
(() => {
  const {
    facts, load, idOf, html, plot, spanOf, number, colourOf, shapeOf, rangeOf, save, csv, wide,
    notKeptText, solutionText, select,
  } = odeum;

  const setsOf = (c) =>
    facts.solutions[c.id]
      ? load(facts.solutions[c.id]).then((data) => data.sets)
      : Promise.resolve([]);
  // Levels of a set as states, from the initial one on.
  const statesOf = (set, levels) => {
    const n = set.names.length;
    const values = [...set.first, ...levels].map(
      (level, i) => set.low[i % n] + ((set.high[i % n] - set.low[i % n]) * level) / set.fine,
    );
    return Array.from({ length: values.length / n }, (_, k) => values.slice(k * n, k * n + n));
  };
  const exactOf = (set) => ({
    times: [set.start, ...set.exact.times], states: statesOf(set, set.exact.values),
  });
  // The curves of a run, or null where the report did not keep them.
  const solutionOf = (c, sets, run) => {
    const set = sets.find(
      (each) => sets.length === 1 || (each.end === c.end) === Boolean(run.timed),
    );
    if (!set) return null;
    const length = set.end - set.start;
    const key =
      run.mode === 'fixed'
        ? `fixed:${Math.round(length / run.step)}`
        : `adaptive:${Math.round(-1e6 * Math.log10(run.setting))}`;
    const found = set.runs[`${idOf(run)}:${key}`];
    if (!found) return null;
    const [parts, curve, errors, energies] = found, apart = Math.ceil(parts / set.outputs);
    const states = statesOf(set, set.curves[curve]);
    const size = (parts100) =>
      parts100 === 9999
        ? NaN
        : parts100 === 3000
          ? Infinity
          : parts100 === -2000
            ? 0
            : 10 ** (parts100 / 100);
    return {
      set, states,
      times: states.map((_, k) => Math.min(set.end, set.start + (k * apart * length) / parts)),
      errors: errors.map(size), energies: energies.map(size), exact: exactOf(set),
    };
  };

  // The exact solution of a case over time, in components of a size that can be seen beside the
  // largest, and in the plane of the first two.
  const showExact = async (host, c) => {
    const [set] = await setsOf(c);
    if (!set) return;
    const { times, states } = exactOf(set),
      sizes = set.names.map((_, k) => set.high[k] - set.low[k]);
    const most = d3.max(sizes), seen = d3.range(sizes.length).filter((k) => sizes[k] > 0.02 * most);
    const style = { bare: set.exact.everywhere, loose: !set.exact.everywhere };
    const curveOf = (k, i) => ({
      ...style, name: set.names[k], colour: `var(--s${i})`, shape: i,
      points: states.map((state, j) => ({ x: times[j], y: state[k], run: j })),
    });
    const names = ['exact-time', 'exact-plane'].slice(0, set.names.length);
    const pictures = names.map((name) => html('div', { class: 'picture', 'data-figure': name }));
    const shown = seen.slice(0, 4).map(curveOf);
    if (!shown.length) return;
    host.replaceChildren(...pictures);
    plot(pictures[0], {
      height: 260,
      description:
        `The exact solution of ${c.title} over time: ` + `${shown.map((s) => s.name).join(', ')}`,
      x: { low: set.start, high: set.end, label: 'time' },
      y: { ...spanOf(shown.flatMap((curve) => curve.points.map((p) => p.y))), label: '' },
      curves: shown,
      tell: (j, curve) => [curve.name, `${number(curve.points[j].y)} at t = ${number(times[j])}`],
    });
    if (set.names.length < 2) return;
    const points = states.map((state, j) => ({ x: state[0], y: state[1], run: j }));
    // No line where the solution moves too far from one output to the next.
    const wide = [0, 1].map((k) => set.high[k] - set.low[k]);
    const leaps = d3.pairs(states, (a, b) =>
      Math.max(...wide.map((width, k) => Math.abs(b[k] - a[k]) / width)),
    );
    const plane = d3.max(leaps) > 0.3 ? { loose: true } : style;
    plot(pictures[1], {
      height: 260,
      description: `The exact solution of ${c.title}: ${set.names[1]} against ${set.names[0]}`,
      x: { ...spanOf(points.map((p) => p.x)), label: set.names[0] },
      y: { ...spanOf(points.map((p) => p.y)), label: set.names[1] }, nameless: true,
      curves: [{ ...plane, name: 'exact', colour: 'var(--s0)', shape: 0, points }],
      tell: (j) => [`t = ${number(times[j])}`, `${number(points[j].x)}, ${number(points[j].y)}`],
    });
  };

  const drawSolution = (host, run, shown, x, y) => {
    const { set, states, times, exact } = shown;
    const point = (all, k, at) => ({ x: x < 0 ? at[k] : all[k][x], y: all[k][y], run: k });
    const own = states.map((_, k) => point(states, k, times)),
      truth = exact.states.map((_, k) => point(exact.states, k, exact.times));
    plot(host, {
      height: 280,
      description: `${set.names[y]} against ${x < 0 ? 'time' : set.names[x]}, of the run and exact`,
      x: {
        ...(x < 0 ? { low: set.start, high: set.end } : spanOf([...own, ...truth].map((p) => p.x))),
        label: x < 0 ? 'time' : set.names[x],
      },
      y: { ...spanOf([...own, ...truth].map((p) => p.y)), label: set.names[y] },
      curves: [
        {
          name: 'exact', colour: 'var(--dim)', wide: true, bare: set.exact.everywhere,
          loose: !set.exact.everywhere, shape: 0, points: truth,
        },
        {
          name: 'the run', colour: colourOf(run.library), bare: own.length > 60,
          shape: shapeOf(facts.solverOf.get(idOf(run))), points: own,
        },
      ],
      tell: (k, curve) => [
        curve.name,
        `${set.names[y]} = ` +
          `${number(curve.name === 'exact' ? exact.states[k][y] : states[k][y])} at t = ` +
          `${number((curve.name === 'exact' ? exact.times : times)[k])}`,
      ],
    });
  };
  const drawSize = (host, run, shown, values, label, floor) => {
    const { set, times } = shown,
      points = values
        .map((value, k) => ({ x: times[k + 1], y: value, run: k }))
        .filter((p) => p.y > 0 && p.y < 1e12);
    const range = rangeOf(points.map((p) => p.y), 3);
    if (!range)
      return host.replaceChildren(
        html(
          'p', { class: 'missing' },
          values.some(Number.isFinite)
            ? `The ${label} is zero at all outputs.`
            : `The ${label} is not known at these times.`,
        ),
      );
    return plot(host, {
      height: 280, description: `${label} against time`,
      x: { low: set.start, high: set.end, label: 'time' }, y: { ...range, label },
      curves: [
        {
          name: 'the run', colour: colourOf(run.library), bare: points.length > 60,
          loose: points.length < set.outputs / 10 && !set.exact.everywhere,
          shape: shapeOf(facts.solverOf.get(idOf(run))), points,
        },
      ],
      levels: floor > 0 ? [{ y: floor, text: "the truth's own error", shaded: true }] : [],
      tell: (k) => [label, `${number(values[k], 2)} at t = ${number(times[k + 1])}`],
    });
  };

  const solutionTable = (c, run, { set, states, times, errors, energies }) => {
    const columns = ['time', ...set.names, 'error', 'energy_error'];
    const rows = states.map((state, k) => [
      times[k], ...state, k ? (errors[k - 1] ?? NaN) : 0, k ? (energies[k - 1] ?? NaN) : 0,
    ]);
    return html(
      'details', {}, html('summary', {}, 'The numbers of these curves, rounded'),
      html(
        'p', {},
        html(
          'button',
          {
            type: 'button', class: 'download',
            onclick: () => save(`${c.id}_solution.csv`, csv(columns, rows)),
          },
          'download as CSV',
        ),
        ' The command above with --out writes all digits.',
      ),
      wide(
        'the numbers of these curves',
        html(
          'table', { class: 'numbers', 'data-numbers': 'solution' },
          html(
            'thead', {},
            html('tr', {}, columns.map((name) => html('th', {}, name))),
          ),
          html(
            'tbody', {},
            rows.map((row) => html('tr', {}, row.map((value) => html('td', {}, number(value)))),
            ),
          ),
        ),
      ),
    );
  };

  const showSolution = async (host, c, run) => {
    const shown = await setsOf(c).then((sets) => solutionOf(c, sets, run));
    if (!shown) return host.replaceChildren(html('p', { class: 'missing' }, notKeptText(c, run)));
    const { set } = shown,
      figures = ['time', 'plane', 'error', 'energy'].map((name) =>
        html('div', { class: 'picture', 'data-figure': name }),
      );
    const [time, plane, error, energy] = figures,
      chosen = { component: 0, x: 0, y: Math.min(1, set.names.length - 1) };
    // Two positions make a picture of a path; else a position and its velocity.
    const each = set.names.map((name, i) => [String(i), name]);
    const draw = () => {
      drawSolution(time, run, shown, -1, chosen.component);
      if (set.names.length > 1) drawSolution(plane, run, shown, chosen.x, chosen.y);
    };
    const turn = (name) => (value) => {
      chosen[name] = Number(value);
      draw();
    };
    host.replaceChildren(
      html('p', { class: 'solution-words' }, solutionText(shown, run)),
      html(
        'div', { class: 'controls' },
        set.names.length > 1
          ? [
              select('over time', each, '0', turn('component')),
              select('in the plane', each, '0', turn('x')),
              select('against', each, String(chosen.y), turn('y')),
            ]
          : null,
      ),
      html(
        'div', { class: 'solutions' }, time, set.names.length > 1 ? plane : null, error,
        shown.energies.length ? energy : null,
      ),
      solutionTable(c, run, shown),
    );
    draw();
    drawSize(error, run, shown, shown.errors, 'largest error', set.exact.floor);
    if (shown.energies.length)
      drawSize(energy, run, shown, shown.energies, 'error of the energy, relative', 0);
    return null;
  };

  Object.assign(odeum, { showExact, showSolution });
})();
