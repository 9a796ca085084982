// SPDX-License-Identifier: BSD-3-Clause
// Values as texts, and templates: texts with expressions in braces.
'use strict';
(() => {
  const { number, duration, parse, tablesIn, bind } = odeum;

  // A value as text: ".3f", ".2e", ".3g", "+.2g", "d", "%" (of 1), "time" (ns), "bytes"; without a
  // format, three digits.
  const formatted = (value, format) => {
    if (typeof value !== 'number')
      return value === undefined || value === null ? '' : String(value);
    if (!format) return number(value);
    if (format === 'time') return Number.isNaN(value) ? '–' : duration(value);
    const [, sign, digits, kind] = /^(\+?)(?:\.([0-9]+))?([defg%])$/.exec(format) || [];
    if (!kind) throw new Error(`there is no format ${format}`);
    if (!Number.isFinite(value)) return number(value);
    const size = {
      d: () => Math.round(value).toLocaleString('en'),
      '%': () => `${(100 * value).toFixed(digits || 0)} %`,
      f: () => value.toFixed(digits ?? 6),
      e: () => value.toExponential(digits ?? 6).replace('e+', 'e'),
      g: () => number(value, Number(digits ?? 6)),
    }[kind]();
    const text = /^-[0.]+( %)?$/.test(size) ? size.slice(1) : size;
    return (sign && value >= 0 ? `+${text}` : text).replace(/^-/, '−');
  };

  // "{library}/{solver}" or "factor | .3f": a function (i, group) with the text, and its value
  // where it is one number.
  class Template {
    constructor(text) {
      const single = !text.includes('{');
      this.parts = (single ? ['', text, ''] : text.replace(/\s+/g, ' ').split(/\{([^{}]*)\}/)).map(
        (part, k) => {
          if (k % 2 === 0) return part;
          const [, expression, format] = /^(.*?)(?:\|\s*([^|]*))?$/.exec(part);
          return { tree: parse(expression), format: (format || '').trim() };
        },
      );
      this.trees = this.parts.filter((part) => part.tree).map((part) => part.tree);
      this.alone = this.trees.length === 1 && this.parts.every((part) => part.tree || part === '');
    }
    tables() {
      return this.trees.reduce((found, tree) => tablesIn(tree, found), new Set());
    }
    bind(rows, tables) {
      const parts = this.parts.map((part) =>
        part.tree ? { value: bind(part.tree, rows, tables), format: part.format } : part,
      );
      const text = (i, group) =>
        parts
          .map((part) =>
            typeof part === 'string' ? part : formatted(part.value(i, group), part.format),
          )
          .join('');
      const value = this.alone ? parts.find((part) => part.value).value : text;
      return { text, value };
    }
  }

  Object.assign(odeum, { formatted, Template });
})();
