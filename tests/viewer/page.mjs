// SPDX-License-Identifier: BSD-3-Clause
// node page.mjs <chromium> <report folder> [axe.min.js]: opens the report as a reader would, from the disk, and fails
// on the first thing that does not hold. What the views show is compared with the CSV files.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from '../../scripts/viewer/browser.mjs';

const [chromium, folder, axe] = process.argv.slice(2);
const hold = (condition, text) => { if (!condition) throw new Error(text); };
const same = (found, expected, text) => hold(JSON.stringify(found) === JSON.stringify(expected), `${text}: ${JSON.stringify(found)}, expected ${JSON.stringify(expected)}`);
const near = (a, b, relative, text) => hold(Math.abs(a - b) <= relative * Math.abs(b), `${text}: ${a}, expected ${b}`);

// Rows of a CSV file without line breaks in its fields.
const rowsOf = (file) => {
  const fields = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map((m) => m[1].replace(/^"|"$/g, '').replaceAll('""', '"'));
  const [head, ...lines] = readFileSync(join(folder, file), 'utf8').trimEnd().split('\n');
  const names = fields(head);
  return lines.map((line) => { const values = fields(line); return Object.fromEntries(names.map((name, i) => [name, values[i]])); });
};

const browser = await Browser.open(chromium);
const address = `file://${folder}/index.html`;
const text = (selector) => browser.run(`document.querySelector(${JSON.stringify(selector)})?.innerText || ''`);
const click = (selector) => browser.run(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); if (!e) throw new Error('nothing to click: ' + ${JSON.stringify(selector)}); e.click(); })()`);
const key = async (name) => { for (const type of ['keyDown', 'keyUp']) await browser.send('Input.dispatchKeyEvent', { type, key: name, code: name, windowsVirtualKeyCode: { Tab: 9, ArrowRight: 39, Enter: 13 }[name], ...(name === 'Enter' && type === 'keyDown' ? { text: '\r' } : {}) }); };
const drawn = () => browser.until(`document.documentElement.dataset.drawn`);
// The content of page.json, and the addresses of everything that the report can show.
const facts = JSON.parse(readFileSync(join(folder, 'page.json'), 'utf8'));
const addresses = ['#answers', '#compare', '#regions', '#cases', '#methods', '#methods?solver=odeum/rk4', '#studies', '#data',
  ...facts.studies.flatMap((study) => study.pages.map((page) => `#study?page=${page.id}`)), ...facts.cases.map((c) => `#case?id=${c.id}`), ...facts.documents.map((name) => `#document?name=${name}`)];
// The table behind the comparison, as the page shows it.
const table = () => browser.run(`[...document.querySelectorAll('[data-numbers="compare"] tbody tr')].map((tr) => [...tr.cells].map((td) => td.textContent))`);

// The rules of accessibility on the page that is open, once for each structure of a page and width: elements with their classes and roles,
// each under its parent's. The pages of sixty cases that a small report does not measure are one to it.
const source = axe ? readFileSync(axe, 'utf8') : '', structures = new Set(), faults = [];
const inspect = async (hash, width) => {
  if (!axe) return;
  const structure = await browser.run(`(() => { const name = (e) => [e.tagName, e.getAttribute('class') || '', e.getAttribute('role') || '', e.tabIndex >= 0].join('.'); return [...new Set([...document.querySelectorAll('body *:not(math *)')].map((e) => name(e.parentElement) + '>' + name(e)))].sort().join(' '); })()`);
  if (structures.has(`${width} ${structure}`)) return;
  structures.add(`${width} ${structure}`);
  await browser.run(`${source}; 0`);
  const found = await browser.run(`axe.run(document, { preload: false, resultTypes: ['violations'] }).then(({ violations }) => violations.map((v) => v.id + ' (' + v.nodes.length + '): ' + v.nodes[0].html.slice(0, 160)))`);
  faults.push(...found.map((fault) => `${hash} at ${width}: ${fault}`));
};

