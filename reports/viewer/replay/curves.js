// SPDX-License-Identifier: BSD-3-Clause
// Curves over time on a canvas: the whole in a faint colour, the part up to the present time in
// full colour; names above the field, so that they lie on no curve. `range`: its ends, or null.
const spanOfCurves = (curves) => {
  let [least, most] = [Infinity, -Infinity];
  for (const curve of curves)
    for (let k = 0; k <= last; ++k) {
      const e = curve.at(k);
      if (!Number.isFinite(e)) continue;
      least = Math.min(least, e);
      most = Math.max(most, e);
    }
  return [least, most];
};
const drawCurves = (plot, curves, unit, range, t) => {
  const pen = plot.getContext('2d'), w = plot.width, h = plot.height,
    ratio = w / plot.clientWidth || 1;
  const left = 64 * ratio, right = 8 * ratio, bottom = 8 * ratio, top = 20 * ratio;
  let [least, most] = range || spanOfCurves(curves);
  if (!(most > least)) {
    const middle = Number.isFinite(least) ? least : 0;
    least = middle - 1;
    most = middle + 1;
  }
  const x = (time) => left + ((w - left - right) * time) / duration;
  const y = (e) => h - bottom - ((h - top - bottom) * (e - least)) / (most - least);
  pen.clearRect(0, 0, w, h);
  pen.lineWidth = 1.5 * ratio;
  for (const full of [false, true]) {
    pen.save();
    pen.beginPath();
    pen.rect(left, top, (full ? x(t) : w) - left, h - top);
    pen.clip();
    pen.globalAlpha = full ? 1 : 0.3;
    for (const curve of curves) {
      pen.strokeStyle = curve.colour;
      pen.beginPath();
      for (let k = 0; k <= last; ++k) pen.lineTo(x(times[k]), y(curve.at(k)));
      pen.stroke();
    }
    pen.restore();
  }
  pen.strokeStyle = '#888';
  pen.beginPath();
  pen.moveTo(x(t), top);
  pen.lineTo(x(t), h);
  pen.stroke();
  pen.font = `${11 * ratio}px system-ui, sans-serif`;
  pen.fillStyle = '#bbb';
  pen.textAlign = 'right';
  pen.fillText(`${shown(most)} ${unit}`, left - 4 * ratio, top + 8 * ratio);
  pen.fillText(`${shown(least)} ${unit}`, left - 4 * ratio, h - bottom);
  pen.textAlign = 'left';
  let at = left + 6 * ratio;
  for (const curve of curves) {
    pen.fillStyle = curve.colour;
    pen.fillText(curve.name, at, 13 * ratio);
    at += pen.measureText(curve.name).width + 16 * ratio;
  }
};
