// SPDX-License-Identifier: BSD-3-Clause
// What the pages of orders show beside tables: verdicts, and the cases at a glance.
'use strict';
(() => {
  const {
    functions, facts, html, sum, blocks, prepare, addressOf, rowsOf, solverGroups, tableOf, plural,
  } = odeum;

  // The best first; signs tell verdicts apart without colour.
  const verdicts = {
    confirmed: ['✓', 'the claimed order lies within the tolerance of the slope'],
    higher: ['▲', 'errors fall faster than claimed'],
    lower: ['▼', 'errors fall more slowly than claimed'],
    floors: ['⊥', 'errors stop falling at a level, which the tables name'],
    undetermined: ['?', 'there are too few points, or no settled slope'],
    unstable: ['↯', 'no step that was tried is stable for the solver: no word on its answers'],
    failed: ['✗', 'no run gave a result'],
    over_budget: ['…', 'no run reached its end within its budget: there is nothing to judge'],
    not_applicable: ['·', 'the solver does not fit the case, or there is no claim'],
  };
  const run = Object.keys(verdicts).filter((verdict) => verdict !== 'not_applicable');
  const judged = run.filter((verdict) => verdict !== 'over_budget');
  functions.is_judged = (verdict) => judged.includes(verdict);
  functions.verdict_sign = (verdict) => verdicts[verdict]?.[0] ?? '';
  // What a reader sees of a verdict: a method without a stable step is not a failure of the code.
  functions.verdict_kind = (verdict, why) =>
    verdict === 'failed' && why === 'unstable' ? 'unstable' : verdict;
  functions.verdict_place = (verdict) => Object.keys(verdicts).indexOf(verdict);
  functions.class_name = (why) => facts.order_classes?.[why]?.name ?? why;
  functions.class_settles = (why) => facts.order_classes?.[why]?.settles ?? '';

  // `counts`: how many by verdict.
  const barOf = (counts) =>
    html(
      'span', { class: 'bar', 'aria-hidden': 'true' },
      judged
        .filter((verdict) => counts[verdict])
        .map((verdict) => html('i', { class: verdict, style: { 'flex-grow': counts[verdict] } })),
    );
  const wordsOf = (counts) =>
    run
      .filter((verdict) => counts[verdict])
      .map((verdict) => `${counts[verdict]} ${verdict.replace('_', ' ')}`)
      .join(', ') || 'not run';
  const total = (counts) => sum(judged.map((verdict) => counts[verdict] || 0));

  blocks.verdict_key = (host) =>
    host.append(
      html(
        'ul', { class: 'key' },
        Object.entries(verdicts).map(([verdict, [sign, meaning]]) =>
          html(
            'li', {},
            html('span', { class: `chip ${verdict}` }, `${sign} ${verdict.replace('_', ' ')}`),
            ` ${meaning}`,
          ),
        ),
      ),
    );

  // The verdicts of a case as a bar and in words, and why there is no order, the most frequent
  // reason first.
  blocks.case_verdicts = async (host, spec, context) => {
    const { rows, indices } = await prepare(spec, context, []);
    if (!indices.length) return;
    const [verdicts, reasons] = ['verdict', 'no_order'].map((name) => rows.column(name));
    const count = (key) => d3.rollup(indices, (some) => some.length, key);
    const verdict = count((i) => functions.verdict_kind(verdicts[i], reasons[i])),
      why = count((i) => reasons[i]);
    const counts = Object.fromEntries(verdict);
    why.delete('');
    const lines = [
      ['Orders', [barOf(counts), ' ', wordsOf(counts)]],
      [
        'Without an order',
        d3
          .sort(why, ([, n]) => -n)
          .map(([name, n]) => `${n} ${functions.class_name(name)}`)
          .join(', '),
      ],
    ];
    host.append(
      html(
        'dl', { class: 'facts' },
        lines
          .filter(([, text]) => text.length)
          .map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
    );
  };

  const fit = (counts) => (counts.not_applicable ? 'does not apply' : 'not tried');
  const cellOf = (counts, title) => {
    const all = total(counts), good = (counts.confirmed || 0) + (counts.higher || 0);
    return all
      ? {
          text: `${good}/${all}`, node: [barOf(counts), html('b', {}, String(good)), `/${all}`],
          value: good / all, title: `${title}: ${wordsOf(counts)}`,
        }
      : {
          text: '·', value: NaN, class: 'zero',
          title: `${title}: ${counts.over_budget ? wordsOf(counts) : fit(counts)}`,
        };
  };
  const caseLink = (c, text, part) =>
    html('a', { href: addressOf('case', { id: c.id, part }) }, text || c.id);
  const listed = (links) => links.flatMap((link, k) => (k ? [', ', link] : [link]));

  // Every case against the groups of solvers.
  blocks.case_overview = async (host) => {
    const rows = await rowsOf('orders'),
      [ids, libraries, solvers, given, why] = [
        'case', 'library', 'solver', 'verdict', 'no_order',
      ].map((name) => rows.column(name));
    const groups = solverGroups(),
      tally = d3.rollup(
        rows.indices(null),
        (some) =>
          Object.fromEntries(
            d3.rollup(some, (list) => list.length, (i) => functions.verdict_kind(given[i], why[i])),
          ),
        (i) => ids[i],
        (i) => functions.solver_group(libraries[i], solvers[i]),
      );
    const countsOf = (id, name) => tally.get(id)?.get(name) || {};
    const measured = facts.cases.filter((c) => tally.has(c.id)),
      cloths = measured.filter((c) => c.tags.includes('cloth'));
    const all = (name) =>
      Object.fromEntries(
        Object.keys(verdicts).map((verdict) => [
          verdict, sum(measured.map((c) => countsOf(c.id, name)[verdict] || 0)),
        ]),
      );
    const own = groups.filter((group) => group.own).length;
    const kinds = html(
      'tr', {}, html('td', {}), own ? html('th', { colspan: own }, 'Odeum, by family') : null,
      own < groups.length
        ? html('th', { colspan: groups.length - own }, 'peers, by library')
        : null,
    );
    const lines = [
      {
        class: 'all',
        cells: [
          { text: 'all cases' }, ...groups.map((group) => cellOf(all(group.name), group.title)),
        ],
      },
      ...measured.map((c) => ({
        cells: [
          { text: `${c.id} ${c.title}`, node: [caseLink(c), html('span', {}, c.title)] },
          ...groups.map((group) => cellOf(countsOf(c.id, group.name), group.title)),
        ],
      })),
    ];
    host.append(
      tableOf(
        [
          { text: 'case' },
          ...groups.map((group) => ({
            text: group.title, title: plural(group.ids.length, 'solver'),
          })),
        ],
        lines,
        'overview',
        kinds,
      ),
    );
    if (cloths.length)
      host.append(
        html(
          'p', {}, 'The pages of the cloths also show errors and energy over time: ',
          listed(cloths.map((c) => caseLink(c))), '.',
        ),
      );
  };
  blocks.cases_left_out = async (host) => {
    const ids = new Set((await rowsOf('orders')).column('case')),
      others = facts.cases.filter((c) => !ids.has(c.id));
    if (others.length)
      host.append(
        html(
          'p', { class: 'dim' }, 'Without orders in this report: ',
          listed(others.map((c) => caseLink(c))), '.',
        ),
      );
  };

  blocks.not_built = (host) => {
    const missing = facts.libraries.filter((each) => !each.built);
    if (missing.length)
      host.append(
        html(
          'p', {}, 'These libraries are not built in: ',
          listed(
            missing.map((each) =>
              html(
                'span', {}, html('strong', {}, each.name), ' (option ',
                html('code', {}, each.option), ')',
              ),
            ),
          ),
          '.',
        ),
      );
  };
})();