const checks = {
  async 'the first screen names the fastest of the file at every error'() {
    const fastest = rowsOf('fastest.csv');
    for (const error of ['1e-3', '1e-6', '1e-9']) {
      await browser.go(`${address}#answers?case=damped_oscillator_underdamped&error=${error}`);
      await browser.until(`document.querySelector('.answer')`);
      const [best] = fastest.filter((row) => row.case === 'damped_oscillator_underdamped' && Math.abs(row.error / error - 1) < 1e-6).sort((a, b) => a.wall_ns_min - b.wall_ns_min);
      hold((await text('.answer')).startsWith(`${best.library}/${best.solver} reaches`), `${error}: ${await text('.answer')} does not begin with ${best.solver}`);
    }
  },
  async 'a document shows its tables, and no comment of the programs that write them'() {
    for (const name of facts.documents) {
      await browser.go(`${address}#document?name=${name}`);
      await browser.until(`document.querySelector('.prose h1')`);
      hold(!(await text('body')).includes('<!--'), `${name} shows a comment`);
    }
    await browser.go(`${address}#document?name=speed`);
    await browser.until(`document.querySelectorAll('.prose table.words tbody tr').length >= 10`);
  },
  async 'every problem and error can be chosen, and says something'() {
    await browser.go(address);
    await drawn();
    const problems = await browser.run(`[...document.querySelectorAll('[aria-label="problem"] button')].map((b) => b.dataset.value)`);
    hold(problems.length >= 7, `only ${problems.length} problems`);
    for (const problem of problems) {
      await click(`[aria-label="problem"] [data-value="${problem}"]`);
      await browser.until(`location.hash.includes('case=${problem}') && document.querySelector('.answer')`);
      for (const error of ['1e-3', '1e-9']) { await click(`[aria-label="error"] [data-value="${error}"]`); await browser.until(`document.querySelector('.answer').innerText.length > 20`); }
    }
  },
  async 'two solvers stand side by side in three clicks, with the numbers of convergence.csv'() {
    await browser.go(`${address}#compare?case=damped_oscillator_underdamped&x=step&show=`);
    await drawn();
    for (const solver of ['odeum/rk4', 'gsl/rk4']) {
      await browser.run(`(() => { const e = document.querySelector('input[type=search]'); e.value = '${solver}'; e.dispatchEvent(new Event('input')); })()`);
      await click(`[data-key="${solver}:fixed"]`);
      await browser.until(`location.hash.includes('${solver}:fixed')`);
    }
    await browser.until(`document.querySelectorAll('[data-view="compare"] .plot .name').length === 2`);
    const shown = await table();
    const rows = rowsOf('convergence.csv').filter((row) => row.case === 'damped_oscillator_underdamped' && row.mode === 'fixed' && row.solver === 'rk4' && row.status === 'ok' && row.error_max > 0 && row.error_max < 500);
    hold(rows.length > 10 && shown.length === rows.length, `${shown.length} points of ${rows.length} rows`);
    for (const row of rows) {
      const found = shown.find((cells) => cells[1] === row.library && Math.abs(Number(cells[5]) / row.step - 1) < 1e-6);
      hold(found, `no point of ${row.library} at ${row.step}`);
      near(Number(found[6]), Number(row.error_max), 1e-6, `error of ${row.library} at ${row.step}`);
    }
  },
  async 'a run can be reached by keys and gives a command'() {
    await browser.run(`document.querySelector('[data-view="compare"] .plot').focus()`);
    await key('ArrowRight');
    hold((await text('[data-view="compare"] .tip')).includes('error'), 'no tooltip');
    await key('Enter');
    hold(/^odeum run damped_oscillator_underdamped --solver \S+ --steps [0-9]+ --stops orders$/.test(await text('.run-panel code')), await text('.run-panel code'));
  },
  async 'axes, fronts and chips of the comparison work, and the address keeps them'() {
    for (const x of ['evaluations', 'time', 'steps', 'tolerance', 'step']) { await click(`[aria-label="across"] [data-value="${x}"]`); await browser.until(`location.hash.includes('x=${x}')`); }
    for (const y of ['rms', 'energy', 'error']) { await click(`[aria-label="up"] [data-value="${y}"]`); await browser.until(`document.querySelector('[aria-label="up"] [data-value="${y}"]').ariaChecked === 'true'`); }
    await click('[aria-label="remove gsl/rk4:fixed"]');
    await browser.until(`!location.hash.includes('gsl/rk4')`);
    const hash = await browser.run('location.hash');
    await browser.go(address + hash);
    await drawn();
    hold(await browser.run('location.hash') === hash, 'the address changed');
    hold((await text('.chips')).includes('odeum/rk4') && !(await text('.chips')).includes('gsl/rk4'), `the choice is lost: ${await text('.chips')}`);
  },
  async 'from the first screen two solvers take four clicks and one word typed'() {
    await browser.go(address);
    await drawn();
    let clicks = 0;
    const pick = async (selector) => { await click(selector); clicks += 1; };
    await pick('nav.main a[href^="#compare"]');
    await browser.until(`document.querySelector('[data-view="compare"] .chips button')`);
    const none = await browser.run(`(() => { const b = [...document.querySelectorAll('[data-view="compare"] .chips button')].find((e) => e.textContent === 'none'); b.dataset.test = 'none'; return Boolean(b); })()`);
    hold(none, 'no button that empties the comparison');
    await pick('[data-test="none"]');
    await browser.run(`(() => { const e = document.querySelector('[data-view="compare"] input[type=search]'); e.value = 'rk4'; e.dispatchEvent(new Event('input')); })()`);
    for (const solver of ['odeum/rk4', 'gsl/rk4']) await pick(`[data-key="${solver}:fixed"]`);
    await browser.until(`document.querySelectorAll('[data-view="compare"] .plot .name').length === 2`);
    hold(clicks === 4, `${clicks} clicks`);
  },
  async 'the first screen answers for a pendulum, a stiff reaction and a cloth, a click each'() {
    await browser.go(address);
    await drawn();
    for (const [problem, work] of [['pendulum_large', /Its run: .* steps?, .* evaluations? of f/], ['robertson_40', /Its run: .* Jacobians?/], ['cloth11_two_way', /That of [a-z]+\/\S+: .* for each evaluation/]]) {
      await click(`[aria-label="problem"] [data-value="${problem}"]`);
      await browser.until(`location.hash.includes('case=${problem}') && document.querySelector('.answer')`);
      const answer = await text('[data-view="answers"]');
      // A reason is what runs counted: no word on a kind of method or of problem.
      hold(!/stiff|smooth|explicit|implicit|symplectic|Why:/.test(answer.replace(/Stiff reaction|\S+\/\S+/g, '')), `${problem}: a reason that was not measured: ${answer}`);
      hold(/reaches 1e-6 in/.test(answer) && work.test(answer) && /odeum run/.test(answer), `${problem}: ${answer}`);
      hold(await browser.run(`document.querySelector('.answer').getBoundingClientRect().bottom < innerHeight`), `${problem}: the answer is below the first screen`);
    }
  },
  async 'every page is drawn, without a block or a sentence that could not be shown'() {
    const taken = {};
    for (const hash of addresses) {
      await browser.go(address + hash);
      await drawn();
      taken[hash] = await browser.run(`performance.now()`);
      const wrong = await browser.run(`[document.documentElement.dataset.error || '', ...[...document.querySelectorAll('[role=alert]')].map((e) => e.textContent)].filter(Boolean)`);
      hold(!wrong.length, `${hash}: ${wrong.join('; ')}`);
      hold(await browser.run(`document.querySelectorAll('h1').length`) === 1 || hash.startsWith('#document'), `${hash}: not one h1`);
      await inspect(hash, 1280);
    }
    const slowest = Object.entries(taken).sort((a, b) => b[1] - a[1]).slice(0, 3);
    console.log(`${addresses.length} pages; the slowest, in ms: ${slowest.map(([hash, ms]) => `${hash} ${Math.round(ms)}`).join(', ')}`);
    // No test depends on a time on a shared machine: this finds a page that hangs.
    for (const [hash, ms] of slowest) hold(ms < 120000, `${hash}: ${ms} ms`);
  },
  async 'the page adds one name to those of the browser, beside the two of its libraries'() {
    for (const hash of ['#answers', '#study?page=convergence', '#study?page=stability', '#study?page=precision', '#study?page=drift']) {
      await browser.go(address + hash);
      await drawn();
      const added = await browser.run(`(() => { const f = document.body.appendChild(document.createElement('iframe')), own = new Set(Object.getOwnPropertyNames(f.contentWindow)); f.remove(); return Object.getOwnPropertyNames(window).filter((name) => !own.has(name) && !/^[0-9]+$/.test(name)); })()`);
      hold(String(added.sort()) === 'd3,markdownit,odeum', `${hash}: ${added}`);
      // A const or class of a script is not a property of the window, but would be found by its
      // name.
      hold(await browser.run(`[typeof facts, typeof html, typeof Rows, typeof blocks].every((kind) => kind === 'undefined')`), `${hash}: names of scripts are global`);
    }
  },
  async 'numbers inside prose are those of the rows'() {
    await browser.go(`${address}#study?page=verdicts`);
    await drawn();
    const rows = rowsOf('orders.csv'), shown = await text('main');
    for (const verdict of ['failed', 'undetermined', 'lower']) {
      const count = rows.filter((row) => row.verdict === verdict).length;
      if (count) hold(shown.includes(count.toLocaleString('en')), `${count} pairs are ${verdict}; the page does not say so`);
    }
  },
  async 'a table is sorted by a click and filtered by a word'() {
    await browser.go(`${address}#case?id=free_fall&part=convergence`);
    await drawn();
    await browser.until(`document.querySelector('.table-host input[type=search]')`);
    const found = await browser.run(`(() => { const t = [...document.querySelectorAll('.table-host')].find((e) => e.querySelector('input[type=search]') && /verdict/.test(e.querySelector('thead').textContent)); if (!t) return null; t.dataset.test = 'sorted'; return t.querySelectorAll('thead button.sort').length; })()`);
    hold(found > 2, 'no table with headings to click on');
    await click('[data-test="sorted"] thead button.sort');
    const names = await browser.run(`[...document.querySelectorAll('[data-test="sorted"] tbody tr th')].map((e) => e.textContent)`);
    hold(names.length > 5 && names.every((name, i) => !i || names[i - 1] <= name), `not sorted: ${names.slice(0, 6)}`);
    await browser.run(`(() => { const e = document.querySelector('[data-test="sorted"] input[type=search]'); e.value = 'odeum rk4'; e.dispatchEvent(new Event('input')); })()`);
    const kept = await browser.run(`[...document.querySelectorAll('[data-test="sorted"] tbody tr')].map((e) => e.textContent)`);
    hold(kept.length > 0 && kept.every((line) => /odeum/.test(line) && /rk4/.test(line)), `not filtered: ${kept.slice(0, 3)}`);
  },
  async 'the run is drawn beside the exact one, and the address keeps it'() {
    const row = rowsOf('convergence.csv').filter((r) => r.case === 'damped_oscillator_underdamped' && r.library === 'odeum' && r.solver === 'explicit_euler' && r.mode === 'fixed' && r.error_max > 0.05 && r.error_max < 5)[0];
    await browser.go(`${address}#compare?case=damped_oscillator_underdamped&x=step&show=odeum/explicit_euler:fixed&run=odeum/explicit_euler:fixed:${Number(Number(row.step).toPrecision(6))}`);
    await drawn();
    await browser.until(`document.querySelectorAll('.solution .plot').length === 4`);
    const shown = await browser.run(`[...document.querySelectorAll('[data-numbers="solution"] tbody tr')].map((tr) => [...tr.cells].map((td) => Number(td.textContent)))`);
    // The study measures at stops, the curve has more times; logarithms are rounded to 1.2 %.
    const stops = execFileSync('gzip', ['-dc', join(folder, 'convergence_times.csv.gz')], { maxBuffer: 2 ** 30 }).toString().split('\n').map((line) => line.split(',')).filter((f) => f[1] === row.case && f[2] === 'odeum' && f[3] === 'explicit_euler' && f[4] === 'fixed' && Math.abs(f[5] / row.step - 1) < 1e-6);
    hold(stops.length > 0, 'no stop of the run in convergence_times.csv.gz');
    for (const stop of stops) {
      const found = shown.find((cells) => Math.abs(cells[0] / stop[6] - 1) < 1e-3);
      hold(found, `no output at t = ${stop[6]}`);
      near(found[3], Number(stop[7]), 0.02, `error at t = ${stop[6]}`);
    }
    hold(/off/.test(await text('.solution-words')) && /closed form/.test(await text('.solution-words')), await text('.solution-words'));
  },
  async 'a method has a page with every problem of the report'() {
    await browser.go(`${address}#methods?solver=odeum/rk4`);
    await drawn();
    const cases = new Set(rowsOf('convergence.csv').map((row) => row.case));
    await browser.until(`document.querySelectorAll('[data-numbers="method"] tbody [data-case]').length >= ${cases.size}`);
    for (const id of cases) hold((await text(`[data-numbers="method"] [data-case="${id}"]`)).length > 20, `nothing on ${id}`);
    hold((await text('.method')).includes('2.7853'), 'not the limit of rk4 on the real axis');
    await browser.run(`(() => { const e = document.querySelector('[aria-label="method"]'); e.closest('details').open = true; e.value = 'cvode'; e.dispatchEvent(new Event('input')); })()`);
    hold((await browser.run(`document.querySelectorAll('.method-list a').length`)) > 1 && !(await text('.method-list')).includes('rk4'), 'the search does not select');
  },
  async 'the cloth is replayed in step, beside the exact motion'() {
    const replays = rowsOf('replays.csv');
    hold(replays.length >= 4 && replays[0].remark === 'exact', `${replays.length} replays`);
    for (const row of replays.slice(1)) hold(row.error > 1e-6 && row.error < 1, `error of a cloth of 1 m: ${row.error}`);
    await browser.go(`${address}#study?page=replays`);
    await drawn();
    await browser.until(`document.querySelectorAll('.replays iframe').length === ${replays.length}`);
    for (const row of replays) hold((await text('main')).includes(`${row.library}/${row.solver}`), `${row.solver} is not named`);
  },
  async 'regions lie over each other, and the slider moves the eigenvalues out of them'() {
    await browser.go(`${address}#regions?case=damped_oscillator_underdamped&show=odeum/rk4,odeum/explicit_euler`);
    await drawn();
    hold(await browser.run(`document.querySelectorAll('[data-view="regions"] svg.plot .region-line').length`) === 2, 'not two regions');
    const slide = (value) => browser.run(`(() => { const e = document.querySelector('[aria-label="step h"]'); e.value = ${value}; e.dispatchEvent(new Event('input')); return document.querySelectorAll('.eigenvalue.out').length; })()`);
    hold(await slide(Math.log10(0.05)) === 0, 'a small step is unstable');
    hold(await slide(Math.log10(0.5)) === 2, 'Euler is stable at h = 0.5, where |1 + z| = 1.39');
    for (const limit of rowsOf('stability_limits.csv').filter((row) => row.library === 'odeum' && row.solver === 'rk4' && row.axis === 'real'))
      hold((await text('[data-view="regions"] table')).includes(String(Number(Number(limit.limit).toPrecision(6)))), 'the limit of rk4 is not that of the file');
    await click('[data-value="oscillator"]');
    await browser.until(`location.hash.includes('oscillator')`);
  },
  async 'the tab key reaches every control, in the order of the page, and each has a name'() {
    await browser.go(`${address}#compare?case=damped_oscillator_underdamped&x=step&show=odeum/rk4:fixed,gsl/rk4:fixed`);
    await drawn();
    // The arrows reach the others of a group of which one is chosen; the list of methods is opened on demand.
    const count = await browser.run(`(() => {
      const all = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')].filter((e) => e.tabIndex >= 0 && !e.disabled && e.checkVisibility());
      all.forEach((e, i) => { e.dataset.place = i; });
      getSelection().removeAllRanges();
      document.activeElement.blur();
      return all.length;
    })()`);
    const reached = [];
    // What scrolls is a stop of Chromium's own.
    for (let i = 0; i < count + 20 && reached.length < count; ++i) { await key('Tab'); const place = await browser.run(`document.activeElement.dataset.place`); if (place !== undefined) reached.push(Number(place)); }
    const missed = [...Array(count).keys()].filter((i) => !reached.includes(i));
    hold(missed.length === 0, `not reached: ${await browser.run(`JSON.stringify(${JSON.stringify(missed.slice(0, 5))}.map((i) => document.querySelector('[data-place="' + i + '"]').outerHTML.slice(0, 120)))`)}`);
    hold(reached.every((place, i) => place === i), `out of order: ${reached.slice(0, 40)}`);
    const { nodes } = await browser.send('Accessibility.getFullAXTree');
    const nameless = nodes.filter((node) => !node.ignored && node.properties?.some((p) => p.name === 'focusable' && p.value.value) && node.role.value !== 'RootWebArea' && !node.name?.value);
    hold(nameless.length === 0, `without a name: ${nameless.slice(0, 5).map((node) => node.role.value)}`);
  },
  async 'the first stop skips what stands above the view, and stays in it'() {
    await browser.go(`${address}#cases`);
    await drawn();
    await key('Tab');
    hold((await browser.run(`document.activeElement.className`)) === 'skip', 'the skip link is not the first stop');
    hold((await browser.run(`document.querySelectorAll('nav.main a').length`)) <= 8, 'more than eight entries of navigation');
    await key('Enter');
    same(await browser.run(`[document.activeElement.id, location.hash, document.documentElement.dataset.drawn]`), ['main', '#cases', 'cases'], 'after the skip link');
  },
  async 'a choice keeps the focus'() {
    const chosen = `(() => { const e = document.activeElement; return [e.closest('[role="radiogroup"]')?.getAttribute('aria-label'), e.getAttribute('aria-checked'), e.dataset.value]; })()`;
    for (const [hash, group] of [['#answers', 'problem'], ['#answers', 'error'], ['#compare?case=damped_oscillator_underdamped&x=step', 'across'], ['#regions', 'plane']]) {
      await browser.go(address + hash);
      await drawn();
      await browser.run(`document.querySelector('[aria-label="${group}"] [aria-checked="true"]').focus()`);
      const [, , before] = await browser.run(chosen);
      await key('ArrowRight');
      await browser.until(`document.querySelector('[aria-label="${group}"] [aria-checked="true"]').dataset.value !== '${before}'`);
      await browser.until(`document.activeElement !== document.body`);
      const [name, checked] = await browser.run(chosen);
      same([name, checked], [group, 'true'], hash);
    }
    await browser.go(`${address}#compare?case=damped_oscillator_underdamped&x=step&show=odeum/rk4:fixed,gsl/rk4:fixed`);
    await drawn();
    await browser.run(`document.querySelector('[aria-label="remove odeum/rk4:fixed"]').focus()`);
    await key('Enter');
    await browser.until(`!location.hash.includes('odeum/rk4') && document.activeElement !== document.body`);
    hold(await browser.run(`Boolean(document.activeElement.closest('.chips'))`), 'the focus left the chips');
  },
  async 'what a cell tells is read by keys and by a tap'() {
    await browser.go(`${address}#study?page=convergence`);
    await drawn();
    await browser.run(`document.querySelector('.wide[aria-label^="table; arrow"]').focus()`);
    for (let i = 0; i < 2; ++i) await key('ArrowRight');
    const [told, title, count] = await browser.run(`[document.querySelector('.told').textContent, document.querySelector('td.at').title, document.querySelectorAll('.at').length]`);
    hold(title.length > 10 && told.includes(title) && /^[a-z]+\/\S+, /.test(told) && count === 1, `${told} does not tell ${title}`);
    await browser.run(`(() => { const cells = document.querySelectorAll('.table-host td[title]'); cells[cells.length - 1].click(); })()`);
    hold(await browser.run(`[...document.querySelectorAll('.told')].some((e) => e.textContent.endsWith(document.querySelector('td.at:not(:first-child)').title))`), 'a tap tells nothing');
  },
  async 'on paper there is the content alone'() {
    await browser.go(`${address}#answers`);
    await drawn();
    await browser.send('Emulation.setEmulatedMedia', { media: 'print' });
    const shown = await browser.run(`['nav.main', '.skip', '.controls', '.answer'].map((name) => document.querySelector(name).checkVisibility())`);
    await browser.send('Emulation.setEmulatedMedia', { media: '' });
    same(shown, [false, false, false, true], 'navigation, skip link, controls, answer');
  },
  async 'a case opens with its solution, its equation and its answers, and ends with counts'() {
    await browser.go(`${address}#case?id=damped_oscillator_underdamped`);
    await drawn();
    await browser.until(`document.querySelector('[data-figure="exact-time"] path.curve')`);
    const places = await browser.run(`[...document.querySelectorAll('[data-figure="exact-time"] svg.plot, main dl.facts, main .table-host, .panels, h2')].map((e) => (e.tagName === 'H2' ? e.textContent : e.matches('svg') ? 'picture' : e.matches('dl') ? 'facts' : e.matches('.panels') ? 'charts' : 'table'))`);
    same([places.slice(0, 3), places.filter((name) => !['facts', 'charts', 'table'].includes(name)).at(-1)], [['picture', 'facts', 'table'], 'Verdicts, counted'], `the order of ${places}`);
    hold((await text('main .table-host')).includes('fastest method'), 'no answers');
    same(await browser.run(`[...document.querySelectorAll('main dl.facts dt')].filter((e) => e.nextSibling.querySelector('math')).map((e) => e.textContent)`), ['Equation', 'form', 'solution', 'solution'], 'what is typeset');
  },
  async 'names at the ends of curves are whole'() {
    for (const width of [1280, 900, 700]) {
      await browser.size(width, 900);
      for (const hash of ['#answers?case=robertson_40', '#answers?case=cloth11_two_way', '#compare?case=damped_oscillator_underdamped&x=time', '#case?id=robertson_40']) {
        await browser.go(address + hash);
        await drawn();
        await browser.until(`document.querySelector('svg.plot .curve')`);
        const cut = await browser.run(`[...document.querySelectorAll('svg.plot .name')].filter((e) => e.firstChild.textContent.includes('…') || e.getBoundingClientRect().right > e.ownerSVGElement.getBoundingClientRect().right + 1).map((e) => e.textContent)`);
        hold(!cut.length, `${hash} at ${width}: ${cut}`);
      }
    }
    await browser.size(1280, 900);
  },
  async 'a solver that was stable at no step has its own sign, and what it takes'() {
    const row = rowsOf('orders.csv').find((each) => each.case === 'robertson_40' && each.solver === 'rk4' && each.library === 'odeum' && each.mode === 'fixed');
    same([row.verdict, row.no_order], ['failed', 'unstable'], 'rk4 on a stiff reaction');
    await browser.go(`${address}#study?page=convergence`);
    await drawn();
    const [shown, tip, style] = await browser.run(`(() => { const t = document.querySelector('table.matrix'), k = [...t.querySelectorAll('thead th')].findIndex((e) => e.textContent === 'robertson_40'), tr = [...t.tBodies[0].rows].find((e) => e.cells[0].textContent === 'odeum/rk4'); return [tr.cells[k].textContent, tr.cells[k].title, tr.cells[k].className]; })()`);
    same([shown, style], ['↯', 'unstable'], 'the cell');
    const [, step] = / takes h < (\S+),/.exec(tip) || [], limit = rowsOf('stability_limits.csv').find((each) => each.solver === 'rk4' && each.library === 'odeum' && each.axis === 'real').limit;
    const fastest = Math.max(...facts.cases.find((c) => c.id === 'robertson_40').eigenvalues.map(([re]) => -re));
    near(Number(step), limit / fastest, 0.05, `two digits of the step in: ${tip}`);
    await browser.go(`${address}#methods?solver=odeum/rk4`);
    await browser.until(`document.querySelector('[data-numbers="method"] [data-case="robertson_40"]')`);
    hold(/unstable at the steps tried. It takes h < /.test(await text('[data-numbers="method"] [data-case="robertson_40"]')), 'not so on the page of the method');
  },
  async 'a run that diverged is not ok alone'() {
    const { id, scale } = facts.cases.find((c) => c.id === 'damped_oscillator_underdamped');
    await browser.go(`${address}#compare?case=${id}&x=step&show=odeum/explicit_euler:fixed`);
    await drawn();
    const off = (await table()).filter((cells) => cells[9] === 'ok' && Number(cells[6]) > scale);
    hold(off.length > 0, 'explicit Euler diverged at no step');
    for (const cells of off) hold(/^(diverged|a wrong answer): /.test(cells[10]), `${cells}`);
  },
  async 'every chart has a description, and its view a table'() {
    for (const view of ['answers', 'compare', 'regions']) {
      await browser.go(`${address}#${view}`);
      await drawn();
      hold(await browser.run(`[...document.querySelectorAll('[data-view="${view}"] svg.plot')].every((e) => e.getAttribute('role') === 'img' && e.getAttribute('aria-label').length > 20)`), `${view}: a chart without a description`);
      hold(await browser.run(`document.querySelectorAll('[data-view="${view}"] table td').length`) > 3, `${view}: no table`);
    }
  },
  async 'nonsense in the address leads to a page all the same'() {
    for (const hash of ['#compare?case=%&x=up&show=<b>,odeum/none:fixed,,%E0', '#answers?case=none&error=7', '#regions?show=none&h=-1&plane=x&case=none', '#data?x', '#%', '#document?name=none', '#study?page=<i>', '#case?id=none']) {
      await browser.go(address + hash);
      await drawn();
      hold(await browser.run(`document.querySelectorAll('main b b, main h1 i, main p i').length`) === 0, `${hash} is not taken as text`);
      hold((await text('main')).length > 30, `${hash}: nothing is shown`);
    }
  },
  async 'a telephone shows every page without scrolling sideways, in both schemes'() {
    await browser.size(390, 844, true);
    for (const hash of addresses.slice(0, 3)) {
      await browser.go(address + hash);
      await drawn();
      hold(await browser.run('document.documentElement.scrollWidth') <= 390, `${hash}: wider than the screen`);
    }
    await browser.size(390, 844);
    await browser.go(address);
    await drawn();
    // From page to page by its links, as a reader comes there.
    for (const hash of addresses) {
      await browser.run(`(() => { delete document.documentElement.dataset.drawn; location.hash = ''; location.hash = ${JSON.stringify(hash)}; })()`);
      await drawn();
      hold(await browser.run('document.documentElement.scrollWidth') <= 390, `${hash}: wider than the screen`);
      await inspect(hash, 390);
    }
    await browser.size(1280, 900);
  },
  async 'axe finds no fault, at both widths'() {
    if (!axe) return console.log('axe-core is not there (npm install axe-core): not checked');
    hold(!faults.length, faults.join('\n  '));
    return console.log(`${structures.size} structures of ${addresses.length} pages at two widths`);
  },
};

let failures = 0;
await browser.size(1280, 900);
for (const [name, check] of Object.entries(checks)) {
  const start = performance.now();
  try { await check(); console.log(`ok, ${((performance.now() - start) / 1000).toFixed(1)} s: ${name}`); } catch (error) { failures += 1; console.log(`FAILED: ${name}: ${error.message}`); }
}
for (const complaint of browser.complaints) { failures += 1; console.log(`the browser complains: ${complaint}`); }
await browser.close();
process.exit(failures ? 1 : 0);
