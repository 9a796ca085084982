// SPDX-License-Identifier: BSD-3-Clause
// The list of cases, and a case's own page: what it is, then what each study has to say of it
// (case.md).
'use strict';
(() => {
  const { pagesOf, measuredIn, html, facts, addressOf, loadView, showProse, number } = odeum;

  const showCases = async (host) => {
    const overview = pagesOf().find((page) => page.id === 'overview');
    if (!overview || !measuredIn(overview.study))
      return host.append(
        html(
          'ul', { class: 'pages' },
          facts.cases.map((c) =>
            html(
              'li', {}, html('a', { href: addressOf('case', { id: c.id }) }, c.title), ' ',
              html('code', {}, c.equation),
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

  const showCase = async (host, choice) => {
    const c = facts.caseOf.get(choice.id);
    if (!c) throw new Error(`there is no case ${choice.id} in this report`);
    document.title = `${c.id} – Odeum report`;
    const lines = [
      ['Equation', html('code', {}, c.equation)], ['Source', c.source],
      ['Truth', `${c.truth}${c.floor > 0 ? ` (known to ${number(c.floor)})` : ''}`],
    ];
    host.append(
      neighbours(c), html('h1', {}, c.title), html('p', { class: 'lead' }, html('code', {}, c.id)),
      html(
        'dl', { class: 'facts' },
        lines.map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
      html(
        'p', {}, html('a', { href: addressOf('compare', { case: c.id }) }, 'Compare solvers on it'),
        ' · ', html('a', { href: addressOf('answers', { case: c.id }) }, 'the answer'),
      ),
    );
    for (const study of facts.studies.filter((each) => each.case_page && measuredIn(each))) {
      await loadView(study);
      const part = html('section', { id: study.name });
      host.append(part);
      await showProse(part, study.case_page, { caseId: c.id, case: c });
    }
  };

  Object.assign(odeum, { showCases, showCase });
})();
