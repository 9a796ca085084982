// SPDX-License-Identifier: BSD-3-Clause
// Energy: the whole curve in a faint colour, the part up to the present time in full colour.
const plot = byId('energy');
const curves = [
  { name: 'kinetic', colour: '#5aa9ff', at: (k) => scene.kinetic[k] },
  { name: 'potential', colour: '#ffb454', at: (k) => scene.potential[k] },
  { name: 'total', colour: '#f2f2f2', at: (k) => scene.kinetic[k] + scene.potential[k] }];
const drawEnergy = (t) => {
  const pen = plot.getContext('2d'), w = plot.width, h = plot.height, ratio = w / plot.clientWidth || 1;
  const left = 64 * ratio, right = 8 * ratio, pad = 8 * ratio;
  let least = Infinity, most = -Infinity;
  for (const curve of curves)
    for (let k = 0; k <= last; ++k) { const e = curve.at(k); if (Number.isFinite(e)) { least = Math.min(least, e); most = Math.max(most, e); } }
  if (!(most > least)) { least -= 1; most += 1; }
  const x = (time) => left + (w - left - right) * time / duration;
  const y = (e) => h - pad - (h - 2 * pad) * (e - least) / (most - least);
  pen.clearRect(0, 0, w, h);
  pen.lineWidth = 1.5 * ratio;
  for (const full of [false, true]) {
    pen.save();
    pen.beginPath();
    pen.rect(0, 0, full ? x(t) : w, h);
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
  pen.moveTo(x(t), 0);
  pen.lineTo(x(t), h);
  pen.stroke();
  pen.font = `${11 * ratio}px system-ui, sans-serif`;
  pen.fillStyle = '#bbb';
  pen.textAlign = 'right';
  pen.fillText(`${shown(most)} J`, left - 4 * ratio, pad + 8 * ratio);
  pen.fillText(`${shown(least)} J`, left - 4 * ratio, h - pad);
  pen.textAlign = 'left';
  curves.forEach((curve, c) => {
    pen.fillStyle = curve.colour;
    pen.fillText(curve.name, left + (6 + 66 * c) * ratio, pad + 8 * ratio);
  });
};
