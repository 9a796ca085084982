// SPDX-License-Identifier: BSD-3-Clause
// node runs.mjs <chromium> <folder>: opens the pages of single problems (folder/case, diverged, vdp, why, scene, path, types, field, fine)
// as a reader would, from the disk, and fails on the first thing that does not hold.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from '../../scripts/viewer/browser.mjs';

const [chromium, folder] = process.argv.slice(2);
const hold = (condition, text) => { if (!condition) throw new Error(text); };
const browser = await Browser.open(chromium);
const open = async (name) => {
  await browser.go(`file://${folder}/${name}/index.html`);
  await browser.until(`document.documentElement.dataset.drawn || document.documentElement.dataset.error`);
  hold(await browser.run(`document.documentElement.dataset.error || ''`) === '', await browser.run(`document.documentElement.dataset.error`));
};
const all = (selector, of = 'e.textContent') => browser.run(`[...document.querySelectorAll(${JSON.stringify(selector)})].map((e) => ${of})`);
const titles = () => all('.figures figcaption strong');
const same = (found, expected, text) => hold(JSON.stringify(found) === JSON.stringify(expected), `${text}: ${JSON.stringify(found)}`);

const checks = {
  async 'a case: solvers beside the exact solution'() {
    await open('case');
    same(await titles(), ['y over time', 'u over time', 'State plane: u against y', 'Largest error over time', 'Energy, less that at the start'], 'figures');
    same(await all('tbody tr th'), ['odeum/explicit_euler', 'odeum/midpoint'], 'a row a solver');
    // In each figure but the error's the exact solution too.
    const names = await all('.figures figure', `[...e.querySelectorAll('.legend li')].map((l) => l.textContent)`);
    names.forEach((each, i) => { for (const name of ['odeum/explicit_euler', 'odeum/midpoint', ...(i === 3 ? [] : ['exact'])]) hold(each.includes(name), `figure ${i}: ${each}`); });
    hold((await all('.figures path.curve')).length >= 14, 'lines');
    hold((await all('nav.main a')).length === 0, 'views of a report, which this is not');
    same(await browser.run(`odeum.shortNames(['odeum/rk4', 'gsl/rk4', 'gsl/rkf45'])`), ['odeum/rk4', 'gsl/rk4', 'rkf45'], 'names of two libraries');
  },
  async 'status, answer, error and remarks are those of the folder'() {
    for (const name of ['case', 'diverged', 'why', 'scene', 'path']) {
      await open(name);
      const lines = readFileSync(join(folder, name, 'runs.csv'), 'utf8').trim().split('\n'), columns = lines[0].split(',');
      const rows = lines.slice(1).map((line) => {
        const fields = [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map((m) => m[1].replace(/^"|"$/g, '').replace(/""/g, '"'));
        return Object.fromEntries(columns.map((column, i) => [column, fields[i]]));
      });
      const shown = await all('tbody tr', `[...e.cells].map((c) => c.textContent)`), said = (await all('p.remark')).join('\n');
      same(shown.length, rows.length, name);
      rows.forEach((row, k) => {
        const [solver, status, error] = shown[k], answer = shown[k].at(-1);
        same(solver, `${row.library}/${row.solver}`, name);
        same(status, row.status + (row.detail ? `: ${row.detail}` : ''), name);
        hold(answer.includes(row.answer_reason), `${name}: ${answer}`);
        if (['wrong', 'explained', 'undetermined'].includes(row.answer)) hold(answer.startsWith(row.answer), `${name}: ${answer}`);
        hold(error === '–' ? row.error_max === 'nan' : Math.abs(Number(error) / Number(row.error_max) - 1) < 1e-3, `${name}: ${error}, ${row.error_max}`);
        hold(said.includes(row.remarks), `${name}: ${said}`);
      });
    }
  },
  async 'a run that diverged is not ok alone'() {
    await open('diverged');
    const shown = await all('tbody tr', `[0, 1, e.cells.length - 1].map((k) => e.cells[k].textContent)`);
    hold(/^wrong: the run ended ok and has diverged: an error of /.test(shown.find(([name]) => name === 'odeum/explicit_euler')[2]), String(shown));
    same(shown.find(([name]) => name === 'odeum/rk4'), ['odeum/rk4', 'ok', 'no error was promised'], 'who did not');
  },
  async 'a curve goes through the ends of steps: van der Pol reaches 1,333'() {
    await open('vdp');
    const labels = await all('[data-figure="v_over_time"] svg text', 'Number(e.textContent)');
    hold(labels.includes(1000) && labels.includes(-1000), String(labels));
  },
  async 'a body in a plane: its path'() {
    await open('path');
    const shown = await titles();
    same(shown.filter((title) => title.startsWith('Path')), ['Path: y against x'], 'the path');
    hold(shown.includes('Steps taken over time'), `an adaptive run has its steps: ${shown}`);
  },
  async 'why: strips of what bounds the steps, and the causes'() {
    await open('why');
    hold((await titles()).includes('What bounds the steps'), String(await titles()));
    const strips = await all('[data-figure="what_bounds_the_steps"] rect.bound', `[Number(e.getAttribute('width')), e.textContent]`);
    hold(strips.some(([width, text]) => width > 100 && text.startsWith('stability: ')), String(strips));
    hold((await all('dl.facts dt')).includes('stability'), 'the causes');
    same((await all('tbody tr th')).length, 2, 'the run and the better one');
  },
  async 'an advice: the answer, the runs of the race, and what was timed beside one another'() {
    await open('advice');
    const facts = Object.fromEntries(await all('dl.facts dt', `[e.textContent, e.nextSibling.textContent]`));
    hold(/^(odeum|gsl)\/[a-z0-9_]+ --(tol|step) .*: error /.test(facts.Answer), facts.Answer);
    hold(facts.run?.startsWith('odeum run lotka_volterra --solver '), JSON.stringify(facts));
    same(await titles(), ['Error against time'], 'figures');
    const timed = await all('tbody tr', `[...e.cells].map((c) => c.textContent)`);
    same(timed[0][0], facts.Answer.split(' ')[0], 'the winner stands first');
    same(timed[0][4], '1', 'the fastest is as fast as itself');
    hold(timed.length > 1 && timed.every((cells) => Number(cells[5]) <= 1e-4), JSON.stringify(timed));
    // A run of the race has its time; of those that were timed only one a solver has the bare one.
    const rows = readFileSync(join(folder, 'advice/race.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
    const [named] = rows, column = (name) => rows.slice(1).map((row) => row[named.indexOf(name)]);
    same(column('repetitions').filter((count) => Number(count) > 0).length, timed.length, 'timed rows of race.csv');
    hold(column('status').filter((status) => status === 'ok').length > timed.length, 'runs of the race');
  },
  async 'a sweep: a line over its parameter, the quantiles over time'() {
    await open('sweep');
    hold((await all('dl.facts dt')).includes('solved'), String(await all('dl.facts dt')));
    hold((await titles()).some((title) => title.endsWith(' over time')), String(await titles()));
    hold((await all('.figures path.curve')).length >= 2, 'lines');
  },
  async 'a scene: the plot of its file, energy, replays in step'() {
    await open('scene');
    hold((await titles()).length === 3, String(await titles()));
    same(await all('iframe', `e.getAttribute('src')`), ['odeum_explicit_euler/replay.html', 'odeum_midpoint/replay.html'], 'replays');
    hold((await all('input[aria-label="time of all replays"]')).length === 1, 'one time for all');
  },
  async 'a replay is saved as a film and as pictures'() {
    await browser.go(`file://${folder}/scene/odeum_midpoint/replay.html`);
    await browser.until(`document.documentElement.dataset.drawn || document.documentElement.dataset.error`);
    if (await browser.run(`document.documentElement.dataset.error || ''`) === 'no WebGL') return;
    for (const what of ['film', 'pictures']) {
      await browser.run(`document.getElementById('${what}').click(); 1`);
      await browser.until(`document.documentElement.dataset.${what}`);
      hold(await browser.run(`Number(document.documentElement.dataset.${what})`) > 1000, `no ${what}`);
    }
  },
  async 'types of an equation: regions, directions, the curve between them'() {
    await open('types');
    const picture = await all('svg.plot rect.type', `[e.getAttribute('class'), Number(e.getAttribute('y'))]`);
    hold(picture.some(([name]) => name === 'type elliptic') && picture.some(([name]) => name === 'type hyperbolic'), 'both types');
    // y > 0, elliptic, is above.
    const mean = (name) => { const some = picture.filter(([each]) => each === name); return some.reduce((sum, [, y]) => sum + y, 0) / some.length; };
    hold(mean('type elliptic') < mean('type hyperbolic'), 'the plane is upside down');
    same((await all('svg circle.parabolic')).length, 25, 'points of the curve');
    const strokes = (await all('path.directions', `e.getAttribute('d')`))[0];
    hold(strokes.split('M').length > 300 && !strokes.includes('NaN'), 'directions');
    same((await all('.legend li')).sort(), ['characteristic direction', 'elliptic', 'hyperbolic', 'parabolic'], 'the legend');
    hold((await all('h1'))[0] === 'y*u_xx + u_yy = 0', 'the equation');
  },
  async 'a field: a triangle each, which tells its value'() {
    await open('field');
    same(await titles(), ['Solution u', 'Error at the nodes'], 'figures');
    const triangles = await all('.figures figure:first-child .triangles path', `[e.getAttribute('fill'), e.textContent]`);
    same(triangles.length, 512, 'triangles');
    const values = triangles.map(([, text]) => Number(/: (\S+)$/.exec(text)[1]));
    hold(values.every((value) => value >= 0 && value < 0.08) && Math.max(...values) > 0.07, 'values of -div grad u = 1 on the unit square');
    const colours = new Map(triangles.map(([fill], i) => [values[i], fill]));
    hold(new Set(colours.values()).size > 20 && colours.get(Math.min(...values)) !== colours.get(Math.max(...values)), 'colours');
    hold((await all('.figures figure:first-child .scale rect')).length === 32, 'the scale');
  },
  async 'a mesh too fine to be drawn: words'() {
    await open('fine');
    hold((await all('.facts dd')).some((text) => text.includes('too many to draw')), 'it says so');
    hold((await all('svg.plot')).length === 0, 'nothing is drawn');
  },
  async 'a picture is saved as a file that stands alone'() {
    await open('types');
    const text = await browser.run(`new Promise((resolve) => { const make = URL.createObjectURL; URL.createObjectURL = (blob) => { blob.text().then(resolve); return make.call(URL, blob); }; document.querySelector('button.download').click(); })`);
    hold(text.startsWith('<svg') && text.includes('xmlns="http://www.w3.org/2000/svg"') && !text.includes('var(--') && /fill: ?rgb/.test(text), text.slice(0, 300));
  },
  async 'a telephone shows each without scrolling sideways, in both schemes'() {
    for (const dark of [false, true]) for (const name of ['case', 'path', 'scene', 'types', 'field', 'fine']) {
      await browser.size(390, 844, dark);
      await open(name);
      hold(await browser.run('document.documentElement.scrollWidth') <= 390, `${name}: wider than the screen`);
    }
    await browser.size(1280, 900);
  },
  async 'without scripts the page names its files'() {
    const index = readFileSync(join(folder, 'case/index.html'), 'utf8');
    for (const name of ['trajectory.csv', 'runs.csv', 'manifest.json']) hold(index.includes(`<a href="${name}">`), name);
    hold(!index.includes('<a href="schemes">'), 'rows for the page alone are not a file');
  },
};

await browser.size(1280, 900);
for (const [name, check] of Object.entries(checks)) {
  try {
    await check();
    hold(!browser.complaints.length, browser.complaints.join('; '));
    console.log(`ok: ${name}`);
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    process.exitCode = 1;
    break;
  }
}
await browser.close();
