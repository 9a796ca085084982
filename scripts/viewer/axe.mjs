// SPDX-License-Identifier: BSD-3-Clause
// node axe.mjs <chromium> <axe.min.js> <report folder> [page...]: what axe-core finds on pages of a report.
// axe-core is no dependency: `npm pack axe-core` or `npm install axe-core` in a folder of one's own.
import { readFileSync } from 'node:fs';
import { Browser } from './browser.mjs';

const [chromium, axe, folder, ...named] = process.argv.slice(2);
const pages = named.length ? named : ['index.html', 'index.html#compare?case=robertson_40&x=step', 'data.html', 'replays.html', 'orders.html', 'overview.html',
  'verdicts.html', 'precision.html', 'stability.html', 'trade-offs.html', 'columns.html', 'findings.html', 'skipped.html', 'cases/robertson_40.html', 'replay/cloth.html'];
const browser = await Browser.open(chromium);
await browser.size(1280, 900);
await browser.send('Page.setBypassCSP', { enabled: true });
let found = 0;
for (const page of pages) {
  await browser.go(`file://${folder}/${page}`);
  if (page.startsWith('index')) await browser.until(`document.documentElement.dataset.drawn === 'all'`, 60);
  await browser.run(`${readFileSync(axe, 'utf8')};0`);
  const rules = await browser.run(`axe.run(document, { resultTypes: ['violations'] }).then((r) => r.violations.map((v) => [v.id, v.impact, v.nodes.length, v.nodes[0].html.slice(0, 160)]))`);
  found += rules.length;
  console.log(`${page}: ${rules.length ? '' : 'nothing'}`);
  for (const rule of rules) console.log(`  ${rule.join('  ')}`);
}
await browser.close();
process.exit(found ? 1 : 0);
