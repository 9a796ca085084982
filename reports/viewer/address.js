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

  // Shows a view anew, and puts the focus where it was: on what has the same name, in a group the
  // one that is chosen, else on the group or the view.
  const showAgain = async (host, show) => {
    const before = document.activeElement,
      group = before?.closest('[role="radiogroup"], [role="group"]');
    const within = host.contains(before),
      named = (e) => `${e.tagName}[aria-label="${CSS.escape(e.getAttribute('aria-label') || '')}"]`;
    const names = [
      before?.dataset.key ? `[data-key="${CSS.escape(before.dataset.key)}"]` : '',
      before?.getAttribute('aria-label') ? named(before) : '',
      group ? `${named(group)} [aria-checked="true"]` : '', group ? `${named(group)} button` : '',
    ];
    await show();
    if (!within || document.activeElement !== document.body) return;
    const found = names
      .filter(Boolean)
      .map((name) => host.querySelector(name))
      .find(Boolean);
    (found || document.getElementById('main')).focus({ preventScroll: true });
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
              choose(items[(i + step + items.length) % items.length][0]);
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

  Object.assign(odeum, {
    readAddress, addressOf, firstView, writeAddress, showAgain, choices, select,
  });
})();
