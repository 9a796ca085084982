// SPDX-License-Identifier: BSD-3-Clause
// The address keeps the choice: #view?name=value&name=value.
'use strict';
(() => {
  const { facts, isMeasured, html } = odeum;

  const readAddress = () => {
    let text = location.hash.slice(1);
    try {
      text = decodeURIComponent(text);
    } catch {
      /* a stray %: as it stands */
    }
    const [view, query] = text.split('?');
    return { view, choice: Object.fromEntries(new URLSearchParams(query || '')) };
  };
  const addressOf = (view, choice) => {
    const query = Object.entries(choice)
      .filter(([, value]) => value)
      .map(([name, value]) => `${name}=${value}`)
      .join('&');
    return `#${view}${query ? `?${query}` : ''}`;
  };
  // A folder of runs (odeum run --out) has no studies, a report has no runs.
  const firstView = () =>
    facts.runs
      ? 'run'
      : isMeasured('precision')
        ? 'answers'
        : facts.tables.some((table) => table.rows)
          ? 'studies'
          : 'answers';
  const writeAddress = (view, choice) => {
    if ((readAddress().view || firstView()) === view)
      history.replaceState(null, '', addressOf(view, choice));
  };

  // A row of buttons of which one is chosen; arrows move.
  const choices = (label, items, chosen, choose) =>
    html(
      'div', { class: 'choices', role: 'radiogroup', 'aria-label': label },
      items.map(([value, text, title], i) =>
        html(
          'button',
          {
            type: 'button', role: 'radio', 'aria-checked': String(value === chosen),
            tabindex: value === chosen ? 0 : -1, title, 'data-value': value,
            onclick: () => choose(value),
            onkeydown: (event) => {
              const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
              if (!step) return;
              event.preventDefault();
              const next = items[(i + step + items.length) % items.length][0],
                group = event.target.parentElement;
              const { view } = group.closest('[data-view]').dataset,
                name = group.getAttribute('aria-label');
              choose(next);
              document
                .querySelector(`[data-view="${view}"] [aria-label="${name}"] [aria-checked="true"]`)
                .focus();
            },
          },
          text,
        ),
      ),
    );
  const select = (label, items, chosen, choose) =>
    html(
      'label', { class: 'field' }, `${label} `,
      html(
        'select', { 'aria-label': label, onchange: (event) => choose(event.target.value) },
        items.map(([value, text]) => html('option', { value, selected: value === chosen }, text)),
      ),
    );

  Object.assign(odeum, { readAddress, addressOf, firstView, writeAddress, choices, select });
})();
