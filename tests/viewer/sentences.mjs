// SPDX-License-Identifier: BSD-3-Clause
// node sentences.mjs <chromium> <report folder> [seed]: thirty sentences with numbers, picked at random among those of the
// studies' texts and of the first screen, stand on the page with the numbers that the CSV files give. Expressions are
// evaluated here, by code that the page does not share; sentences with others than these are left out of the draw.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from '../../scripts/viewer/browser.mjs';

const [chromium, folder, seed = '30'] = process.argv.slice(2), wanted = 30;
const facts = JSON.parse(readFileSync(join(folder, 'page.json'), 'utf8'));

const fieldsOf = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map((m) => m[1].replace(/^"|"$/g, '').replaceAll('""', '"'));
const valueOf = (text) => (text === '' ? '' : text === 'nan' ? NaN : /^-?inf$/.test(text) ? Number(text.replace('inf', 'Infinity')) : Number.isNaN(Number(text)) ? text : Number(text));
const tables = new Map();
const tableOf = (name) => {
  const entry = facts.tables.find((table) => table.name === name);
  if (!entry || !entry.rows || !entry.file.endsWith('.csv')) return entry && !entry.rows ? [] : null;
  if (!tables.has(name)) {
    const [head, ...lines] = readFileSync(join(folder, entry.file), 'utf8').trimEnd().split('\n'), names = fieldsOf(head);
    tables.set(name, lines.map((line) => Object.fromEntries(fieldsOf(line).map((text, i) => [names[i], valueOf(text)]))));
  }
  return tables.get(name);
};

// count(orders where verdict == lower), max(error of replays) | .1e: names of columns, numbers, words, and, or, not.
const figures = Object.assign({}, ...facts.studies.map((study) => Object.fromEntries(Object.entries(study.figures || {}).map(([key, value]) => [`${study.name}.${key}`, value]))));
class Left extends Error {}
// Verdicts that nobody judged are named here again, as columns.md defines them.
const called = {
  known: '(x=>x===x&&x!=="")', abs: 'Math.abs',
  is_judged: "(x=>!['not_applicable','over_budget'].includes(x))",
};
const inRow = (text) => {
  const words = /'([^']*)'|([A-Za-z_][A-Za-z_0-9]*)|([0-9.]+(?:e-?[0-9]+)?)|(==|!=|<=|>=|[-<>+*/()])|\s+/gy, code = [];
  let at = 0;
  for (const m of text.matchAll(words)) {
    if (m.index !== at) break;
    at += m[0].length;
    if (m[1] !== undefined) code.push(JSON.stringify(m[1]));
    else if (['and', 'or', 'not'].includes(m[2])) code.push({ and: '&&', or: '||', not: '!' }[m[2]]);
    else if (m[2] in called && text[at] === '(') code.push(called[m[2]]);
    else if (m[2]) code.push(`(${JSON.stringify(m[2])} in r?r.${m[2]}:${JSON.stringify(m[2])})`);
    else if (m[3]) code.push(m[3]);
    else if (m[4]) code.push({ '==': '===', '!=': '!==' }[m[4]] || m[4]);
  }
  if (at !== text.length || !text.length) throw new Left(text);
  return new Function('r', `return ${code.join(' ')};`);
};
const aggregates = {
  count: (list) => list.length, distinct: (list) => new Set(list).size, first: (list) => list[0],
  max: (list) => (list.length ? Math.max(...list) : NaN), min: (list) => (list.length ? Math.min(...list) : NaN), sum: (list) => list.reduce((a, b) => a + b, 0),
};
const evaluate = (text, id) => {
  const figure = /^figure\('([^']*)'\)$/.exec(text);
  if (figure && figure[1] in figures) return figures[figure[1]];
  const m = /^(count|distinct|first|max|min|sum)\((?:(.+) of )?([a-z_]+)(?: where (.+))?\)$/.exec(text);
  const compared = /^(.+\)) (>|==) (0)$/.exec(text);
  if (!m && compared) { const value = evaluate(compared[1], id); return compared[2] === '>' ? value > 0 : value === 0; }
  if (!m) throw new Left(text);
  const all = tableOf(m[3]);
  if (!all || (m[1] === 'count') !== (m[2] === undefined)) throw new Left(text);
  const holds = m[4] ? inRow(m[4]) : () => true, of = m[2] ? inRow(m[2]) : (r) => r;
  const list = all.filter((r) => !id || r.case === id).filter(holds).map(of);
  return aggregates[m[1]](['max', 'min', 'sum'].includes(m[1]) ? list.filter((x) => x === x) : list);
};
const shown = (value, format) => {
  if (typeof value !== 'number' || !Number.isFinite(value)) throw new Left('no number');
  const [, sign, digits, kind] = /^(\+?)(?:\.([0-9]))?([def%])$/.exec(format) || [];
  if (!kind) throw new Left(format);
  const text = kind === 'd' ? String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, ',') : kind === '%' ? `${(100 * value).toFixed(digits)} %` : kind === 'f' ? value.toFixed(digits) : value.toExponential(digits).replace('+', '');
  // A negative number that is rounded to zero has no sign.
  return /^-[0.]+( %)?$/.test(text) ? text.slice(1) : (sign && value >= 0 ? '+' : '') + text.replace(/^-/, '−');
};

