// SPDX-License-Identifier: BSD-3-Clause
// The search by which solvers are added to a comparison.
'use strict';
(() => {
  const { html, facts, colourOf, select } = odeum;

  const most = 30;

  const matches = (solver, filter) => {
    const order = /order\s*(\d+)/i.exec(filter.text),
      rest = filter.text
        .replace(/order\s*\d*/i, '')
        .toLowerCase()
        .split(/\s+/)
        .filter(Boolean);
    const text = `${solver.library}/${solver.method} ${solver.family}`.toLowerCase();
    return (
      (!order || solver.order === Number(order[1])) && rest.every((word) => text.includes(word)) &&
      (!filter.library || solver.library === filter.library) &&
      (!filter.family || solver.family === filter.family) &&
      (!filter.order || String(solver.order) === filter.order)
    );
  };

  const finder = (filter, available, shown, change) => {
    const list = html('div', { class: 'found', role: 'group', 'aria-label': 'solvers that match' });
    const refresh = () => {
      const found = available.filter((key) =>
        matches(
          facts.solverOf.get(key.split(':')[0]) || { library: '', method: key, family: '' }, filter,
        ),
      );
      const some = filter.text || filter.library || filter.family || filter.order;
      const missing = found
        .filter((key) => !shown.includes(key))
        .slice(0, Math.max(0, most - shown.length));
      list.replaceChildren(
        ...(some
          ? [
              html(
                'button',
                {
                  type: 'button', class: 'all', disabled: !missing.length,
                  onclick: () => change([...shown, ...missing]),
                },
                `add ${missing.length === 1 ? 'it' : `these ${missing.length}`}`,
              ),
              ...found.slice(0, 60).map((key) =>
                html(
                  'button',
                  {
                    type: 'button', 'aria-pressed': String(shown.includes(key)), 'data-key': key,
                    style: { '--lib': colourOf(key.split('/')[0]) },
                    onclick: () =>
                      change(
                        shown.includes(key)
                          ? shown.filter((k) => k !== key)
                          : [...shown, key].slice(-most),
                      ),
                  },
                  key.replace(':adaptive', ' to a tolerance').replace(':fixed', ''),
                ),
              ),
              found.length > 60
                ? html('span', { class: 'dim' }, `and ${found.length - 60} more`)
                : '',
            ]
          : []),
      );
    };
    const choose = (name) => (value) => {
      filter[name] = value;
      refresh();
    };
    const distinct = (name) =>
      [...new Set(facts.solvers.map((s) => s[name]).filter((v) => v !== null && v !== 0))]
        .sort((a, b) => (a > b ? 1 : -1))
        .map((v) => [String(v), String(v).replaceAll('_', ' ')]);
    refresh();
    return html(
      'div', { class: 'finder' },
      html(
        'label', { class: 'field' }, 'Add ',
        html('input', {
          type: 'search', placeholder: 'rk4, cvode, symplectic, order 5 …', value: filter.text,
          'aria-label': 'any part of a name',
          oninput: (event) => choose('text')(event.target.value),
        }),
      ),
      select('library', [['', 'any'], ...distinct('library')], filter.library, choose('library')),
      select('family', [['', 'any'], ...distinct('family')], filter.family, choose('family')),
      select('order', [['', 'any'], ...distinct('order')], filter.order, choose('order')),
      list,
    );
  };

  Object.assign(odeum, { most, matches, finder });
})();
