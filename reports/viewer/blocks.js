// SPDX-License-Identifier: BSD-3-Clause
// What the blocks of a page.md share: their text becomes a specification, the tables that its
// expressions read are loaded, the expressions are bound to the rows.
//
// A block is a fence with a kind, a list of "key: value"; a key with lines below it, indented, is a
// list:
//   ```table
//   rows: mesh where springs == structural
//   columns:
//     particles along an edge = particles | d
//     factor | .3f
//   ```
// Every kind takes  rows (a file of the report, without its ending, and a condition), details (a
// summary; the block is closed at first), empty (a text where there are no rows). A study's view.js
// adds kinds: blocks.NAME = async (host, spec, context) => …, with context {caseId}.
'use strict';
(() => {
  const { Template, parse, tablesIn, rowsOf, bind, facts, html, addressOf } = odeum;

  const blocks = {};

  const specOf = (text) => {
    const spec = {};
    let key = '';
    for (const line of text.split('\n').filter((each) => each.trim())) {
      if (/^\s/.test(line)) {
        if (!key) throw new Error(`"${line.trim()}" stands under no key`);
        spec[key] = [...(Array.isArray(spec[key]) ? spec[key] : []), line.trim()];
        continue;
      }
      const found = /^([a-z_]+):\s*(.*)$/.exec(line);
      if (!found) throw new Error(`"${line}" is not key: value`);
      key = found[1];
      spec[key] = found[2];
    }
    return spec;
  };
  const checkKeys = (spec, kind, allowed) => {
    for (const key of Object.keys(spec))
      if (![...allowed, 'rows', 'details', 'empty', 'title'].includes(key))
        throw new Error(`a ${kind} has no key ${key}; it has ${allowed.join(', ')}`);
  };

  // "heading = template" or "template".
  const columnOf = (line) => {
    const at = line.indexOf(' = ');
    const cell = at < 0 ? line : line.slice(at + 3);
    return {
      heading: at < 0 ? line.split('|')[0].replace(/[{}]/g, '').trim() : line.slice(0, at).trim(),
      cell, template: new Template(cell),
    };
  };
  // The same list as a map by heading.
  const byHeading = (lines) =>
    new Map(
      (Array.isArray(lines) ? lines : [])
        .map((line) => columnOf(line))
        .map((column) => [column.heading, column.template]),
    );

  // The rows that `rows: NAME where CONDITION` names, of one case where the page is a case's;
  // `templates` are bound to them. {rows, indices, bound: [{text, value}]}
  const prepare = async (spec, context, templates) => {
    const [, name, condition] = /^([a-z_0-9]+)(?:\s+where\s+(.*))?$/.exec(spec.rows || '') || [];
    if (!name) throw new Error(`rows: "${spec.rows || ''}" names no file of the report`);
    const where = condition ? parse(condition) : null;
    const named = new Set([
      ...templates.filter(Boolean).flatMap((template) => [...template.tables()]),
      ...tablesIn(where),
    ]);
    const tables = new Map();
    for (const table of named) tables.set(table, await rowsOf(table, context.caseId));
    const rows = await rowsOf(name, context.caseId);
    if (!rows.length) return { rows, indices: [], bound: [] };
    return {
      rows, indices: rows.indices(where ? bind(where, rows, tables) : null),
      bound: templates.map((template) => (template ? template.bind(rows, tables) : null)),
    };
  };

  // Rows by a text, in the order in which the texts come first.
  const grouped = (indices, keyOf) => {
    const groups = new Map();
    for (const i of indices) {
      const key = keyOf(i, [i]);
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(i);
    }
    return groups;
  };

  // A solver or a case is a link to its page.
  const linkOf = (cell, text) => {
    if (cell === '{library}/{solver}' && facts.solverOf.has(text))
      return html('a', { href: addressOf('methods', { solver: text }) }, text);
    if (cell === 'case' && facts.caseOf.has(text))
      return html('a', { href: addressOf('case', { id: text }) }, text);
    return text;
  };

  // Shows a block in `host`; what is wrong with it stands in its place.
  const showBlock = async (host, kind, text, context) => {
    try {
      const spec = specOf(text);
      if (!blocks[kind])
        throw new Error(`there is no block ${kind}; there are ${Object.keys(blocks).join(', ')}`);
      let inner = host;
      if (spec.details) {
        inner = html('div', {});
        host.append(html('details', {}, html('summary', {}, spec.details), inner));
      }
      await blocks[kind](inner, spec, context);
    } catch (error) {
      document.documentElement.dataset.error = String(error.message);
      host.replaceChildren(
        html(
          'p', { class: 'missing', role: 'alert' },
          `This ${kind} could not be shown: ${error.message}.`,
        ),
      );
    }
  };

  Object.assign(odeum, {
    blocks, specOf, checkKeys, columnOf, byHeading, prepare, grouped, linkOf, showBlock,
  });
})();