// Paragraphs and headings that are shown, each with its numbers put in.
const sentences = [];
let left = 0;
const plain = (text) => text.replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/[*`]|^#+ /g, '').replace(/\s+/g, ' ').trim();
const draw = (hash, text, id) => {
  let hidden = 0;
  for (const piece of text.replace(/```[^]*?```/g, '\n\n').split(/\n\s*\n/)) {
    const level = /^(#*)/.exec(piece)[1].length, condition = /^(?:#+ )?\{\?([^{}]+)\}/.exec(piece.replace(/\s+/g, ' '));
    if (hidden && (!level || level > hidden)) continue;
    hidden = 0;
    let holds = true;
    try { holds = !condition || evaluate(condition[1].trim(), id); } catch (error) { if (!(error instanceof Left)) throw error; holds = false; }
    if (!holds) { hidden = level; continue; }
    for (const sentence of plain(piece.replace(/\{\?[^{}]+\}/, '')).split(/(?<=[.:;]) (?![^{]*\})/)) {
      if (!/\{/.test(sentence)) continue;
      try {
        sentences.push({ hash, text: sentence.replace(/\{([^{}|]+?)(?:\|([^{}]*))?\}/g, (_, source, format) => shown(evaluate(source.trim(), id), (format || '').trim())) });
      } catch (error) { if (!(error instanceof Left)) throw error; left += 1; }
    }
  }
};
const measured = new Set((tableOf('orders') || []).map((row) => row.case));
for (const study of facts.studies) {
  if (!study.measured) continue;
  for (const page of study.pages) draw(`#study?page=${page.id}`, page.text);
  if (study.case_page) for (const id of measured) draw(`#case?id=${id}`, study.case_page, id);
}

// The first screen: the fastest run of each question.
const three = (x) => { const [digits, power] = x.toExponential(2).split('e'); const p = Number(power); return p >= -3 && p < 5 ? String(Number(x.toPrecision(3))) : `${Number(digits)}e${p}`; };
const time = (ns) => { const [size, unit] = [[1, 'ns'], [1e3, 'µs'], [1e6, 'ms'], [1e9, 's']].filter(([s]) => Number(ns.toPrecision(3)) >= s).at(-1); return `${three(ns / size)} ${unit}`; };
const closed = new Set(facts.solvers.filter((s) => s.closed_form).map((s) => `${s.library}/${s.method}`));
for (const { case: id } of facts.questions.filter((question) => measured.has(question.case)))
  for (const error of ['1e-3', '1e-6', '1e-9']) {
    const [best] = (tableOf('fastest') || []).filter((row) => row.case === id && Math.abs(row.error / error - 1) < 1e-6 && !closed.has(`${row.library}/${row.solver}`)).sort((a, b) => a.wall_ns_min - b.wall_ns_min);
    if (!best) continue;
    const hash = `#answers?case=${id}&error=${error}`;
    sentences.push({ hash, text: `${best.library}/${best.solver} reaches ${three(Number(error))} in ${time(best.wall_ns_min)}` });
    const near = best.near_error === best.near_error && best.near_error !== '' ? `, at most ${three(best.near_error)} at the next settings` : '';
    sentences.push({ hash, text: `${best.setting_kind === 'tol' ? 'tolerance' : 'step'} ${three(best.setting)}, error ${three(best.achieved)}${near}:` });
    if (best.rhs_evaluations > 1) sentences.push({ hash, text: `${shown(best.rhs_evaluations, 'd')} evaluations of f` });
  }

// As mulberry32 numbers them.
let state = Number(seed);
const random = () => { state = (state + 0x6d2b79f5) | 0; let t = Math.imul(state ^ (state >>> 15), 1 | state); t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t; return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32; };
const picked = [...sentences];
for (let i = picked.length - 1; i > 0; --i) { const j = Math.floor(random() * (i + 1)); [picked[i], picked[j]] = [picked[j], picked[i]]; }
picked.length = Math.min(wanted, picked.length);

const browser = await Browser.open(chromium);
await browser.size(1280, 900);
let wrong = picked.length < wanted ? 1 : 0;
for (const { hash, text } of picked) {
  await browser.go(`file://${folder}/index.html${hash}`);
  await browser.until(`document.documentElement.dataset.drawn`);
  const page = plain(await browser.run(`document.querySelector('main').textContent`));
  const stands = page.includes(text);
  if (!stands) wrong += 1;
  console.log(`${stands ? 'ok' : 'WRONG'}, ${hash}: ${text}`);
}
console.log(`${picked.length} of ${sentences.length} sentences, seed ${seed}; ${left} others hold what this does not evaluate`);
await browser.close();
process.exit(wrong ? 1 : 0);
