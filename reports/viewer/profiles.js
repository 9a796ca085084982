// SPDX-License-Identifier: BSD-3-Clause
// The block `profile`: which share of its questions a library or a family answers within a factor
// of the fastest (Dolan and More, Mathematical Programming 91, 2002), and who is faster pair by
// pair. A question is a case and an error above that of its truth. A solver answers it with the
// fastest of its timed runs that reach the error, and keep it within twice at the neighbouring
// settings, where those were run: they were for the fastest of each library.
//   rows: precision where …
//   by: template         who is compared; default {library}
//   errors: 1e-3, 1e-6   the errors that are asked for
//   across: ratio        the factor of the fastest, or `time`: that of the solve
//   classes: stiff, …    a small chart each of the cases with this tag; `not stiff`: without it;
//                        `all`
// The block `duels` has rows, by and errors: a table of the median of the quotient of two times.
'use strict';
(() => {
  const {
    Template, blocks, checkKeys, prepare, emptyText, facts, html, plot, legendOf, rangeOf, duration,
    number, times, plural, colourOf, isClosedForm, tableOf,
  } = odeum;

  const keepsError = (row, error) =>
    row.repetitions > 0 && row.wall_ns_min > 0 && row.error <= error &&
    !(row.near_error > error && row.near_error > Math.min(2 * error, 4 * row.error));

  // [{case, error, tried: names that have runs on the case, times: Map of names to nanoseconds}] of
  // the questions that somebody answers. `rows` are objects, `names[k]` who rows[k] belongs to.
  const answersOf = (rows, names, errors) => {
    const cases = new Map();
    rows.forEach((row, k) => {
      if (row.status === 'not_applicable' || isClosedForm(row)) return;
      if (!cases.has(row.case)) cases.set(row.case, { tried: new Set(), found: new Map() });
      const { tried, found } = cases.get(row.case);
      tried.add(names[k]);
      for (const error of errors) {
        if (!keepsError(row, error) || error <= facts.caseOf.get(row.case)?.timed_floor) continue;
        if (!found.has(error)) found.set(error, new Map());
        const times_ = found.get(error);
        times_.set(names[k], Math.min(row.wall_ns_min, times_.get(names[k]) ?? Infinity));
      }
    });
    return [...cases].flatMap(([id, { tried, found }]) =>
      [...found].map(([error, answers]) => ({ case: id, error, tried, times: answers })),
    );
  };

  // The curve of one name: the sorted factors of the fastest, or times, of the questions that it
  // answers, each with the share of those on which it was tried; {asked, points: [{x, y}]}.
  const profileOf = (questions, name, across) => {
    const asked = questions.filter(({ tried }) => tried.has(name));
    const sizes = asked
      .filter((each) => each.times.has(name))
      .map((each) =>
        across === 'time'
          ? each.times.get(name)
          : each.times.get(name) / Math.min(...each.times.values()),
      )
      .sort((a, b) => a - b);
    return {
      asked: asked.length,
      points: sizes
        .map((x, k) => ({ x, y: (k + 1) / asked.length }))
        .filter((p, k, all) => k + 1 === all.length || all[k + 1].x > p.x),
    };
  };

  // {median, faster, count} of time of `b` over time of `a` on the questions that both answer:
  // above 1 `a` is faster.
  const duelOf = (questions, a, b) => {
    const quotients = questions
      .filter((each) => each.times.has(a) && each.times.has(b))
      .map((each) => each.times.get(b) / each.times.get(a))
      .sort((x, y) => x - y);
    const middle = Math.floor(quotients.length / 2);
    return {
      count: quotients.length, faster: quotients.filter((q) => q > 1).length,
      median:
        quotients.length % 2
          ? quotients[middle]
          : Math.sqrt(quotients[middle - 1] * quotients[middle]),
    };
  };

  const namesOf = (questions) => [
    ...new Set(questions.flatMap(({ tried }) => [...tried])),
  ].sort((a, b) => facts.libraryNames.indexOf(a) - facts.libraryNames.indexOf(b));
  const hasTag = (id, name) => {
    const has = (tag) => (facts.caseOf.get(id)?.tags || []).includes(tag);
    return name === 'all' || (name.startsWith('not ') ? !has(name.slice(4)) : has(name));
  };
  const listOf = (text) => text.split(',').map((each) => each.trim());

  // The questions of a block, and the names in the order of their colours.
  const asked = async (spec, context) => {
    const { rows, indices, bound } = await prepare(spec, context, [
      new Template(spec.by || '{library}'),
    ]);
    if (!indices.length) return { questions: [], names: [] };
    const all = rows.objects();
    const questions = answersOf(
      indices.map((i) => all[i]), indices.map((i) => bound[0].text(i, [i])),
      listOf(spec.errors).map(Number),
    );
    return { questions, names: namesOf(questions) };
  };
  const styleOf = (names, name) => {
    const k = names.indexOf(name), isLibrary = facts.libraryNames.includes(name);
    return { name, dashed: k >= 8, colour: isLibrary ? colourOf(name) : `var(--s${k % 8})` };
  };

  blocks.profile = async (host, spec, context) => {
    checkKeys(spec, 'profile', ['by', 'errors', 'across', 'classes']);
    const { questions, names } = await asked(spec, context), isTime = spec.across === 'time';
    const charts = listOf(spec.classes || 'all')
      .map((text) => {
        const some = questions.filter((each) => hasTag(each.case, text));
        const curves = names
          .map((name) => ({ ...styleOf(names, name), ...profileOf(some, name, spec.across) }))
          .filter((curve) => curve.points.length);
        return { text, some, curves };
      })
      .filter(({ curves }) => curves.length);
    if (!charts.length) return emptyText(host, spec);
    // Beyond a thousand times the fastest all curves are flat to the eye.
    const sizes = charts.flatMap(({ curves }) => curves.flatMap((c) => c.points.map((p) => p.x)));
    const range = isTime
      ? rangeOf(sizes, 1.4)
      : { low: 1, high: Math.min(1000, 1.1 * Math.max(10, ...sizes)), log: true };
    const several = charts.length > 1;
    const grid = html('div', { class: several ? 'panels' : 'single' });
    host.append(grid);
    for (const { text, some, curves } of charts) {
      const picture = html('div', { class: 'picture' });
      const title = `${text.replaceAll('_', ' ')}: ${plural(some.length, 'question')}, ` +
        plural(new Set(some.map((each) => each.case)).size, 'case');
      grid.append(html('figure', {}, html('figcaption', {}, title), picture));
      plot(picture, {
        height: several ? 250 : 380, nameless: several,
        description:
          `share answered against ${isTime ? 'time' : 'the factor of the fastest'}, ${title}`,
        x: {
          ...range, label: isTime ? 'time of a solve' : 'times the fastest',
          text: isTime ? duration : (v) => number(v),
        },
        y: { low: 0, high: 1, label: 'share answered', text: (v) => `${Math.round(100 * v)} %` },
        curves: curves.map((curve) => {
          const last = curve.points[curve.points.length - 1];
          return {
            ...curve, bare: true, stairs: true,
            points: [...curve.points, { x: range.high, y: last.y }].map((p) => ({ ...p, run: p })),
          };
        }),
        tell: (p, curve) => [
          curve.name,
          `${Math.round(100 * p.y)} % of ${plural(curve.asked, 'question')} within ` +
            (isTime ? duration(p.x) : `${number(p.x)} times the fastest`),
        ],
      });
    }
    const drawn = names.filter((name) => charts.some((c) => c.curves.some((e) => e.name === name)));
    if (several)
      host.append(legendOf(drawn.map((name) => ({ ...styleOf(names, name), bare: true }))));
    return null;
  };

  blocks.duels = async (host, spec, context) => {
    checkKeys(spec, 'table of duels', ['by', 'errors']);
    const { questions, names: all } = await asked(spec, context),
      names = all.filter((name) => questions.some(({ times: answers }) => answers.has(name)));
    if (!names.length) return emptyText(host, spec);
    const cellOf = (a, b) => {
      if (a === b) return { text: '', class: 'not_applicable', value: NaN };
      const { count, faster, median } = duelOf(questions, a, b);
      if (!count) return { text: '·', class: 'not_applicable', value: NaN };
      return {
        text: times(median), value: median,
        class: median > 1.05 ? 'confirmed' : median < 1 / 1.05 ? 'lower' : 'undetermined',
        title: `${a} is faster on ${faster} of the ${plural(count, 'question')} that both answer`,
      };
    };
    host.append(
      tableOf(
        [
          { text: 'faster by', class: 'corner' },
          ...names.map((name) => ({ text: `than ${name}` })),
        ],
        names.map((a) => ({ cells: [{ text: a }, ...names.map((b) => cellOf(a, b))] })),
        'numbers drifts',
      ),
    );
    return null;
  };

  Object.assign(odeum, { answersOf, profileOf, duelOf });
})();
