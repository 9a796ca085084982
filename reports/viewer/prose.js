// SPDX-License-Identifier: BSD-3-Clause
// A text of the report as elements: Markdown by markdown-it, with blocks (blocks.js) and with
// expressions over rows in braces, {max(factor of mesh) | .3f}, evaluated when the page is shown. A
// paragraph that begins with {? condition} is left out where the condition is false; so is a
// heading, with all that stands under it.
'use strict';
(() => {
  const { Template, rowsOf, html, wide, showBlock, facts, addressOf } = odeum;

  const markdown = self.markdownit({ html: false, linkify: false });

  // Pieces of a text: blocks, and what blank lines separate. A fence of code is part of a piece.
  const languages = new Set([
    '', 'sh', 'bash', 'text', 'python', 'cpp', 'c', 'yaml', 'csv', 'gnuplot', 'cmake',
  ]);
  const piecesOf = (text) => {
    const pieces = [];
    let lines = [], fence = null;
    const close = () => {
      if (lines.length) pieces.push({ text: lines.join('\n') });
      lines = [];
    };
    for (const line of text.split('\n')) {
      const mark = /^```([a-z_]*)\s*$/.exec(line);
      if (!fence && mark && !languages.has(mark[1])) {
        close();
        fence = { kind: mark[1], body: [] };
      } else if (!fence && mark) {
        lines.push(line);
        fence = 'code';
      } else if (fence === 'code') {
        lines.push(line);
        if (mark) fence = null;
      } else if (fence && mark) {
        pieces.push(fence);
        fence = null;
      } else if (fence) fence.body.push(line);
      else if (line.trim()) lines.push(line);
      else close();
    }
    close();
    return pieces;
  };

  // The expressions of a text: what stands in braces outside of code.
  const inline = /(`[^`]*`)|\{([^{}]+)\}/g;
  const expressionsIn = (text) =>
    [...text.matchAll(inline)].filter((m) => m[2] !== undefined).map((m) => m[2]);
  const valueOf = async (source, context) => {
    const template = new Template(`{${source.replace(/^\?/, '')}}`);
    const tables = new Map();
    for (const name of template.tables()) tables.set(name, await rowsOf(name, context.caseId));
    return template.bind(null, tables);
  };
  const escapeMarkdown = (text) => text.replace(/[\\`*_{}[\]<>#|]/g, '\\$&');

  const withValues = async (text, context) => {
    const values = new Map();
    for (const source of expressionsIn(text))
      if (!source.startsWith('?')) values.set(source, (await valueOf(source, context)).text(0, []));
    return text.replace(inline, (all, code, source) =>
      code !== undefined ? code : source.startsWith('?') ? '' : escapeMarkdown(values.get(source)),
    );
  };
  const holds = async (text, context) => {
    const found = /^(#+ )?\{\?([^{}]+)\}/.exec(text);
    return !found || Boolean((await valueOf(found[2], context)).value(0, []));
  };

  // Fills `host` with a text. `context`: {caseId} on the page of a case.
  const showProse = async (host, text, context = {}) => {
    let hidden = 0, pending = [];
    const flush = () => {
      if (!pending.length) return;
      const part = html('div', { class: 'prose' });
      part.innerHTML = markdown.render(pending.join('\n\n'));
      for (const link of part.querySelectorAll('a[href]')) {
        const address = addressInReport(link.getAttribute('href'));
        if (address === null) link.replaceWith(...link.childNodes);
        else link.setAttribute('href', address);
      }
      for (const head of part.querySelectorAll('th'))
        if (!head.textContent) head.replaceWith(html('td', {}));
      for (const table of part.querySelectorAll('table')) {
        table.classList.add('words');
        table.replaceWith(wide('table', table.cloneNode(true)));
      }
      host.append(part);
      pending = [];
    };
    const waiting = [];
    // Comments on lines of their own are for the programs that write a document's tables.
    for (const piece of piecesOf(text.replace(/^<!--.*-->$/gm, ''))) {
      if (!piece.kind) {
        const level = (/^(#+) /.exec(piece.text) || ['', ''])[1].length;
        if (hidden && (!level || level > hidden)) continue;
        hidden = 0;
        try {
          if (!(await holds(piece.text, context))) {
            hidden = level;
            continue;
          }
          pending.push(await withValues(piece.text, context));
        } catch (error) {
          document.documentElement.dataset.error = String(error.message);
          pending.push(`*This sentence could not be shown: ${escapeMarkdown(error.message)}.*`);
        }
      } else if (!hidden) {
        flush();
        const block = html('div', { class: 'block' });
        host.append(block);
        waiting.push(showBlock(block, piece.kind, piece.body.join('\n'), context));
      }
    }
    flush();
    await Promise.all(waiting);
  };

  // A document's link as it is reached from a report: to another document (a folder's documents are
  // part of the one of its name), to a file of the report, or to the web; null where the report
  // does not hold what it names.
  const addressInReport = (href) => {
    const [, folder, name] = /^(?:\.\.?\/)*(?:([a-z-]+)\/)?([a-z-]+)\.md(?:#.*)?$/.exec(href) || [];
    for (const document of [name, folder])
      if (facts.documents.includes(document)) return addressOf('document', { name: document });
    const held =
      href.startsWith('#') || href.startsWith('https://') ||
      facts.tables.some((table) => table.file === href) ||
      ['manifest.json', 'page.json'].includes(href);
    return held ? href : null;
  };

  Object.assign(odeum, { showProse });
})();
