// SPDX-License-Identifier: BSD-3-Clause
// node expressions.mjs <d3.min.js>: what the page computes, without a browser: expressions, formats, data, series,
// and that every expression of every study's page can be read.
import { deflateSync } from 'node:zlib';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { join } from 'node:path';
import vm from 'node:vm';

const root = fileURLToPath(new URL('../..', import.meta.url)), read = (path) => readFileSync(join(root, path), 'utf8');
const hold = (condition, text) => { if (!condition) throw new Error(text); };
const same = (found, expected, text) => hold(Object.is(found, expected) || JSON.stringify(found) === JSON.stringify(expected), `${text}: ${JSON.stringify(found)}, expected ${JSON.stringify(expected)}`);
const near = (found, expected, text) => hold(Math.abs(found - expected) <= 1e-9 * Math.max(1, Math.abs(expected)), `${text}: ${found}, expected ${expected}`);
const errorOf = (work) => { try { work(); } catch (error) { return error.message; } return 'no error'; };

// The scripts of the page, in their order.
const context = vm.createContext({ atob, Blob, Response, DecompressionStream, Uint8Array, URLSearchParams, location: { hash: '' }, console });
context.self = context;
context.markdownit = () => ({});
vm.runInContext(readFileSync(process.argv[2], 'utf8'), context);
const before = new Set(Object.keys(context)), scripts = [...read('reports/viewer/index.html').matchAll(/src="viewer\/([a-z]+)\.js" defer/g)].map(([, name]) => name).filter((name) => name !== 'app');
for (const name of scripts) vm.runInContext(read(`reports/viewer/${name}.js`), context, { filename: `${name}.js` });
const page = (name) => context.odeum[name];
const [Template, parse, formatted, Rows, takeFacts, rowsOf, specOf, columnOf, functions, blocks] = ['Template', 'parse', 'formatted', 'Rows', 'takeFacts', 'rowsOf', 'specOf', 'columnOf', 'functions', 'blocks'].map(page);

const tableOf = (name, columns) => {
  const names = Object.keys(columns), rows = new Rows(name, [], columns[names[0]].length, names);
  for (const each of names) rows.columns.set(each, columns[each]);
  return rows;
};
const runs = tableOf('runs', { library: ['odeum', 'odeum', 'gsl'], solver: ['rk4', 'heun', 'rk4'], error: [1e-3, NaN, 4e-3], steps: [10, 20, 40], ok: ['ok', 'failed', 'ok'] });
const limits = tableOf('limits', { status: ['ok', 'differs', 'ok', 'ok'], limit: [2, 3, Infinity, NaN], solver: ['a', 'b', 'c', 'a'] });
const tables = new Map([['runs', runs], ['limits', limits]]);
const at = (source, i = 0, group = [i]) => new Template(`{${source}}`).bind(runs, tables).value(i, group);
const shown = (template, i = 0, group = [i]) => new Template(template).bind(runs, tables).text(i, group);

// Tables as a report hands them over.
const send = (name, json) => page('receive')([name, deflateSync(JSON.stringify(json)).toString('base64')]);
const entryOf = (name, columns, parts) => ({ name, file: `${name}.csv`, study: 's', columns, parts, rows: parts.reduce((all, part) => all + part.rows, 0) });
const give = (name, list) => {
  const keys = Object.keys(list[0]), number = (value) => (Number.isNaN(value) ? null : Number.isFinite(value) ? value : value > 0 ? 'inf' : '-inf');
  page('facts').tableOf.set(name, entryOf(name, keys, [{ data: name, rows: list.length }]));
  send(name, Object.fromEntries(keys.map((key) => [key, typeof list[0][key] === 'string' ? { words: list.map((row) => row[key]), of: list.map((_, i) => i) } : list.map((row) => number(row[key]))])));
};

