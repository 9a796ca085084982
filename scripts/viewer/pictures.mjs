// SPDX-License-Identifier: BSD-3-Clause
// node pictures.mjs <chromium> <report> <report of the regions> <run of a cloth> <folder for the pictures>: the pictures of README.md,
// as the report's own views and the replay page draw them.
import { Browser } from './browser.mjs';

const [chromium, folder, regions, cloth, out] = process.argv.slice(2);
const own = ['explicit_euler:fixed', 'velocity_verlet:fixed', 'rk4:fixed', 'verner65:fixed'].map((name) => `odeum/${name}`);
const pictures = {
  convergence: [`#compare?case=damped_oscillator_underdamped&x=step&show=${[...own, 'gsl/rk8pd:fixed', 'bullet/soft_body_force:fixed'].join(',')}`, 'compare'],
  speed: ['#compare?case=robertson_40&x=time', 'compare'],
  stability: ['#regions?case=damped_oscillator_underdamped&h=0.6&show=odeum/explicit_euler,odeum/rk4,odeum/dormand_prince54,odeum/adams_bashforth4', 'regions'],
};
const browser = await Browser.open(chromium);
await browser.size(1000, 900);
for (const [name, [hash, view]] of Object.entries(pictures)) {
  await browser.go(`file://${view === 'regions' ? regions : folder}/index.html${hash}`);
  await browser.until(`document.documentElement.dataset.drawn === '${view}'`);
  const clip = await browser.run(`(() => { const b = document.querySelector('[data-view="${view}"] svg.plot').getBoundingClientRect(); return { x: b.x + scrollX, y: b.y + scrollY, width: b.width, height: b.height }; })()`);
  await browser.picture(`${out}/${name}.png`, clip);
  console.log(`${out}/${name}.png`);
}
// The last moment of the cloth.
await browser.size(900, 760);
await browser.go(`file://${cloth}/replay.html`);
await browser.until(`document.documentElement.dataset.drawn === 'yes' || document.documentElement.dataset.error`);
await browser.run(`(() => { const play = document.getElementById('play'); if (play.textContent === 'Pause') play.click(); const e = document.getElementById('scrub'); e.value = 0.6 * e.max; e.dispatchEvent(new Event('input')); })()`);
await new Promise((resolve) => { setTimeout(resolve, 500); });
const box = await browser.run(`(() => { const b = document.getElementById('view').getBoundingClientRect(); return { x: b.x, y: b.y, width: b.width, height: b.height }; })()`);
await browser.picture(`${out}/cloth.png`, box);
console.log(`${out}/cloth.png`);
await browser.close();
