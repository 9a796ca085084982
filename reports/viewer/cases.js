// SPDX-License-Identifier: BSD-3-Clause
// The list of cases, and a case's own page: what it is, then what each study has to say of it
// (case.md).
'use strict';
(() => {
  const {
    pagesOf, measuredIn, html, facts, addressOf, loadView, showProse, askedErrors, fastestOf, idOf,
    linkOf, duration, tableOf, number, showExact, loadCase, equationOf,
  } = odeum;

  const showCases = async (host) => {
    const overview = pagesOf().find((page) => page.id === 'overview');
    if (!overview || !measuredIn(overview.study))
      return host.append(
        html(
          'ul', { class: 'pages' },
          facts.cases.map((c) =>
            html(
              'li', {}, html('a', { href: addressOf('case', { id: c.id }) }, c.title), ' ',
              equationOf(c.equation),
            ),
          ),
        ),
      );
    await loadView(overview.study);
    return showProse(host, overview.text.replace(/^# .*$/m, ''));
  };

  // From case to case, in the order of the list of cases.
  const neighbours = (c) => {
    const k = facts.cases.indexOf(c),
      link = (other, text) =>
        other ? html('a', { href: addressOf('case', { id: other.id }) }, text(other.id)) : null;
    return html(
      'nav', { 'aria-label': 'neighbouring cases' }, link(facts.cases[k - 1], (id) => `← ${id}`),
      ' ', link(facts.cases[k + 1], (id) => `${id} →`),
    );
  };

  // The fastest methods at the errors that the first view asks for.
  const answersOf = (c, timed) => {
    const lines = askedErrors
      .map((error) => [error, fastestOf(c.id, Number(error), timed)])
      .filter(([, best]) => best.length)
      .map(([error, [first, ...rest]]) => {
        const rival = rest.find((row) => row.library !== first.library);
        return {
          cells: [
            { node: html('a', { href: addressOf('answers', { case: c.id, error }) }, error) },
            { text: idOf(first), node: linkOf('{library}/{solver}', idOf(first)) },
            { text: duration(first.wall_ns_min), value: first.wall_ns_min },
            {
              text: rival ? idOf(rival) : '–',
              node: rival && linkOf('{library}/{solver}', idOf(rival)),
            },
            { text: rival ? duration(rival.wall_ns_min) : '–', value: rival?.wall_ns_min },
          ],
        };
      });
    const heads = [
      'largest error, absolute', 'fastest method', 'time of a solve', 'best of another library',
      'its time',
    ];
    return lines.length
      ? tableOf(
          heads.map((text) => ({ text })), lines, 'numbers words',
        )
      : null;
  };

  const showCase = async (host, choice) => {
    const c = facts.caseOf.get(choice.id);
    if (!c) throw new Error(`there is no case ${choice.id} in this report`);
    document.title = `${c.id} – Odeum report`;
    const lines = [
      ['Equation', equationOf(c.equation, true)], ['Source', c.source],
      ['Truth', `${c.truth}${c.floor > 0 ? ` (known to ${number(c.floor)})` : ''}`],
      ...c.linear.map(([name, text]) => [
        name, ['form', 'solution'].includes(name) ? equationOf(text) : html('code', {}, text),
      ]),
    ];
    const pictures = html('div', { class: 'solutions' });
    host.append(
      neighbours(c), html('h1', {}, c.title), html('p', { class: 'lead' }, html('code', {}, c.id)),
      pictures,
      html(
        'dl', { class: 'facts' },
        lines.map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
    );
    // Its data may be large: the rest does not wait for it.
    showExact(pictures, c).catch((error) => {
      pictures.replaceChildren(html('p', { class: 'missing', role: 'alert' }, error.message));
    });
    const answers = answersOf(c, (await loadCase(c.id)).timed);
    if (answers) host.append(answers);
    host.append(
      html(
        'p', {}, html('a', { href: addressOf('compare', { case: c.id }) }, 'Compare solvers on it'),
      ),
    );
    // What stands below a rule, ---, closes the page.
    const parts = facts.studies.filter((each) => each.case_page && measuredIn(each));
    const texts = parts.map((study) => study.case_page.split(/^---$/m));
    for (const piece of [0, 1])
      for (const [k, study] of parts.entries()) {
        if (!texts[k][piece]) continue;
        await loadView(study);
        const part = html('section', { id: piece ? undefined : study.name });
        host.append(part);
        await showProse(part, texts[k][piece], { caseId: c.id, case: c });
      }
  };

  Object.assign(odeum, { showCases, showCase });
})();
