// SPDX-License-Identifier: BSD-3-Clause
// Energy over time. Where the potential is zero is a convention: here at its least value in the
// run, so that an offset does not flatten the curves.
const plot = byId('energy');
const leastPotential = scene.potential.reduce((least, e) => (e < least ? e : least), Infinity);
let offset = Number.isFinite(leastPotential) ? leastPotential : 0;
// The ends of the axes that several replays share, see together.js; null: those of this run.
const sharedAxes = { energy: null, coordinate: null };
const energies = [
  { name: 'kinetic', colour: '#5aa9ff', at: (k) => scene.kinetic[k] },
  { name: 'potential, from its least', colour: '#ffb454', at: (k) => scene.potential[k] - offset },
  { name: 'total', colour: '#f2f2f2', at: (k) => scene.kinetic[k] + scene.potential[k] - offset },
];
const drawEnergy = (t) => drawCurves(plot, energies, 'J', sharedAxes.energy, t);

// The coordinate that the scene asks to see (`plot`).
const coordinatePlot = byId('coordinate');
coordinatePlot.hidden = !scene.plot;
const coordinates = scene.plot
  ? [
      {
        name: `particle ${scene.plot.particle}, ${'xyz'[scene.plot.coordinate]}`, colour: '#7fd38a',
        at: (k) => position(k, scene.plot.particle, scene.plot.coordinate),
      },
    ]
  : [];
const drawCoordinate = (t) => {
  if (scene.plot)
    drawCurves(coordinatePlot, coordinates, 'm', scene.plot.range || sharedAxes.coordinate, t);
};
