// SPDX-License-Identifier: BSD-3-Clause
// An axis: values to pixels, ticks. {low, high, log, label, text}; pixels from `from` to `to`.
const makeAxis = (spec, from, to) => {
  const { log } = spec;
  const of = log ? Math.log10 : (value) => value;
  const low = of(spec.low), high = of(spec.high), length = Math.abs(to - from);
  const at = (value) => from + ((of(value) - low) / (high - low)) * (to - from);
  const value = (pixel) => {
    const place = low + ((pixel - from) / (to - from)) * (high - low);
    return log ? 10 ** place : place;
  };
  const holds = (v) => Number.isFinite(v) && (!log || v > 0) && of(v) >= low - 1e-9 && of(v) <= high + 1e-9;
  const ticks = (spacing) => {
    const most = Math.max(2, Math.floor(length / spacing)), list = [];
    if (log) {
      const every = Math.max(1, Math.ceil((high - low) / most));
      for (let k = Math.floor(low); k <= high; ++k)
        for (const m of high - low < 2 ? [1, 2, 5] : [1])
          if (k % every === 0) list.push(m * 10 ** k);
    } else {
      const least = (high - low) / most, power = 10 ** Math.floor(Math.log10(least));
      const step = [1, 2, 5, 10].map((m) => m * power).find((size) => size >= least * (1 - 1e-9));
      for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-12); ++k) list.push(Number((k * step).toPrecision(12)));
    }
    return list.filter(holds);
  };
  // Powers of ten on a long logarithmic axis, else numbers.
  const label = (v, y) => {
    if (spec.text) return [spec.text(v)];
    if (!log || high - low < 2) return [number(v)];
    return ['10', svg('tspan', { dy: -5, 'font-size': 9 }, String(Math.round(Math.log10(v))).replace('-', '−'))];
  };
  return { at, value, holds, ticks, label, from, to, log };
};
// The range of positive numbers, widened by a factor; null where there are none.
const rangeOf = (values, factor) => {
  let low = Infinity, high = 0;
  for (const value of values)
    if (Number.isFinite(value) && value > 0) { low = Math.min(low, value); high = Math.max(high, value); }
  return high > 0 ? { low: low / factor, high: high * factor, log: true } : null;
};
