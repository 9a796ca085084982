// SPDX-License-Identifier: BSD-3-Clause
// The page's time, and the controls that change it.
let time = 0, playing = !matchMedia('(prefers-reduced-motion: reduce)').matches, before = null, dirty = true;
const scrub = byId('scrub'), playButton = byId('play');
scrub.max = duration;
const showPlaying = () => { playButton.textContent = playing ? 'Pause' : 'Play'; };
const go = (t) => { time = Math.min(Math.max(t, 0), duration); dirty = true; };
const resize = () => {
  const ratio = window.devicePixelRatio || 1;
  for (const one of [canvas, plot]) {
    one.width = Math.max(1, Math.round(one.clientWidth * ratio));
    one.height = Math.max(1, Math.round(one.clientHeight * ratio));
  }
  dirty = true;
};
const show = () => {
  const now = moment(time);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0.078, 0.086, 0.102, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  placeCamera();
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.polygonOffset(1, 1);  // lines on a cloth stay in front of it
  draw(flat, gl.TRIANGLES, still.faces, still.faceColours);
  if (byId('surface').checked) drawCloths(now);
  draw(flat, gl.LINES, still.lines, still.lineColours);
  if (byId('springs').checked) drawSprings(now);
  drawParticles(now);
  if (byId('trails').checked) drawTrails(now);
  drawEnergy(time);
  scrub.value = time;
  byId('time').textContent = `t = ${time.toFixed(3)} s of ${+duration.toPrecision(6)}`;
  report.frame = now.k;
  report.particles = now.n;
  if (!report.drawn) countLit();
};
// Number of pixels that differ from the background, for the page's test.
const countLit = () => {
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let lit = 0;
  for (let i = 0; i < pixels.length; i += 4) lit += pixels[i] + pixels[i + 1] + pixels[i + 2] > 120;
  report.lit = lit;
  report.frames = times.length;
  report.springs = rest.length;
  report.glError = gl.getError();
  report.drawn = 'yes';
};
const tick = (now) => {
  if (playing && before !== null) {
    time += Math.min((now - before) / 1000, 0.1) * Number(byId('rate').value);
    if (time > duration) time = 0;
    dirty = true;
  }
  before = now;
  if (dirty) { dirty = false; show(); }
  requestAnimationFrame(tick);
};

playButton.onclick = () => { playing = !playing; showPlaying(); };
scrub.oninput = () => { playing = false; showPlaying(); go(Number(scrub.value)); };
for (const id of ['trails', 'springs', 'surface']) byId(id).onchange = () => { dirty = true; };
plot.onclick = (event) => {
  const left = 64, right = 8;
  go(duration * (event.offsetX - left) / (plot.clientWidth - left - right));
};
canvas.onpointermove = (event) => {
  if (!event.buttons) return;
  if (event.shiftKey || event.buttons === 4) {
    const { right, top } = axes(), scale = camera.distance / canvas.clientHeight;
    for (let d = 0; d < 3; ++d) camera.target[d] += scale * (event.movementY * top[d] - event.movementX * right[d]);
  } else {
    camera.yaw -= 0.008 * event.movementX;
    camera.pitch = Math.min(Math.max(camera.pitch + 0.008 * event.movementY, -1.5), 1.5);
  }
  dirty = true;
};
canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  camera.distance *= Math.exp(0.001 * event.deltaY);
  dirty = true;
}, { passive: false });
addEventListener('keydown', (event) => {
  if (event.target.tagName === 'INPUT' || event.target.tagName === 'SELECT' || event.target.tagName === 'BUTTON') return;
  if (event.key === ' ') { playButton.onclick(); event.preventDefault(); }
  if (event.key === 'ArrowRight') go(time + duration / 100);
  if (event.key === 'ArrowLeft') go(time - duration / 100);
});
addEventListener('resize', resize);
showPlaying();
resize();
show();
requestAnimationFrame(tick);
