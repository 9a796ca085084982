// SPDX-License-Identifier: BSD-3-Clause
// Colours of speed and strain, and their legend.
const ramp = (stops) => (x) => {
  const s = Math.min(Math.max(x, 0), 1) * (stops.length - 1),
    i = Math.min(Math.floor(s), stops.length - 2);
  return stops[i].map((c, d) => (c + (stops[i + 1][d] - c) * (s - i)) / 255);
};
const speedStops = [[72, 60, 150], [50, 110, 180], [40, 165, 150], [130, 205, 85], [250, 230, 60]];
const strainStops = [[70, 130, 255], [170, 185, 205], [255, 95, 70]];
const speedColour = ramp(speedStops), strainColour = ramp(strainStops);
// Errors from a micrometre to a decimetre, logarithmically.
const errorRange = [1e-6, 1e-1];
const errorColour = (k, i) =>
  speedColour(
    Math.log10(Math.max(errors[firstParticle[k] + i], 1e-30) / errorRange[0]) /
      Math.log10(errorRange[1] / errorRange[0]),
  );
const gradient = (stops) =>
  `linear-gradient(to right, ${stops.map((s) => `rgb(${s})`).join(', ')})`;
const shown = (x) =>
  x === 0 ? '0' : Math.abs(x) >= 0.01 && Math.abs(x) < 1e4 ? x.toPrecision(3) : x.toExponential(1);
byId('speed-bar').style.background = gradient(speedStops);
byId('touch-legend').hidden = touches.size === 0;
byId('strain-bar').style.background = gradient(strainStops);
const showScales = () => {
  if (!errors.length) byId('speed-max').textContent = `${shown(fastest)} m/s`;
  byId('strain-low').textContent = `-${shown(100 * strainMax)} %`;
  byId('strain-high').textContent = `+${shown(100 * strainMax)} %`;
};
showScales();
if (errors.length) {
  byId('speed-name').textContent = `off by ${shown(errorRange[0])}`;
  byId('speed-max').textContent = `${errorRange[1]} m`;
  byId('strain-legend').hidden = true;
  byId('trail-length').value = '10';
}
if (!rest.length) {
  byId('strain-legend').hidden = true;
  byId('springs').parentElement.hidden = true;
}
if (!scene.cloths.length) byId('surface').parentElement.hidden = true;