const checks = {
  'operators bind as in mathematics'() {
    for (const [source, value] of [['2 + 3 * 4', 14], ['(2 + 3) * 4', 20], ['2 - 3 - 4', -5], ['12 / 3 / 2', 2], ['-2 ^ 2', -4], ['2 ^ 3 ^ 2', 512], ['2 ^ -1', 0.5], ['1e-3 * 1e3', 1], ['.5 + 1.', 1.5], ['2 * -3', -6], ['1 + 1 == 2 and not 2 < 1', true], ['1 > 2 or 3 >= 3', true], ['1 != 1', false], ['not 1 == 2 and 1 == 1', true]])
      same(at(source), value, source);
  },
  'a word beside == is a text unless it is a column'() {
    same(at('library == odeum', 0), true, 'first row');
    same(at('library == odeum', 2), false, 'third row');
    same(at('solver != heun', 1), false, '!=');
    same(at("library == 'odeum'"), true, 'quoted');
    same(at('library == library', 2), true, 'a column');
    same(at("library + '/' + solver", 2), 'gsl/rk4', 'texts are joined');
  },
  'functions'() {
    same(at('if(steps > 15, many, 0)'.replace('many', "'many'"), 1), 'many', 'if');
    same(at('max(3, 5)'), 5, 'max of two numbers');
    same(at('abs(-2) + sqrt(9) + log10(1000) + log2(8) + floor(2.7) + round(2.5)'), 2 + 3 + 3 + 3 + 2 + 3, 'numbers');
    same([at('known(error)', 0), at('known(error)', 1), at('finite(error)', 1)], [true, false, false], 'known');
    same(at("starts(library, 'od')"), true, 'starts');
    same([0.1, 0.3, 1.2, 5, -0.1, -0.3, -5, 0].map((size) => functions.shade(size, 0.2, 1, 4)), ['', 't1', 't2', 't3', '', 't-1', 't-3', ''], 'shade');
    same([0, 1e-9, 1e-5, 1, NaN].map((x) => functions.grade(x, 'good', 1e-9, 'middle', 1e-2, 'bad')), ['good', 'good', 'middle', 'bad', ''], 'grade');
    same([1 / 60, 1 / 240, 0.0125, 1, 0.03].map(functions.seconds), ['1/60 s', '1/240 s', '1/80 s', '1 s', '0.03 s'], 'seconds');
  },
  'aggregates of a cell, of a table, and how many'() {
    const all = [0, 1, 2];
    same(at('max(error)', 0, all), 4e-3, 'max leaves out what is not known');
    near(at('mean(error)', 0, all), 2.5e-3, 'mean');
    same([at('sum(steps)', 0, all), at('min(steps)', 0, all), at('median(steps)', 0, all), at('first(steps)', 0, all), at('last(steps)', 0, all)], [70, 10, 20, 10, 40], 'numbers');
    same([at('count()', 0, all), at('distinct(solver)', 0, all), at('list(solver)', 0, all)], [3, 2, 'rk4, heun'], 'of texts');
    same([at('any(error > 1)', 0, all), at('all(steps > 5)', 0, all)], [false, true], 'any and all');
    same(at('max(limit of limits where status == differs)'), 3, 'of another table');
    same(at('max(limit of limits)'), Infinity, 'infinity is known');
    same([at('count(limits)'), at('count(limits where status == differs)'), at('distinct(solver of limits)')], [4, 1, 3], 'how many');
    same(at('max(limit of limits where status == none)'), NaN, 'of no row');
    // Infinity, which a fold over nothing gives, would be shown as a result.
    same([at('max(error)', 1, [1]), at('min(error)', 1, [1]), shown('max(error) | .1e', 1, [1])], [NaN, NaN, '–'], 'of rows that are all unknown');
    same([...new Template('{max(limit of limits where limit < max(error of runs))}').tables()].sort(), ['limits', 'runs'], 'the tables that are read');
  },
  'what is wrong is said, with the text'() {
    for (const [source, sentence] of [['1 +', 'ends too early'], ['(1', ') was expected'], ['1 2', 'more than one expression'], ['nothing(1)', 'there is no function nothing'], ['errors + 1', 'there is no column errors in runs: library, solver, error, steps, ok'], ['max(limit of none)', 'there are no rows none'], ['max(missing of limits)', 'there is no column missing in limits'], ['steps ; 1', '";" was not expected'], ['* 2', '* was not expected'], ['steps == ', 'ends too early'], ['constructor(1)', 'there is no']])
      hold(errorOf(() => at(source)).includes(sentence), `${source}: ${errorOf(() => at(source))}`);
    hold(errorOf(() => shown('{steps | .3q}')).includes('there is no format .3q'), 'a format that there is not');
    hold(errorOf(() => specOf('rows: a\nnonsense')).includes('"nonsense" is not key: value'), 'a block');
    hold(errorOf(() => specOf('  indented')).includes('stands under no key'), 'a list without a key');
  },
  'formats'() {
    for (const [value, format, text] of [[0.5, '.3f', '0.500'], [-0.5, '.1f', '−0.5'], [-0.0001, '.2f', '0.00'], [12345.678, 'd', '12,346'], [1.5e-7, '.1e', '1.5e-7'], [0.123, '.0%', '12 %'], [0.01, '+.1%', '+1.0 %'], [-0.12, '+.1%', '−12.0 %'], [3, '+.2g', '+3'], [0.012345, '.3g', '0.0123'], [850, 'time', '850 ns'], [999.9, 'time', '1 µs'], [12340, 'time', '12.3 µs'], [4.56e6, 'time', '4.56 ms'], [2e9, 'time', '2 s'], [NaN, 'time', '–'], [NaN, '.2f', '–'], [Infinity, '.2f', '∞'], [-Infinity, 'd', '−∞'], ['text', '.2f', 'text'], [undefined, '', '']])
      same(formatted(value, format), text, `${value} as ${format}`);
    for (const [value, text] of [[0, '0'], [0.0125, '0.0125'], [3.14e-12, '3.14e-12'], [123456, '1.23e5'], [NaN, '–'], [null, '–'], [1000, '1000']]) same(page('number')(value), text, 'number');
    same([page('plural')(1, 'case'), page('plural')(0, 'case'), page('plural')(1234, 'row')], ['1 case', '0 cases', '1,234 rows'], 'plural');
    same(shown('{library}/{solver}, {steps | d} steps', 2), 'gsl/rk4, 40 steps', 'a template');
    same(shown('steps | .1f', 1), '20.0', 'an expression alone');
    same(page('csv')(['a', 'b'], [['x,"y"', NaN], ['', -Infinity]]), 'a,b\n"x,""y""",nan\n,-inf\n', 'CSV');
  },
  'a block is a list of keys'() {
    same(specOf('rows: runs where ok == ok\ncolumns:\n  a = steps | d\n  solver\n\nsort: steps'), { rows: 'runs where ok == ok', columns: ['a = steps | d', 'solver'], sort: 'steps' }, 'keys');
    same(columnOf('the steps = steps | d').heading, 'the steps', 'a heading');
    same(columnOf('{library} | d').heading, 'library', 'a heading of its own');
    same(columnOf('x == y').heading, 'x == y', '== is not a heading');
  },
  'scripts add one name, say what they hold, and are read without scrolling'() {
    const viewer = readdirSync(join(root, 'reports/viewer')).filter((name) => name.endsWith('.js')), studies = join(root, 'src/odeum/studies');
    same([...scripts, 'app'].sort(), viewer.map((name) => name.slice(0, -3)).sort(), 'scripts of index.html');
    same(Object.keys(context).filter((name) => !before.has(name) && name !== 'document'), ['odeum'], 'names that the page adds');
    const views = readdirSync(studies).filter((name) => existsSync(join(studies, name, 'view.js'))).map((name) => `src/odeum/studies/${name}/view.js`);
    const replay = readdirSync(join(root, 'reports/viewer/replay')).filter((name) => name.endsWith('.js')).map((name) => `reports/viewer/replay/${name}`);
    for (const file of [...viewer.map((name) => `reports/viewer/${name}`), ...views, ...replay]) {
      const text = read(file), lines = text.split('\n');
      hold(/^\/\/ SPDX-License-Identifier: BSD-3-Clause\n\/\/ \S/.test(text), `${file}: no comment at its head`);
      hold(lines.length <= 301, `${file}: ${lines.length} lines`);
      lines.forEach((line, i) => hold([...line].length <= 100, `${file}:${i + 1}: longer than 100 columns`));
      // A replay's scripts are parts of one function in replay.html.
      if (!replay.includes(file)) hold(/^(\/\/.*\n)+'use strict';\n\(\(\) => \{\n[^]*\n\}\)\(\);\n$/.test(text), `${file}: names outside of its function`);
    }
    hold(views.length > 3 && replay.length > 5, 'the files were not found');
  },
  'curves of one library and family are told apart'() {
    const curves = page('toldApart')([...Array(5).fill({ colour: 'var(--s0)', shape: 1 }), { colour: 'var(--s1)', shape: 1 }]);
    same(new Set(curves.map(({ colour, filled, shape }) => `${colour} ${filled} ${shape}`)).size, 6, 'looks');
    same([curves[0].colour, curves[5].colour, curves[5].filled], ['var(--s0)', 'var(--s1)', false], 'the first of a library');
  },
  'triangles are made of rows'() {
    const [triangle] = page('trianglesOf')([{ x1: 0, y1: 1, x2: 2, y2: 3, x3: 4, y3: 5, u1: 6, u2: 7, u3: 8 }], 'u');
    same(triangle, { x: [0, 2, 4], y: [1, 3, 5], values: [6, 7, 8] }, 'a triangle');
  },
  async 'rows arrive as they were handed over'() {
    takeFacts({ cases: [{ id: 'a', tags: [] }, { id: 'b', tags: [] }], solvers: [{ library: 'odeum', method: 'rk4', family: 'explicit_rk' }], libraries: [], studies: [], documents: [],
      tables: [entryOf('split', ['case', 'x'], [{ data: 'split-0', rows: 2, case: 'a' }, { data: 'split-1', rows: 1, case: 'b' }]), entryOf('none', ['x'], [])] });
    send('split-0', { case: { words: ['a'], of: [0, 0] }, x: [1, null] });
    send('split-1', { case: { words: ['b'], of: [0] }, x: ['-inf'] });
    const rows = await rowsOf('split');
    same(rows.column('case'), ['a', 'a', 'b'], 'texts');
    same(rows.column('x').map(String), ['1', 'NaN', '-Infinity'], 'numbers that are none');
    same((await rowsOf('split', 'b')).objects().map((row) => row.case), ['b'], 'of one case');
    same((await rowsOf('none')).objects(), [], 'a table without rows');
    same((await rowsOf('absent')).length, 0, 'a table that was not measured');
    hold(rows.has('x') && !rows.has('y'), 'columns');
  },
  async 'a file without data is an error, and waits for nothing'() {
    // Scripts of a page that load at once; late.js hands over its data.
    const load = page('load');
    context.document = { createElement: () => ({ addEventListener(name, work) { this[name] = work; }, setAttribute(name, value) { this[name] = value; }, append() {} }),
      head: { append: (script) => { if (script.src === 'data/late.js') send('late', [7]); setTimeout(script.src === 'data/absent.js' ? script.error : script.load); } } };
    const outcome = (name) => Promise.race([load(name).then(String, (error) => error.message), new Promise((resolve) => { setTimeout(resolve, 2000, 'it waits'); })]);
    same([await outcome('late'), await outcome('empty'), await outcome('absent')], ['7', 'data/empty.js holds no data of that name', 'data/absent.js is not there'], 'what load answers');
  },
  'a column of numbers and texts has one order, wherever it starts'() {
    const keys = [0.9, 'unstable', NaN, 0.1, '', 'any', Infinity, -2, 'unstable', 3], compareKeys = page('compareKeys');
    for (const a of keys) for (const b of keys) for (const c of keys) for (const down of [false, true]) {
      hold(Math.sign(compareKeys(a, b, down)) === -Math.sign(compareKeys(b, a, down)), `${a} and ${b}`);
      if (compareKeys(a, b, down) <= 0 && compareKeys(b, c, down) <= 0) hold(compareKeys(a, c, down) <= 0, `${a}, ${b}, ${c}: not transitive`);
    }
    for (let turn = 0; turn < keys.length; ++turn) {
      const turned = [...keys.slice(turn), ...keys.slice(0, turn)];
      same(turned.sort((a, b) => compareKeys(a, b, false)).map(String).slice(0, 8), ['-2', '0.1', '0.9', '3', 'Infinity', 'any', 'unstable', 'unstable'], 'up');
    }
  },
  // The last decade of time against the decade before.
  async 'how an error grows is the power of a pure power'() {
    const series = (id, power, invariant = 'energy', status = 'ok') => [1, 10, 100, 1000].map((time) => ({ case: id, library: 'odeum', solver: 'rk4', status: time === 1000 ? status : 'ok', detail: '', step: 0.1, time, invariant, relative_error: 1e-5 * time ** power, value: 1 - 1e-5 * time ** power }));
    give('drift', [...series('linear', 1), ...series('square', 2), ...series('bounded', 0), ...series('exact', 0).map((row) => ({ ...row, relative_error: 0 })), ...series('failed', 1, 'energy', 'newton_failed'), ...['energy', 'amplitude', 'phase'].flatMap((invariant) => series('osc_undamped', 1, invariant))]);
    vm.runInContext(read('src/odeum/studies/drift/view.js'), context);
    const found = (await rowsOf('drift_series')).objects().filter((row) => row.chosen === 'yes');
    same(found.map((row) => row.case), ['linear', 'square', 'bounded', 'exact', 'failed', 'osc_undamped'], 'a row a series');
    [1, 2, 0, 0, 1, 1].forEach((power, i) => near(found[i].power, power, `${found[i].case}: the power`));
    same(found.map((row) => row.mark), ['−2↗', '1⇑', '−5', '0', '✗', '−2↗'], 'marks: a power of ten and how it grows');
    same((await rowsOf('drift_oscillator')).length, 1, 'a row a solver');
  },
  async 'measured steps are compared with predicted ones'() {
    const row = (largest, predicted, status = 'ok') => ({ case: 'a', library: 'odeum', solver: 'rk4', status, detail: '', largest_stable_step: largest, predicted_step: predicted, eigenvalue_re: -100, eigenvalue_im: 0, window: 10 });
    give('largest_steps', [row(0.0202, 0.02), row(0.03, 0.02), row(0.03, 0), row(0.01, 0.02), row(0.01, Infinity), row(0.01, NaN), row(2.5, Infinity), row(2.5, 0.02), row(NaN, 0.02, 'newton_failed'), row(NaN, NaN, 'not_applicable')]);
    vm.runInContext(read('src/odeum/studies/limits/view.js'), context);
    const found = (await rowsOf('steps_judged')).objects();
    same(found.map((each) => each.agreement), ['as predicted', 'larger', 'larger', 'smaller', 'smaller', 'no theory', 'as predicted', 'larger', 'not bounded'], 'agreement; who was not run is left out');
    same(found.map((each) => each.any), ['no', 'no', 'no', 'no', 'no', 'no', 'yes', 'yes', 'no'], 'steps as large as were tried');
    same(found.slice(0, 2).map((each) => each.colour), ['confirmed', 'higher'], 'colours');
  },
  async 'orders that are lost have colours'() {
    const row = (lambda, order, error, verdict) => ({ library: 'odeum', solver: 'rk4', lambda, claimed_order: 4, measured_order: order, error_finest: error, order_low: order, order_high: order, points: 4, verdict, reason: 'of this test' });
    give('order_reduction', [row(-1e6, 1.9, 1e-9, 'lower'), row(-1, 4.02, 1e-12, 'confirmed'), row(-1e8, NaN, 1e-9, 'undetermined'), row(-10, 4.6, 1e-9, 'higher'), row(-100, 3.4, 1e-9, 'lower'), row(-1e5, 0.2, 2, 'lower')]);
    const rows = await rowsOf('order_reduction'), text = read('src/odeum/studies/reduction/page.md');
    const keyOf = (key) => new Template(new RegExp(`^${key}: (.*)$`, 'm').exec(text)[1]).bind(rows, new Map());
    same(rows.indices().map((i) => keyOf('shade').text(i, [i])), ['t2', 'confirmed', 'not_applicable', 'higher', 't1', 't3'], 'cells');
    same([[0], [1], [5]].map((some) => keyOf('keep').value(some[0], some)), [true, false, false], 'who gives no usable error where it is stiff is left out');
    vm.runInContext(read('src/odeum/studies/reduction/view.js'), context);
    const [solver] = (await rowsOf('reduction_solvers')).objects();
    same([solver.solver, solver.usable], ['odeum/rk4', 'yes'], 'a solver');
    near(solver.lost, 3.8, 'the most that is lost');
  },
  'a machine is disturbed where it drifts or is shared'() {
    vm.runInContext(read('src/odeum/studies/precision/view.js'), context);
    const limit = Number(/most_disturbance = ([0-9.]+);/.exec(read('src/odeum/studies/stopwatch.hpp'))[1]);
    hold(errorOf(() => functions.disturbed(0, 1)).includes('there is no figure'), 'without the limit of the program nothing is judged');
    page('facts').studies = [{ name: 'precision', figures: { most_disturbance: limit } }];
    same([[0.01, 0.99], [-0.12, 0.99], [0.01, 0.6], [0.06, 1]].map(([drift, share]) => functions.disturbed(drift, share)), [false, true, true, true], 'conditions');
  },
  'the remark on disturbed times names other programs where they had the processor only'() {
    const remark = (drift, share) => page('disturbedText')([{repetitions: 0}, {repetitions: 3, drift, processor_share: share}]);
    hold(remark(0.05, 0.95) === '', 'a remark within the limits');
    const changed = remark(-0.07, 1), shared = remark(0.01, 0.6);
    hold(/whose speed changed by 7 %/.test(changed) && !/other programs/.test(changed), changed);
    hold(/other programs ran: .* 60 % .* changed by 1 %/.test(shared), shared);
    // A value that was not measured is not a number.
    const unknown = [remark(NaN, 0.6), remark(0.2, NaN)];
    hold(unknown.every((text) => text && !text.includes('NaN')), unknown.join(' '));
  },
  'every expression of every page can be read'() {
    const studies = join(root, 'src/odeum/studies');
    let expressions = 0, pages = 0;
    const folders = readdirSync(studies, { withFileTypes: true }).filter((entry) => entry.isDirectory()).map((entry) => join(studies, entry.name));
    for (const folder of folders) if (existsSync(join(folder, 'view.js')) && !['drift', 'limits', 'precision', 'reduction'].some((name) => folder.endsWith(`/${name}`))) vm.runInContext(readFileSync(join(folder, 'view.js'), 'utf8'), context);
    // What figure('study.name') names, the program of the study gives: Declaration::figures.
    const programs = new Map(folders.map((folder) => [folder.slice(studies.length + 1), readFileSync(join(folder, 'study.cpp'), 'utf8')]));
    let figures = 0;
    for (const folder of folders) for (const file of readdirSync(folder).filter((name) => /\.(md|js)$/.test(name)))
      for (const [, study, name] of readFileSync(join(folder, file), 'utf8').matchAll(/figure\('([a-z]+)\.([a-z_]+)'\)/g)) {
        hold(programs.get(study)?.includes(`{"${name}", `), `${file} of ${folder}: figure ${study}.${name}`);
        ++figures;
      }
    hold(figures > 10, 'figures of the pages');
    const check = (source, where) => { const wrong = errorOf(() => new Template(source)); hold(wrong === 'no error', `${where}: ${wrong}`); ++expressions; };
    for (const folder of folders) for (const file of readdirSync(folder).filter((name) => name.endsWith('.md') && name !== 'columns.md')) {
      const where = join(folder, file).slice(studies.length + 1);
      ++pages;
      let rest = '';
      for (const [k, part] of readFileSync(join(folder, file), 'utf8').split(/^```/m).entries()) {
        if (k % 2 === 0) { rest += part; continue; }
        const [kind] = part.split('\n', 1), spec = specOf(part.slice(kind.length + 1));
        // Blocks of the page's own need its markdown reader or a browser; here are those of rows.
        if (!['table', 'matrix', 'chart', 'profile', 'duels'].includes(kind.trim())) continue;
        const [, condition] = /^[a-z_0-9]+\s+where\s+(.*)$/.exec(spec.rows) || [];
        if (condition) { hold(errorOf(() => parse(condition)) === 'no error', `${where}: ${errorOf(() => parse(condition))}`); ++expressions; }
        for (const key of ['columns', 'shade', 'tips', 'before']) for (const line of Array.isArray(spec[key]) ? spec[key] : []) {
          const { heading, cell } = columnOf(line);
          check(cell, where);
          hold(key !== 'columns' || !['', 'is', 'are', 'has', 'was'].includes(heading), `${where}: a column has the heading "${heading}"`);
        }
        const axes = ['chart', 'profile', 'duels'].includes(kind.trim()) ? ['by', 'facet', 'tip'] : ['sort', 'group', 'one', 'row', 'column', 'order', 'heading', 'cell', 'shade', 'tip', 'keep'];
        for (const key of axes) if (typeof spec[key] === 'string' && spec[key]) check(spec[key], where);
        for (const key of ['x', 'y']) if (spec[key]) { const wrong = errorOf(() => page('axisOf')(spec[key])); hold(wrong === 'no error', `${where}: ${wrong}`); }
      }
      for (const [, code, source] of rest.matchAll(/(`[^`]*`)|\{([^{}]+)\}/g)) if (code === undefined) check(`{${source.replace(/^\?/, '')}}`, where);
    }
    console.log(`${expressions} expressions on ${pages} pages`);
    hold(pages >= 5 && expressions > 100, 'pages of the studies');
    hold(Object.keys(blocks).length >= 3, 'blocks');
  },
};

