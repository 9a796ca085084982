// SPDX-License-Identifier: BSD-3-Clause
// node reproduce.mjs <chromium> <report> <odeum>: runs every command that the first screen of a report prints, that of every row of
// fastest.csv, and those of some runs of the study of orders; each has to give the error and the counts of its row, to the last digit.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from './browser.mjs';

const [chromium, folder, odeum] = process.argv.slice(2);
const mostOrders = 60;  // each takes some 30 ms

const rowsOf = (file) => {
  const fields = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map((m) => m[1].replace(/^"|"$/g, '').replaceAll('""', '"'));
  const [head, ...lines] = readFileSync(join(folder, file), 'utf8').trimEnd().split('\n');
  const names = fields(head);
  return lines.map((line) => { const values = fields(line); return Object.fromEntries(names.map((name, i) => [name, values[i]])); });
};
const timed = rowsOf('precision.csv'), converged = rowsOf('convergence.csv').filter((row) => row.status === 'ok');
const id = (row) => `${row.library}/${row.solver}`;
const runOf = (row) => timed.find((each) => each.case === row.case && id(each) === id(row) && each.setting_kind === row.setting_kind && each.setting === row.setting && each.options === row.options);

const browser = await Browser.open(chromium);
await browser.go(`file://${folder}/index.html#answers`);
await browser.until(`document.documentElement.dataset.drawn`);
// The command that the page prints for a row of its own data; numbers there have eight digits.
const near = (a, b) => a === b || Math.abs(a / b - 1) < 1e-6;
const commandsOf = (table, rows) => browser.run(`(async () => {
  const { rowsOf, commandOf, facts } = odeum, near = ${near};
  const wanted = ${JSON.stringify(rows)}, found = [];
  for (const row of wanted) {
    const all = (await rowsOf('${table}', row.case)).objects();
    const run = all.find((each) => ['library', 'solver', 'setting_kind', 'options', 'mode'].every((name) => row[name] === undefined || each[name] === row[name]) && ['setting', 'steps'].every((name) => row[name] === undefined || row[name] === 'nan' || near(each[name], Number(row[name]))));
    found.push(run ? commandOf(facts.caseOf.get(row.case), run) : '');
  }
  return found;
})()`);
const only = (names) => (row) => Object.fromEntries(names.map((name) => [name, row[name]]));

let wrong = 0;
const complain = (text) => { wrong += 1; console.log(text); };
const checked = new Set();
const check = (command, row, names) => {
  if (checked.has(command)) return;
  checked.add(command);
  if (!command.startsWith('odeum run ')) return complain(`no command for ${id(row)} on ${row.case}`);
  let run;
  try {
    [run] = Object.values(JSON.parse(execFileSync(odeum, [...command.split(' ').slice(1), '--format', 'json'], { stdio: ['ignore', 'pipe', 'ignore'] }))).flat();
  } catch (error) {
    return complain(`${command}: ${error.message}`);
  }
  const apart = Object.entries(names).filter(([mine, theirs]) => run[mine] !== Number(row[theirs])).map(([mine, theirs]) => `${mine} ${run[mine]}, the row has ${row[theirs]}`);
  return apart.length ? complain(`${command}: ${apart.join('; ')}`) : null;
};

const counts = { rhs_evaluations: 'rhs_evaluations', jacobian_evaluations: 'jacobian_evaluations' };
const fastest = rowsOf('fastest.csv').map(runOf);
if (fastest.includes(undefined)) complain('a row of fastest.csv is none of precision.csv');
const runs = fastest.filter(Boolean);
const commands = await commandsOf('precision', runs.map(only(['case', 'library', 'solver', 'setting_kind', 'setting', 'options'])));
runs.forEach((row, i) => check(commands[i], row, { error_max: 'error', steps: 'steps', rejected_steps: 'rejected_steps', ...counts }));
const quick = checked.size;
// What the first screen prints is among them.
const facts = JSON.parse(readFileSync(join(folder, 'page.json'), 'utf8'));
let printed = 0;
for (const { case: name } of facts.questions.filter((q) => timed.some((row) => row.case === q.case)))
  for (const error of ['1e-3', '1e-6', '1e-9']) {
    await browser.go(`file://${folder}/index.html#answers?case=${name}&error=${error}`);
    await browser.until(`document.querySelector('.answer')`);
    const command = await browser.run(`document.querySelector('.command code')?.textContent || ''`);
    printed += command !== '';
    if (command && !commands.includes(command)) complain(`${name} at ${error}: ${command} is not a run of fastest.csv`);
  }
const every = Math.max(1, Math.floor(converged.length / mostOrders)), some = converged.filter((_, i) => i % every === 0);
const orders = await commandsOf('convergence', some.map(only(['case', 'library', 'solver', 'mode', 'steps', 'setting'])));
some.forEach((row, i) => check(orders[i], row, { error_max: 'error_max', error_rms: 'error_rms', steps: 'steps', ...counts }));
await browser.close();
console.log(`${printed} commands of the first screen, of ${quick} runs of fastest.csv, and ${checked.size - quick} of the study of orders: ${wrong || 'none'} differ`);
if (!printed || !quick) complain('nothing was run');
process.exit(wrong ? 1 : 0);
