// SPDX-License-Identifier: BSD-3-Clause
// Inside a page of several replays: that page has the controls, and all have one camera.
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
  if (event.data.odeum === 'camera') {
    Object.assign(camera, event.data.camera);
    dirty = true;
  }
});
if (embedded) {
  resize(); // the controls are gone
  parent.postMessage({ odeum: 'ready', duration }, '*');
  sameCamera();
}
