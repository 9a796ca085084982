// SPDX-License-Identifier: BSD-3-Clause
// The page's time, and the controls that change it.
let time = 0, playing = !matchMedia('(prefers-reduced-motion: reduce)').matches, before = null,
  dirty = true, atEnd = null;
const scrub = byId('scrub'), playButton = byId('play');
scrub.max = duration;
const showPlaying = () => {
  playButton.textContent = playing ? 'Pause' : 'Play';
};
const go = (t) => {
  time = Math.min(Math.max(t, 0), duration);
  dirty = true;
};
const resize = () => {
  const ratio = window.devicePixelRatio || 1;
  for (const one of [canvas, plot, coordinatePlot]) {
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
  gl.polygonOffset(1, 1); // lines on a cloth stay in front of it
  draw(flat, gl.TRIANGLES, still.faces, still.faceColours);
  if (byId('surface').checked) drawCloths(now);
  gl.depthMask(false); // springs that lie in the plane of a grid stay in front of it
  draw(flat, gl.LINES, still.lines, still.lineColours);
  gl.depthMask(true);
  if (byId('springs').checked) drawSprings(now);
  drawParticles(now);
  drawSprites(now, time);
  if (byId('trails').checked) drawTrails(now);
  if (byId('arrows').checked) drawVelocities(now);
  drawEnergy(time);
  drawCoordinate(time);
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
    if (time > duration) {
      time = 0;
      if (atEnd) atEnd();
    }
    dirty = true;
  }
  before = now;
  if (dirty) {
    dirty = false;
    show();
  }
  requestAnimationFrame(tick);
};

// Looks at what moves at the present time, from as far as it takes.
const fit = () => {
  const now = moment(time), from = [Infinity, Infinity, Infinity],
    to = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < now.n; ++i) {
    const id = idOf(now.k, i);
    if (id < scene.listed && fixed[id]) continue;
    for (let d = 0; d < 3; ++d) {
      const x = now.state[3 * i + d];
      if (Number.isFinite(x)) {
        from[d] = Math.min(from[d], x);
        to[d] = Math.max(to[d], x);
      }
    }
  }
  if (!(from[0] <= to[0])) return;
  camera.target = from.map((x, d) => (x + to[d]) / 2);
  camera.distance = 1.25 * Math.max(Math.hypot(...from.map((x, d) => to[d] - x)), extent / 20);
  dirty = true;
  sameCamera();
};
byId('fit').onclick = fit;
byId('trail-length').onchange = () => {
  dirty = true;
};

playButton.onclick = () => {
  playing = !playing;
  showPlaying();
};
scrub.oninput = () => {
  playing = false;
  showPlaying();
  go(Number(scrub.value));
};
for (const id of ['trails', 'springs', 'surface', 'arrows'])
  byId(id).onchange = () => {
    dirty = true;
  };
for (const one of [plot, coordinatePlot])
  one.onclick = (event) => {
    const left = 64, right = 8;
    go((duration * (event.offsetX - left)) / (one.clientWidth - left - right));
  };
canvas.onpointermove = (event) => {
  if (!event.buttons) return;
  if (event.shiftKey || event.buttons === 4) {
    const { right, top } = axes(), scale = camera.distance / canvas.clientHeight;
    for (let d = 0; d < 3; ++d)
      camera.target[d] += scale * (event.movementY * top[d] - event.movementX * right[d]);
  } else {
    camera.yaw -= 0.008 * event.movementX;
    camera.pitch = Math.min(Math.max(camera.pitch + 0.008 * event.movementY, -1.5), 1.5);
  }
  dirty = true;
  sameCamera();
};
canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
canvas.addEventListener(
  'wheel',
  (event) => {
    event.preventDefault();
    camera.distance *= Math.exp(0.001 * event.deltaY);
    dirty = true;
    sameCamera();
  },
  { passive: false },
);
addEventListener('keydown', (event) => {
  if (
    event.target.tagName === 'INPUT' || event.target.tagName === 'SELECT' ||
    event.target.tagName === 'BUTTON'
  )
    return;
  if (event.key === ' ') {
    playButton.onclick();
    event.preventDefault();
  }
  if (event.key === 'ArrowRight') go(time + duration / 100);
  if (event.key === 'ArrowLeft') go(time - duration / 100);
});
addEventListener('resize', resize);
showPlaying();
resize();
show();
requestAnimationFrame(tick);