checks['the lines of a matrix have a name'] = () => {
  for (const [template, name] of [[undefined, 'solver'], ['case', 'case'], ['{solver_group(library, solver)}', 'solver'], ['{divisions | d}', 'divisions'], ["{if(verdict == survived, 'none', caught_by)}", 'verdict'], ['{stiffness} N/m', 'stiffness']])
    same(page('nameOfRows')(template), name, String(template));
};

const flat = (tree) => typeof tree === 'string' ? `"${tree}"` : tree[0] === 'row' ? tree.slice(1).map(flat).join(' ') : tree[0] === 'space' ? '~' : ['over', 'power', 'below', 'primed', 'root'].includes(tree[0]) ? `${tree[0]}{${tree.slice(1).map((each) => typeof each === 'string' ? each : flat(each)).join('|')}}` : tree[1];
const formulas = (source) => page('partsOf')(source).map(flat).join(' ');
checks['equations are read as they were written'] = () => {
  for (const [source, expected] of [
    ["y'' + 0.5 y' = -5 y", "primed{y|′′} + 0.5 ~ primed{y|′} = − 5 ~ y"],
    ["y1' = k1 y2^2 / 2 d", "primed{below{y|1}|′} = over{below{k|1} ~ power{below{y|2}|2}|2} ~ d"],
    ['u = (a - b) / (2 d)', 'u = over{a − b|2 ~ d}'],
    ['u_{i-1}^2 = |q|^3', 'power{below{u|i − 1}|2} = power{| q ||3}'],
    ['y(0) = sin theta', 'y ( 0 ) = sin ~ θ'],
    ['x = sqrt(5) x^-1 * 1e-06', 'x = root{5} ~ power{x|− 1} · 1 · power{10|−6}'],
    // A name that the text gives a value is one; other words stay words.
    ['V = amplitude t; amplitude = 5', 'V = amplitude ~ t ";" amplitude = 5'],
    ["y' = -y from the start, cyclic", `primed{y|′} = − y " from the start" "," " cyclic"`],
    ["x[1..50]' = K*sum(j, x[j] - x[i])", 'primed{below{x|1 … 50}|′} = K · below{∑|j} ( below{x|j} − below{x|i} )'],
    ['M = 1/4 [4 -2; -2 4]', '"M = 1/4 [4 -2; -2 4]"'],
  ]) same(formulas(source), expected, source);
  for (const wrong of ['', 'a +', '(a', 'a)', 'a = = b', '^2', '<b>x</b>']) hold(errorOf(() => page('treeOf')(wrong)) !== 'no error', `${wrong} is a formula`);
};

