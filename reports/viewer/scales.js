// SPDX-License-Identifier: BSD-3-Clause
// Scales of charts: values to pixels, ticks, ranges, and texts that make room for one another.
'use strict';
(() => {
  const { number, svg } = odeum;

  // An axis: values to pixels from `from` to `to`, and its ticks.
  const makeAxis = (spec, from, to) => {
    const scale = (spec.log ? d3.scaleLog() : d3.scaleLinear())
      .domain([spec.low, spec.high])
      .range([from, to]);
    const decades = spec.log ? Math.log10(spec.high / spec.low) : 0, length = Math.abs(to - from);
    const holds = (v) =>
      Number.isFinite(v) && (!spec.log || v > 0) && v >= spec.low - 1e-9 * Math.abs(spec.low) &&
      v <= spec.high + 1e-9 * Math.abs(spec.high);
    // Powers of ten alone where more do not fit.
    const ticks = (spacing) => {
      if (!spec.log) return scale.ticks(Math.max(2, Math.floor(length / spacing)));
      const every = Math.max(1, Math.ceil(decades / Math.max(2, Math.floor(length / spacing))));
      const powers = d3
        .range(Math.floor(Math.log10(spec.low)), Math.log10(spec.high) + 1)
        .filter((k) => k % every === 0);
      return powers
        .flatMap((k) => (decades < 2 ? [1, 2, 5] : [1]).map((m) => m * 10 ** k))
        .filter(holds);
    };
    const label = (v) => {
      if (spec.text) return [spec.text(v)];
      if (!spec.log || decades < 2) return [number(v, 4)];
      return [
        '10',
        svg(
          'tspan', { dy: -5, 'font-size': 9 }, String(Math.round(Math.log10(v))).replace('-', '−'),
        ),
      ];
    };
    return {
      at: scale, value: scale.invert, holds, ticks, label, from, to, log: Boolean(spec.log),
    };
  };

  // The range of positive numbers, widened by a factor; null where there are none.
  const rangeOf = (values, factor) => {
    const positive = values.filter((v) => Number.isFinite(v) && v > 0);
    return positive.length
      ? { low: d3.min(positive) / factor, high: d3.max(positive) * factor, log: true }
      : null;
  };

  // The same of any numbers, with a margin.
  const spanOf = (values) => {
    const finite = values.filter(Number.isFinite), low = d3.min(finite), high = d3.max(finite),
      room = 0.04 * (high - low) || Math.abs(high) || 1;
    return finite.length ? { low: low - room, high: high + room } : null;
  };

  // Places texts one below the other, each as near as possible to where it wants to be.
  const spread = (wanted, gap, low, high) => {
    const order = d3.range(wanted.length).sort((a, b) => wanted[a] - wanted[b]), placed = [];
    order.forEach((i, k) => {
      placed[k] = Math.max(wanted[i], k ? placed[k - 1] + gap : low);
    });
    let limit = high;
    for (let k = placed.length - 1; k >= 0; --k) {
      placed[k] = Math.min(placed[k], limit);
      limit = placed[k] - gap;
    }
    return wanted.map((_, i) => placed[order.indexOf(i)]);
  };

  Object.assign(odeum, { makeAxis, rangeOf, spanOf, spread });
})();
