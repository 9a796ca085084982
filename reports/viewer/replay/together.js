// SPDX-License-Identifier: BSD-3-Clause
// Inside a page of several replays: that page has the controls, and all have one camera, one scale
// of colours and of arrows, and one axis of each curve.
const embedded = window.parent !== window;
document.body.classList.toggle('embedded', embedded);
const sameCamera = () => {
  if (embedded)
    parent.postMessage({ odeum: 'camera', camera: { ...camera, target: [...camera.target] } }, '*');
};
addEventListener('message', (event) => {
  if (event.source !== window.parent || !embedded || !event.data) return;
  if (event.data.odeum === 'time') {
    playing = false;
    showPlaying();
    for (const id of ['trails', 'springs', 'surface', 'arrows'])
      if (id in event.data) byId(id).checked = event.data[id];
    go(event.data.time);
  }
  if (event.data.odeum === 'scales') {
    ({ fastest, strain: strainMax, offset } = event.data.scales);
    const { kinetic, others, coordinate } = event.data.scales;
    sharedAxes.energy = [
      Math.min(kinetic[0], others[0] - offset), Math.max(kinetic[1], others[1] - offset),
    ];
    sharedAxes.coordinate = coordinate;
    showScales();
    dirty = true;
  }
  if (event.data.odeum === 'camera') {
    Object.assign(camera, event.data.camera);
    dirty = true;
  }
});
if (embedded) {
  resize(); // the controls are gone
  const scales = {
    fastest, strain: strainMax, offset,
    kinetic: spanOfCurves(energies.slice(0, 1)),
    others: spanOfCurves(energies.slice(1)).map((e) => e + offset),
    coordinate: spanOfCurves(coordinates),
  };
  parent.postMessage({ odeum: 'ready', duration, scales }, '*');
  sameCamera();
}
