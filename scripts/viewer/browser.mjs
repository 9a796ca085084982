// SPDX-License-Identifier: BSD-3-Clause
// A headless Chromium, spoken to over a pair of pipes (the DevTools protocol): opens pages from a disk,
// evaluates expressions in them, takes pictures, and collects what they complain of.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Browser {
  static async open(program) {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), 'odeum-page-'));
    browser.process = spawn(program, ['--headless', '--no-sandbox', '--disable-gpu-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage', '--hide-scrollbars', '--remote-debugging-pipe', `--user-data-dir=${browser.profile}`],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    browser.calls = new Map();
    browser.complaints = [];
    browser.events = new Map();
    browser.last = 0;
    let text = '';
    browser.process.stdio[4].setEncoding('utf8').on('data', (part) => {
      text += part;
      for (let end; (end = text.indexOf('\0')) >= 0; text = text.slice(end + 1)) browser.receive(JSON.parse(text.slice(0, end)));
    });
    const { targetId } = await browser.send('Target.createTarget', { url: 'about:blank' });
    browser.session = (await browser.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    for (const domain of ['Page', 'Runtime', 'Log', 'Inspector']) await browser.send(`${domain}.enable`);
    return browser;
  }

  receive(message) {
    if (message.id) {
      const { resolve, reject } = this.calls.get(message.id);
      this.calls.delete(message.id);
      if (message.error) reject(new Error(message.error.message)); else resolve(message.result);
      return;
    }
    const { method, params } = message;
    // Nobody answers for a page that is gone.
    if (method === 'Inspector.targetCrashed') for (const { reject } of [...this.calls.values(), ...this.events.values()]) reject(new Error('the page crashed'));
    if (method === 'Runtime.exceptionThrown') this.complaints.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(`${params.entry.text} ${params.entry.url || ''}`);
    if (method === 'Runtime.consoleAPICalled' && params.type === 'error') this.complaints.push(params.args.map((a) => a.value || a.description).join(' '));
    this.events.get(method)?.resolve();
  }

  send(method, params = {}) {
    const id = ++this.last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
    return new Promise((resolve, reject) => this.calls.set(id, { resolve, reject }));
  }

  async size(width, height, dark = false) {
    await this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    await this.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
  }

  async go(address) {
    const load = () => new Promise((resolve, reject) => this.events.set('Page.loadEventFired', { resolve, reject })), loaded = load();
    await this.send('Page.navigate', { url: 'about:blank' });
    await loaded;
    const again = load();
    await this.send('Page.navigate', { url: address });
    await again;
  }

  // The value of an expression in the page, which may be a promise.
  async run(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description || exceptionDetails.text}`);
    return result.value;
  }

  // Waits until an expression is true.
  async until(expression, seconds = 120) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await new Promise((resolve) => { setTimeout(resolve, 20); }))
      if (await this.run(expression)) return;
    throw new Error(`not true within ${seconds} s: ${expression}`);
  }

  async picture(file, clip) {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png', ...(clip ? { clip: { ...clip, scale: 1 }, captureBeyondViewport: true } : {}) });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    this.send('Browser.close').catch(() => {});
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