checks['performance profiles count what was asked of whom'] = () => {
  const run = (id, wall_ns_min, error, near_error = error, status = 'ok') => ({ case: id, wall_ns_min, error, near_error, status, repetitions: 3, library: 'l', solver: 's' });
  const rows = [
    // On a, p is the fastest at 1e-3, since its faster run is a lucky one; q alone reaches 1e-6.
    run('a', 10, 1e-4, 1e-2), run('a', 20, 1e-4), run('a', 40, 1e-7),
    // On b, q takes 30; p was tried and reaches nothing, r does not fit and is not asked.
    run('b', 30, 1e-4), run('b', 5, 1), run('b', NaN, NaN, NaN, 'not_applicable'),
    // On c, nobody answers.
    run('c', 5, 1),
  ], names = ['p', 'p', 'q', 'q', 'p', 'r', 'q'];
  const questions = page('answersOf')(rows, names, [1e-3, 1e-6]);
  same(questions.map((each) => [each.case, each.error, [...each.times].flat(), [...each.tried]]), [['a', 1e-3, ['p', 20, 'q', 40], ['p', 'q']], ['a', 1e-6, ['q', 40], ['p', 'q']], ['b', 1e-3, ['q', 30], ['q', 'p']]], 'questions');
  const profile = (name, across = 'ratio') => page('profileOf')(questions, name, across);
  same(profile('p'), { asked: 3, points: [{ x: 1, y: 1 / 3 }] }, 'p wins one of three');
  same(profile('q'), { asked: 3, points: [{ x: 1, y: 2 / 3 }, { x: 2, y: 1 }] }, 'q wins two, and is twice the fastest on one');
  same(profile('q', 'time').points, [{ x: 30, y: 1 / 3 }, { x: 40, y: 1 }], 'times');
  same(profile('r'), { asked: 0, points: [] }, 'r was not asked');
  same([page('duelOf')(questions, 'p', 'q'), page('duelOf')(questions, 'q', 'p')], [{ count: 1, faster: 1, median: 2 }, { count: 1, faster: 0, median: 0.5 }], 'duels');
};

