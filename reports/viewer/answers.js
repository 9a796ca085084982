// SPDX-License-Identifier: BSD-3-Clause
// The first view: for a problem and an error, who is fastest in each library, by how much, and why.
'use strict';
(() => {
  const {
    facts, sameError, isClosedForm, idOf, html, addressOf, settingText, colourOf, times, number,
    whyNotReached, shapeOf, duration, plural, rangeOf, plot, leadOf, workText, moreText, commandOf,
    disturbedText, fastestEigenvalue, limitNumber, growsAsFast, stableText, limitOf, writeAddress,
    showAgain, choices, loadCase, measuredCases, equationOf, missingNote,
  } = odeum;

  const askedErrors = ['1e-3', '1e-6', '1e-9'];

  // The fastest method of each library, with the run that it stands for.
  const fastestOf = (id, error, timed) =>
    facts.fastest
      .filter((row) => row.case === id && sameError(row.error, error) && !isClosedForm(row))
      .map((row) => ({
        ...row,
        run: timed.find(
          (t) =>
            idOf(t) === idOf(row) && t.setting_kind === row.setting_kind &&
            t.setting === row.setting && t.options === row.options,
        ),
      }))
      .sort((a, b) => a.wall_ns_min - b.wall_ns_min);

  // The fastest run of a closed form, which stands beside the methods and is compared with none.
  const closedFormOf = (timed, error) =>
    timed
      .filter((row) => isClosedForm(row) && row.error <= error && row.repetitions > 0)
      .reduce((best, row) => (!best || row.wall_ns_min < best.wall_ns_min ? row : best), null);

  const barRow = (row, longest, note) =>
    html(
      'tr', {},
      html(
        'th', { scope: 'row' },
        html(
          'a',
          {
            href: addressOf('compare', {
              case: row.case, x: 'time', add: '1',
              show: `${idOf(row)}:${row.setting_kind === 'tol' ? 'adaptive' : 'fixed'}`,
            }),
            title: settingText(row),
          },
          idOf(row),
        ),
        html('small', {}, note || settingText(row)),
      ),
      html('td', { class: 'time' }, duration(row.wall_ns_min)),
      html(
        'td', { class: 'length' },
        html('i', {
          style: {
            width: `${Math.max(0.5, (100 * row.wall_ns_min) / longest)}%`,
            background: colourOf(row.library),
          },
        }),
      ),
      html('td', { class: 'ratio' }, row.ratio === 1 ? '' : `× ${times(row.ratio)}`),
    );

  const closedText = (row) =>
    `a closed form, compared with none; it needs ${facts.solverOf.get(idOf(row)).needs}`;

  const bars = (c, error, best, timed, closed) => {
    const rows = best.map((row) => ({ ...row, ratio: row.wall_ns_min / best[0].wall_ns_min }));
    if (closed) rows.push({ ...closed, ratio: 1, closed: true });
    const longest = Math.max(...rows.map((row) => row.wall_ns_min), 1);
    const missing = facts.libraryNames.filter(
      (library) => !best.some((row) => row.library === library),
    );
    return html(
      'table', { class: 'bars' },
      html(
        'caption', {},
        'The fastest of each library: time of a whole solve, set-up included, least of several. ' +
          `The error is the largest of a component up to t = ${number(c.end)}, absolute, in the ` +
          `units of the ${c.scaled ? 'scale of each component' : 'equation'}, of a setting whose ` +
          'neighbours keep it within twice.',
      ),
      html(
        'tbody', {}, rows.map((row) => barRow(row, longest, row.closed ? closedText(row) : '')),
        missing.map((library) => {
          const why = whyNotReached(
            timed.filter((row) => row.library === library && !isClosedForm(row)), error,
          );
          return html(
            'tr', { class: why.tried ? 'failed-row' : 'untried' },
            html('th', { scope: 'row' }, library), html('td', { colspan: 3 }, why.text),
          );
        }),
      ),
    );
  };

  const bestCurve = (row, timed) => {
    const runs = timed.filter(
      (t) =>
        idOf(t) === idOf(row) && t.setting_kind === row.setting_kind && t.repetitions > 0 &&
        t.error > 0,
    );
    return {
      name: idOf(row), colour: colourOf(row.library), shape: shapeOf(facts.solverOf.get(idOf(row))),
      loose: runs.length < 2, dashed: row.setting_kind === 'step',
      points: runs.map((run) => ({ x: run.wall_ns_min, y: run.error, run })),
    };
  };
  const tellTimed = (run) => [
    idOf(run), `${settingText(run)}: error ${number(run.error)}`,
    `${duration(run.wall_ns_min)} (median ${duration(run.wall_ns_median)}), ` +
      `${plural(run.rhs_evaluations, 'evaluation')}`,
    `${plural(run.steps, 'step')}; ${run.measured}`,
  ];

  const answerPicture = (host, c, error, best, timed) => {
    const drawn = timed.filter(
      (row) => row.repetitions > 0 && row.error > 0 && row.error <= 10 * c.scale,
    );
    const x = rangeOf(
        drawn.map((row) => row.wall_ns_min), 1.5,
      ),
      y = rangeOf([...drawn.map((row) => row.error), error], 3);
    if (!x) return host.replaceChildren(html('p', { class: 'missing' }, 'Nothing was timed.'));
    return plot(host, {
      height: 380,
      description: `Error against time on ${c.title}; the table beside it has the fastest`,
      x: { ...x, label: 'time of a solve', text: duration },
      y: { ...y, label: 'largest error, absolute' },
      cloud: drawn.map((run) => ({ x: run.wall_ns_min, y: run.error, run })),
      curves: best.map((row) => bestCurve(row, timed)), tell: tellTimed,
      levels: [
        { y: error, text: `asked: ${number(error)}` },
        { y: c.timed_floor, text: "the truth's own error", shaded: true },
      ],
      pick: (run) => {
        location.hash = addressOf('compare', {
          case: c.id, x: 'time', add: '1',
          show: `${idOf(run)}:${run.setting_kind === 'tol' ? 'adaptive' : 'fixed'}`,
        });
      },
    });
  };

  const answerWords = (c, error, best, timed) => {
    const [first] = best;
    const rival = best.find((row) => row.library !== first.library);
    const sentences = [
      html(
        'p', { class: 'answer' }, html('strong', {}, idOf(first)), ` reaches ${number(error)} in `,
        html('strong', {}, duration(first.wall_ns_min)),
        rival ? `, ${leadOf(first, rival)}` : '; no other library reaches it.',
      ),
    ];
    const work = (row, name) => html('p', {}, html('b', {}, name), workText(row.run));
    if (first.run) sentences.push(work(first, 'Its run: '));
    if (rival?.run) sentences.push(work(rival, `That of ${idOf(rival)}: `));
    const finer = askedErrors.map(Number).find((e) => e < error * 0.5),
      more = finer && fastestOf(c.id, finer, timed)[0];
    if (more)
      sentences.push(html('p', {}, html('b', {}, 'Three digits more: '), moreText(first, more)));
    return sentences;
  };

  const answerBody = (c, error, { timed }) => {
    const best = fastestOf(c.id, error, timed);
    const closed = closedFormOf(timed, error);
    const picture = html('div', { class: 'picture' }), stable = html('p', { class: 'stable' });
    const words = best.length
      ? answerWords(c, error, best, timed)
      : [
          html(
            'p', { class: 'answer' },
            timed.length
              ? `No solver reaches ${number(error)} within what a report pays for a solve.`
              : 'Not timed in this report.',
          ),
        ];
    const body = html(
      'div', { class: 'columns wide-left' },
      html(
        'div', {},
        html(
          'p', { class: 'equation' }, html('a', { href: addressOf('case', { id: c.id }) }, c.title),
          ': ', equationOf(c.equation),
        ),
        words,
        stable,
        bars(c, error, best, timed, closed),
        disturbedText(timed) ? html('p', { class: 'disturbed' }, '⚠ ', disturbedText(timed)) : null,
        best[0]
          ? html(
              'p', { class: 'command' }, html('b', {}, 'Reproduce: '),
              html('code', {}, commandOf(c, best[0])),
            )
          : null,
        html(
          'p', {},
          html('a', { href: addressOf('compare', { case: c.id, x: 'time' }) }, 'Compare these'),
          ' · ',
          html('a', { href: addressOf('case', { id: c.id, part: 'precision' }) }, 'all numbers'),
          ' · ', html('a', { href: 'precision.csv' }, 'precision.csv'),
        ),
      ),
      picture,
    );
    requestAnimationFrame(() => answerPicture(picture, c, error, best, timed));
    if (best[0])
      stability(c, best[0]).then((text) =>
        stable.replaceChildren(...(text ? [html('b', {}, 'Stable: '), text] : [])),
      );
    return body;
  };
  const stability = async (c, row) => {
    const z = fastestEigenvalue(c, limitNumber(idOf(row), 'real') === undefined);
    // Where the solution itself grows as fast, staying bounded is nothing to ask for.
    if (!z || growsAsFast(c, z)) return '';
    const text = stableText(c, await limitOf(idOf(row), z), z, row.run);
    return text && `${idOf(row)} ${text}`;
  };

  // The jobs of this page that the report has; in a report of a person's own problems these.
  const askedOf = () => {
    const jobs = facts.questions.filter((q) => facts.caseOf.has(q.case));
    return jobs.length ? jobs : measuredCases().map((c) => ({ case: c.id, title: c.title }));
  };

  const showAnswers = (host, choice) => {
    const asked = askedOf();
    if (!asked.length)
      return host.replaceChildren(
        html('p', { class: 'missing' }, 'This report has none of the problems of this page.'),
      );
    const found = asked.find((q) => q.case === choice.case), question = found || asked[0];
    const error = askedErrors.includes(choice.error) ? choice.error : '1e-6';
    const turn = (change) => {
      const next = { case: question.case, error, ...change };
      writeAddress('answers', next);
      return showAgain(host, () => showAnswers(host, next));
    };
    const body = html('div', { class: 'answer-body', 'aria-live': 'polite' });
    host.replaceChildren(
      ...(choice.case && !found
        ? [missingNote('answer for the case', choice.case, question.case)]
        : []),
      html(
        'div', { class: 'controls' },
        choices(
          'problem', asked.map((q) => [q.case, q.title, facts.caseOf.get(q.case).equation]),
          question.case, (id) => turn({ case: id }),
        ),
        html(
          'span', { class: 'error-choice' }, 'error ',
          choices('error', askedErrors.map((e) => [e, e]), error, (e) => turn({ error: e })),
        ),
      ),
      body,
    );
    return loadCase(question.case).then((data) =>
      body.replaceChildren(answerBody(facts.caseOf.get(question.case), Number(error), data)),
    );
  };

  Object.assign(odeum, { askedErrors, fastestOf, showAnswers });
})();
