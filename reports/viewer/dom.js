// SPDX-License-Identifier: BSD-3-Clause
// Elements, and numbers as texts.
'use strict';
(() => {
  // The one name that the page adds to the browser's own: what its files share.
  self.odeum = {};
  const fill = (element, attributes, children) => {
    for (const [name, value] of Object.entries(attributes || {})) {
      if (value === undefined || value === null || value === false) continue;
      if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
      else if (name === 'style')
        for (const [key, text] of Object.entries(value)) element.style.setProperty(key, text);
      else element.setAttribute(name, value === true ? '' : value);
    }
    element.append(
      ...children.flat(9).filter((child) => child !== null && child !== undefined && child !== ''),
    );
    return element;
  };
  // An HTML (SVG) element; children are elements and texts, never markup.
  const html = (tag, attributes, ...children) =>
    fill(document.createElement(tag), attributes, children);
  const svg = (tag, attributes, ...children) =>
    fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

  // A box that scrolls, and can be reached by keys.
  const wide = (label, ...children) =>
    html('div', { class: 'wide', tabindex: 0, role: 'group', 'aria-label': label }, ...children);

  // At most `digits` significant digits: 0.0125, 3.1e-12.
  const number = (value, digits = 3) => {
    if (value === null || Number.isNaN(value)) return '–';
    if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e5))
      return value
        .toExponential(digits - 1)
        .replace(/\.?0+e/, 'e')
        .replace('e+', 'e');
    return String(Number(value.toPrecision(digits)));
  };
  // Nanoseconds: "850 ns", "12.3 µs".
  const duration = (ns) => {
    for (const [unit, size] of [['ns', 1], ['µs', 1e3], ['ms', 1e6]])
      if (ns < 999.5 * size) return `${Number((ns / size).toPrecision(3))} ${unit}`;
    return `${Number((ns / 1e9).toPrecision(3))} s`;
  };
  const sum = (list) => list.reduce((a, b) => a + b, 0);
  const times = (ratio) => ratio < 9.95 ? ratio.toFixed(1) : Math.round(ratio).toLocaleString('en');
  const plural = (count, noun) => `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'}`;

  // Offers a text as a file.
  const save = (name, text, type = 'text/csv') => {
    const link = html('a', {
      href: URL.createObjectURL(new Blob([text], { type })), download: name,
    });
    document.body.append(link);
    link.click();
    link.remove();
  };
  const csv = (columns, rows) => {
    const field = (value) => {
      if (typeof value === 'number')
        return Number.isNaN(value)
          ? 'nan'
          : Number.isFinite(value)
            ? String(value)
            : value > 0
              ? 'inf'
              : '-inf';
      const text = String(value === null || value === undefined ? '' : value);
      return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    };
    return [columns, ...rows].map((row) => row.map(field).join(',')).join('\n') + '\n';
  };

  Object.assign(odeum, { html, svg, wide, number, duration, sum, times, plural, save, csv });
})();
