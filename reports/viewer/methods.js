// SPDX-License-Identifier: BSD-3-Clause
// A method: what it is, where it is stable, and how it did on every problem. The choice: solver.
'use strict';
(() => {
  const {
    facts, matches, html, addressOf, idOf, orderText, isClosedForm, times, duration, number,
    failureText, limitNumber, sameError, measuredCases, plural, wide, loadCase,
    missingNote,
  } = odeum;

  const methodList = (filter) => {
    const groups = new Map();
    for (const solver of facts.solvers) {
      const id = `${solver.library}/${solver.method}`;
      if (!matches(solver, filter)) continue;
      const name = `${solver.library}: ${solver.family.replaceAll('_', ' ')}`;
      groups.set(name, [
        ...(groups.get(name) || []),
        html('li', {}, html('a', { href: addressOf('methods', { solver: id }) }, solver.method)),
      ]);
    }
    return groups.size
      ? [...groups].map(([name, list]) =>
          html('div', {}, html('h2', {}, name), html('ul', { class: 'names' }, list)),
        )
      : html('p', { class: 'missing' }, 'No method has such a name.');
  };

  // One line a problem: its order there, the smallest error, the time, and how failed runs ended.
  const methodRow = (c, data, id) => {
    const own = (rows) => rows.filter((row) => idOf(row) === id), runs = own(data.runs),
      timed = own(data.timed),
      orders = own(data.orders);
    const best = [...runs.map((run) => run.error_max), ...timed.map((run) => run.error)]
      .filter((e) => e >= 0)
      .reduce((a, b) => Math.min(a, b), Infinity);
    const order = orders
      .filter((row) => row.verdict !== 'not_applicable')
      .map((row) => `${row.mode === 'fixed' ? 'fixed step' : 'to a tolerance'}: ${orderText(row)}`);
    const fastest = (rows) =>
      rows
        .filter((row) => row.repetitions > 0 && row.error <= 1e-6)
        .reduce((a, b) => (!a || b.wall_ns_min < a.wall_ns_min ? b : a), null);
    const mine = fastest(timed), first = fastest(data.timed.filter((row) => !isClosedForm(row))),
      all = runs.length ? runs : timed;
    const fits = all.some((run) => run.status !== 'not_applicable');
    const ratio = mine && first ? mine.wall_ns_min / first.wall_ns_min : NaN;
    const rank =
      mine && isClosedForm(mine)
        ? ', a closed form'
        : ratio > 1.005
          ? `, × ${times(ratio)} of ${idOf(first)}`
          : ': the fastest of all';
    const time = mine ? duration(mine.wall_ns_min) + rank : '';
    return html(
      'tr', { class: !all.length || !fits ? 'untried' : null, 'data-case': c.id },
      html('th', { scope: 'row' }, html('a', { href: addressOf('case', { id: c.id }) }, c.title)),
      html('td', {}, order.map((text) => html('div', {}, text))),
      html('td', {}, Number.isFinite(best) ? number(best, 2) : ''),
      html('td', {}, time),
      html('td', {}, !all.length ? 'not tried' : failureText(all)),
    );
  };

  const methodFacts = (id, solver) => {
    const limits = ['real', 'imaginary', 'oscillator']
      .map((axis) => [axis, limitNumber(id, axis)])
      .filter(([, limit]) => limit !== undefined);
    const axisText = {
      real: 'real axis to λh =', imaginary: 'imaginary axis to λh =',
      oscillator: 'undamped oscillator to ωh =',
    };
    const wins = facts.fastest.filter(
      (row) =>
        idOf(row) === id &&
        !isClosedForm(row) &&
        !facts.fastest.some(
          (other) =>
            other.case === row.case && sameError(other.error, row.error) && !isClosedForm(other) &&
            other.wall_ns_min < row.wall_ns_min,
        ),
    );
    const ahead = [...new Set(wins.map((row) => row.case))].map(
      (name) =>
        `${facts.caseOf.get(name)?.title || name} (${wins
          .filter((row) => row.case === name)
          .map((row) => number(row.error, 1))
          .join(', ')})`,
    );
    const ranked = solver.closed_form
      ? 'compared with no method: a closed form, exact at any step'
      : ahead.length
        ? `on ${ahead.join('; ')}`
        : 'on no problem of this report';
    const order = solver.closed_form ? 'none: exact at any step' : 'varies during a run';
    const lines = [
      ['family', solver.family.replaceAll('_', ' ')],
      ['order', solver.order === null ? order : number(solver.order)],
      [
        'runs',
        [solver.fixed ? 'at a fixed step' : '', solver.adaptive ? 'to a tolerance' : '']
          .filter(Boolean)
          .join(', '),
      ],
      ['needs', solver.needs || 'a right-hand side only'],
      ['source', solver.source],
      [
        'stable',
        limits
          .map(
            ([axis, limit]) =>
              `${axisText[axis]} ${limit === Infinity ? '∞ (everywhere)' : number(limit, 5)}`,
          )
          .join('; '),
      ],
      ['fastest of all', ranked],
    ];
    const example = measuredCases()[0] || facts.cases[0];
    return [
      html(
        'dl', { class: 'facts' },
        lines
          .filter(([, text]) => text)
          .map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
      html(
        'p', { class: 'command' }, html('code', {}, `odeum converge --solver ${id}`),
        ' measures its orders on every problem; ',
        html(
          'code', {},
          `odeum run ${example.words} --solver ${id} ` +
            `${solver.adaptive ? '--tol 1e-6' : '--step 0.01'}`,
        ),
        ' runs it once.',
      ),
      html(
        'p', {}, html('a', { href: addressOf('regions', { show: id }) }, 'Its region of stability'),
        ' · ',
        html(
          'a',
          {
            href: addressOf('compare', { case: example.id, x: 'evaluations', add: '1', show: id }),
          },
          "beside each library's best",
        ),
      ),
    ];
  };

  const methodFilter = { text: '', library: '', family: '', order: '' };
  const showMethods = async (host, choice) => {
    const solver = facts.solverOf.get(choice.solver);
    const list = html('div', { class: 'method-list' }, methodList(methodFilter)),
      shown = html('div', { class: 'method', 'aria-live': 'polite' });
    const search = html(
      'label', { class: 'field' }, 'Find ',
      html('input', {
        type: 'search', placeholder: 'verlet, bdf, order 5 …', value: methodFilter.text,
        'aria-label': 'method',
        oninput: (event) => {
          methodFilter.text = event.target.value;
          list.replaceChildren(...[methodList(methodFilter)].flat());
        },
      }),
    );
    host.replaceChildren(
      shown,
      html(
        'details', { open: !solver },
        html('summary', {}, `All ${plural(facts.solvers.length, 'method')}`), search, list,
      ),
    );
    if (!solver && choice.solver) shown.replaceChildren(missingNote('solver', choice.solver));
    if (!solver) return;
    const body = html('tbody', {});
    shown.replaceChildren(
      html('h2', {}, choice.solver), ...methodFacts(choice.solver, solver),
      wide(
        'problems',
        html(
          'table', { class: 'numbers words', 'data-numbers': 'method' },
          html(
            'thead', {},
            html(
              'tr', {},
              [
                'problem', 'order', 'least error', 'time to 1e-6', 'runs that did not end, and why',
              ].map((name) => html('th', {}, name)),
            ),
          ),
          body,
        ),
      ),
    );
    const measured = measuredCases(), untried = facts.cases.length - measured.length;
    for (const c of measured) body.append(methodRow(c, await loadCase(c.id), choice.solver));
    if (untried)
      body.append(
        html(
          'tr', { class: 'untried' },
          html('th', { scope: 'row' }, `${plural(untried, 'other problem')}`),
          html('td', { colspan: 4 }, 'not tried in this report'),
        ),
      );
  };

  Object.assign(odeum, { showMethods });
})();