checks['a closed form is on no front'] = () => {
  const facts = page('facts'), before = facts.solverOf;
  facts.solverOf = new Map([['l/exact', { closed_form: true }]]);
  const run = (solver, ns, error) => ({ library: 'l', solver, ns, error });
  same(page('frontOf')([run('c', 4, 1e-9), run('exact', 1, 1e-16), run('a', 2, 1e-3), run('b', 3, 1e-2)], 'ns', 'error').map((row) => row.solver), ['a', 'c'], 'the front');
  facts.solverOf = before;
};

checks['a solver that is unstable at a step is not told that a larger one is enough'] = () => {
  const facts = page('facts'), before = { ...facts };
  Object.assign(facts, {
    caseOf: new Map([['c', { start: 0, end: 10, eigenvalues: [[-10, 0]], eigenvalues_time: 0 }]]),
    limits: [{ library: 'l', solver: 's', axis: 'real', limit: 2.8, status: 'ok' }],
  });
  const words = (finest) => page('functions').needed_step('c', 'l', 's', finest);
  same(words(0.5), ' It takes h < 0.28, 36 steps to t = 10: 2.8 / |λ|, λ = -10 at t = 0.', 'a limit below the steps tried');
  same(words(0.03), ' It is unstable at h = 0.03 still, below 2.8 / |λ| = 0.28 with λ = -10 at t = 0.', 'a limit above one of them');
  facts.limits = [];
  same([words(0.03), words(NaN)], [' It is unstable at h = 0.03 still.', ''], 'no limit known');
  Object.assign(facts, before);
};

for (const [name, check] of Object.entries(checks)) {
  try {
    await check();
    console.log(`ok: ${name}`);
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    process.exitCode = 1;
  }
}
