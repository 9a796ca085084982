// SPDX-License-Identifier: BSD-3-Clause
// The pages of studies, the documents, and the view of the data.
'use strict';
(() => {
  const { loadScript, facts, html, showProse, addressOf, load } = odeum;

  const scriptsRead = new Map();
  // Runs a study's view.js, which adds kinds of blocks, once.
  const loadView = (study) => {
    if (!study.script) return Promise.resolve();
    if (!scriptsRead.has(study.name)) scriptsRead.set(study.name, loadScript(study.script));
    return scriptsRead.get(study.name);
  };
  // A study's own page first, then its others by name.
  const pagesOf = () =>
    facts.studies.flatMap((study) =>
      [...study.pages]
        .sort((a, b) => (b.id === study.name) - (a.id === study.name))
        .map((page) => ({ ...page, study })),
    );
  const titleOf = (text) => /^# (.*)$/m.exec(text)?.[1] || '';
  const measuredIn = (study) =>
    facts.tables.some((table) => table.study === study.name && table.rows);

  // Where the rows come from; a list of paragraphs.
  const originOf = (study) => {
    const command = [
      html('code', {}, `odeum ${study.command}`), ' with this folder as ',
      html('code', {}, '--out'),
    ];
    const problem = study.problem ? [html('p', { class: 'missing' }, `${study.problem}.`)] : [];
    if (!measuredIn(study))
      return [
        ...problem,
        html(
          'p', {}, 'Not measured in this run: ', command,
          ' measures it, and this page shows it after a reload.',
        ),
      ];
    if (!study.measured)
      return [
        ...problem,
        html(
          'p', {},
          'Not measured in this run: these are results of an earlier one, which the folder held.',
        ),
      ];
    if (!study.selection) return problem;
    const what = facts.run.command.startsWith('odeum report')
      ? 'To keep a report short, it runs'
      : 'This run was of';
    return [
      ...problem,
      html(
        'p', {}, `${what} a selection: ${study.selection}. `, command,
        ' runs every pair, and this page shows those after a reload.',
      ),
    ];
  };

  const showStudy = async (host, choice) => {
    const page = pagesOf().find((each) => each.id === choice.page);
    if (!page) throw new Error(`there is no page ${choice.page}`);
    await loadView(page.study);
    document.title = `${titleOf(page.text)} – Odeum report`;
    host.append(html('h1', {}, titleOf(page.text)), ...originOf(page.study));
    if (measuredIn(page.study)) await showProse(host, page.text.replace(/^# .*$/m, ''));
  };

  const showStudies = (host) => {
    const line = (page) =>
      html(
        'li', {}, html('a', { href: addressOf('study', { page: page.id }) }, titleOf(page.text)),
        ` ${page.id === page.study.name ? page.study.help : ''}`,
        measuredIn(page.study)
          ? ''
          : html('span', { class: 'dim' }, ' (not measured in this report)'),
      );
    host.append(
      html('p', { class: 'lead' }, 'What was measured, question by question.'),
      html(
        'ul', { class: 'pages' },
        pagesOf()
          .filter((page) => page.id !== 'overview')
          .map(line),
      ),
      html('h2', {}, 'To read'),
      html(
        'ul', { class: 'pages' },
        facts.documents.map((name) =>
          html(
            'li', {},
            html('a', { href: addressOf('document', { name }) }, name.replaceAll('-', ' ')),
          ),
        ),
      ),
    );
  };

  const showDocument = async (host, choice) => {
    const documents = await load('documents');
    if (!documents[choice.name]) throw new Error(`there is no document ${choice.name}`);
    await showProse(host, documents[choice.name]);
  };

  const filesList = (names) =>
    html(
      'ul', { class: 'files' },
      names.map((name) => html('li', {}, html('a', { href: name }, name))),
    );
  const showData = async (host) => {
    const { run } = facts,
      libraries = (built) => facts.libraries.filter((each) => each.built === built);
    const lines = [
      ['Written', run.date], ['Command', run.command], ['Took', `${Math.round(run.seconds)} s`],
      ['Odeum', `${facts.odeum.version} ${facts.odeum.revision}`],
      [
        'Libraries',
        libraries(true)
          .map((each) => `${each.name} ${each.version}`)
          .join(', '),
      ],
      [
        'Not built in',
        libraries(false)
          .map((each) => `${each.name} (${each.option})`)
          .join(', '),
      ],
      ['Compiler', run.compiler],
      ['Processor', run.processor],
    ];
    host.append(
      html(
        'div', { class: 'columns' },
        html(
          'div', {}, html('h2', {}, 'The files'),
          html(
            'p', {},
            'Everything in this report comes from the files beside it, one observation a row: ',
            html('a', { href: addressOf('document', { name: 'columns' }) }, 'what each column is'),
            '.',
          ),
          filesList([
            ...facts.tables.filter((table) => table.rows).map((table) => table.file),
            'manifest.json', 'page.json',
          ]),
        ),
        html(
          'div', {}, html('h2', {}, 'This run'),
          html(
            'dl', { class: 'facts' },
            lines
              .filter(([, text]) => text)
              .map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
          ),
        ),
      ),
    );
    for (const study of facts.studies.filter((each) => each.summary && measuredIn(each))) {
      await loadView(study);
      await showProse(host, study.summary);
    }
  };

  Object.assign(odeum, {
    loadView, pagesOf, measuredIn, showStudy, showStudies, showDocument, showData,
  });
})();
