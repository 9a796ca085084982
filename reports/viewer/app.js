// SPDX-License-Identifier: BSD-3-Clause
// The page: a view at a time, named by the address: #answers?case=…, #case?id=…, #study?page=….
'use strict';
(() => {
  const {
    showAnswers, showCompare, showRegions, showCases, showMethods, showStudies, showDocument,
    showData, showCase, showStudy, showRuns, facts, html, addressOf, readAddress, firstView,
    takeFacts, load, rowsOf,
  } = odeum;

  const views = {
    answers: {
      text: 'Answers', show: showAnswers,
      lead: 'Choose a problem and the error that you can accept.', title: 'Which integrator?',
    },
    compare: {
      text: 'Compare', show: showCompare, title: 'Compare',
      lead:
        'Any solvers of any libraries side by side. Add them by any part of a name, a ' +
        'family, a library, or an order.',
    },
    regions: {
      text: 'Stability', show: showRegions, title: 'Stability',
      lead:
        'Where a step of a solver does not grow, and where the eigenvalues of a problem, ' +
        'times the step, lie.',
    },
    cases: { text: 'Cases', show: showCases, title: 'Cases' },
    methods: {
      text: 'Methods', show: showMethods, title: 'Methods',
      lead: 'What a method is, where it is stable, and how it did on every problem.',
    },
    studies: { text: 'Studies', show: showStudies, title: 'Studies' },
    document: { text: 'Findings', show: showDocument, named: 'findings' },
    data: { text: 'Data', show: showData, title: 'Data' },
    case: { show: showCase, under: 'cases' },
    study: { show: showStudy, under: 'studies' },
    run: { show: showRuns },
  };
  const showNavigation = (view, choice) => {
    const here = views[view].under || view;
    const shown = facts.runs ? [] : Object.entries(views).filter(([, each]) => each.text);
    document.querySelector('nav.main').replaceChildren(
      ...shown.map(([name, each]) =>
        html(
          'a',
          {
            href: addressOf(name, each.named ? { name: each.named } : {}),
            'aria-current':
              name === here && (!each.named || choice.name === each.named) ? 'page' : undefined,
          },
          each.text,
        ),
      ),
    );
  };

  let turn = 0;
  const follow = async () => {
    const address = readAddress(), view = views[address.view] ? address.view : firstView(),
      { title, lead, show } = views[view];
    const mine = ++turn, main = document.getElementById('main');
    delete document.documentElement.dataset.drawn;
    showNavigation(view, address.choice);
    const host = html('div', { 'data-view': view });
    main.replaceChildren(
      html(
        'section',
        { class: 'view', id: view, 'aria-labelledby': title ? `${view}-title` : undefined },
        title ? html('h1', { id: `${view}-title` }, title) : null,
        lead ? html('p', { class: 'lead' }, lead) : null, host,
      ),
    );
    document.title = `${title || view} – Odeum report`;
    try {
      await show(host, address.choice);
    } catch (error) {
      document.documentElement.dataset.error = String(error);
      host.replaceChildren(
        html(
          'p', { class: 'missing', role: 'alert' },
          `This view could not be shown: ${error.message}.`,
        ),
      );
    }
    if (mine !== turn) return;
    // What scrolls can be reached by keys.
    for (const box of main.querySelectorAll('.wide:not([tabindex]), pre:not([tabindex])'))
      box.tabIndex = 0;
    document.documentElement.dataset.drawn = view;
    const part = address.choice.part && document.getElementById(address.choice.part);
    if (part) part.scrollIntoView();
    else window.scrollTo(0, 0);
  };
  const start = async () => {
    takeFacts(await load('facts'));
    facts.fastest = (await rowsOf('fastest')).objects();
    facts.limits = (await rowsOf('stability_limits')).objects();
    // A reader by ear or by keys goes on where the new view begins.
    window.addEventListener('hashchange', () => {
      document.getElementById('main').focus({ preventScroll: true });
      return follow();
    });
    // Its address would be that of a view.
    document.querySelector('.skip').addEventListener('click', (event) => {
      event.preventDefault();
      document.getElementById('main').focus();
    });
    let width = window.innerWidth, waiting = 0;
    window.addEventListener('resize', () => {
      clearTimeout(waiting);
      waiting = setTimeout(() => {
        if (window.innerWidth !== width) {
          width = window.innerWidth;
          follow();
        }
      }, 200);
    });
    return follow();
  };
  start().catch((error) => {
    document.documentElement.dataset.error = String(error);
    document
      .getElementById('main')
      .replaceChildren(
        html(
          'p', { class: 'missing', role: 'alert' },
          `The report could not be read: ${error.message}.`,
        ),
      );
  });
})();
