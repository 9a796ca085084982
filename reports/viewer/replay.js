// SPDX-License-Identifier: BSD-3-Clause
// The replay page: a scene's frames in WebGL, its energy beside. No library, no network, no eval.
'use strict';
(() => {
  const byId = (id) => document.getElementById(id);
  const report = document.documentElement.dataset;  // what the page's test reads
  const scene = JSON.parse(byId('scene').textContent);
  const unpack = (text, Kind) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Kind(bytes.buffer);
  };
  const counts = unpack(scene.counts, Uint32Array), allIds = unpack(scene.ids, Uint32Array);
  const states = unpack(scene.states, Float32Array), radii = unpack(scene.radii, Float32Array);
  const fixed = unpack(scene.fixed, Uint32Array), ends = unpack(scene.springs, Uint32Array);
  const rest = unpack(scene.rest, Float32Array);
  const times = scene.times, last = times.length - 1, duration = times[last] || 1;

  // Where each frame begins in the arrays.
  const firstParticle = new Uint32Array(times.length + 1);
  counts.forEach((n, k) => { firstParticle[k + 1] = firstParticle[k] + n; });
  const position = (k, i, d) => states[6 * firstParticle[k] + 3 * i + d];
  const velocity = (k, i, d) => states[6 * firstParticle[k] + 3 * (counts[k] + i) + d];
  const idOf = (k, i) => allIds[firstParticle[k] + i];
  const emits = counts.some((n) => n !== scene.listed);
  // Particles come in ascending ids: the one of an id is found by halving.
  const indexOf = (k, id) => {
    if (!emits) return id;
    let low = 0, high = counts[k] - 1;
    while (low <= high) {
      const middle = (low + high) >> 1, found = idOf(k, middle);
      if (found === id) return middle;
      if (found < id) low = middle + 1; else high = middle - 1;
    }
    return -1;
  };

  // ---- ranges: the box that holds the scene, the largest speed and strain
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  let fastest = 0;
  const strains = [];
  const springLength = (k, s) => Math.hypot(
    ...[0, 1, 2].map((d) => position(k, ends[2 * s + 1], d) - position(k, ends[2 * s], d)));
  const strainOf = (length, s) => (rest[s] > 0 ? length / rest[s] - 1 : length);
  for (let k = 0; k <= last; ++k) {
    for (let i = 0; i < counts[k]; ++i) {
      for (let d = 0; d < 3; ++d) {
        const x = position(k, i, d);
        if (!Number.isFinite(x)) continue;
        low[d] = Math.min(low[d], x);
        high[d] = Math.max(high[d], x);
      }
      const v = Math.hypot(velocity(k, i, 0), velocity(k, i, 1), velocity(k, i, 2));
      if (Number.isFinite(v)) fastest = Math.max(fastest, v);
    }
    const stride = Math.max(1, Math.floor(rest.length * times.length / 200000));
    for (let s = k % stride; s < rest.length; s += stride) strains.push(strainOf(springLength(k, s), s));
  }
  for (const surface of scene.surfaces) {
    if (surface.kind !== 'sphere') continue;
    for (let d = 0; d < 3; ++d) {
      low[d] = Math.min(low[d], surface.center[d] - surface.radius);
      high[d] = Math.max(high[d], surface.center[d] + surface.radius);
    }
  }
  if (!(low[0] <= high[0])) { low.fill(-1); high.fill(1); }
  fastest = fastest || 1;
  // The strain that all but one in fifty stay within: single threads must not wash out the rest.
  const sizes = strains.filter(Number.isFinite).map(Math.abs).sort((a, b) => a - b);
  const strainMax = sizes.length ? Math.max(sizes[Math.floor(0.98 * (sizes.length - 1))], 1e-6) : 1;
  const center = low.map((x, d) => (x + high[d]) / 2);
  const extent = Math.max(Math.hypot(...low.map((x, d) => high[d] - x)), 1e-3);

  // ---- colours
  const ramp = (stops) => (x) => {
    const s = Math.min(Math.max(x, 0), 1) * (stops.length - 1), i = Math.min(Math.floor(s), stops.length - 2);
    return stops[i].map((c, d) => (c + (stops[i + 1][d] - c) * (s - i)) / 255);
  };
  const speedStops = [[72, 60, 150], [50, 110, 180], [40, 165, 150], [130, 205, 85], [250, 230, 60]];
  const strainStops = [[70, 130, 255], [170, 185, 205], [255, 95, 70]];
  const speedColour = ramp(speedStops), strainColour = ramp(strainStops);
  const gradient = (stops) => `linear-gradient(to right, ${stops.map((s) => `rgb(${s})`).join(', ')})`;
  const shown = (x) => (Math.abs(x) >= 0.01 && Math.abs(x) < 1e4 ? x.toPrecision(3) : x.toExponential(1));
  byId('speed-bar').style.background = gradient(speedStops);
  byId('strain-bar').style.background = gradient(strainStops);
  byId('speed-max').textContent = `${shown(fastest)} m/s`;
  byId('strain-low').textContent = `-${shown(100 * strainMax)} %`;
  byId('strain-high').textContent = `+${shown(100 * strainMax)} %`;
  if (!rest.length) { byId('strain-legend').hidden = true; byId('springs').parentElement.hidden = true; }
  if (!scene.cloths.length) byId('surface').parentElement.hidden = true;

  // ---- WebGL: one program for lines and triangles, one for sprites
  const canvas = byId('view');
  const gl = canvas.getContext('webgl', { antialias: true });
  if (!gl) {
    byId('message').hidden = false;
    byId('message').textContent = 'This page draws with WebGL, which this browser does not offer here.';
    report.error = 'no WebGL';
    return;
  }
  const build = (vertex, fragment) => {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, 'place');
    gl.bindAttribLocation(program, 1, 'colour');
    gl.bindAttribLocation(program, 2, 'radius');
    gl.linkProgram(program);
    return program;
  };
  const flat = build(
    'attribute vec3 place; attribute vec4 colour; uniform mat4 view; varying vec4 shade;' +
    'void main() { gl_Position = view * vec4(place, 1.0); shade = colour; }',
    'precision mediump float; varying vec4 shade;' +
    'void main() { gl_FragColor = vec4(shade.rgb * shade.a, shade.a); }');
  const sprite = build(
    'attribute vec3 place; attribute vec4 colour; attribute float radius; uniform mat4 view;' +
    'uniform float pixels; varying vec4 shade;' +
    'void main() { gl_Position = view * vec4(place, 1.0); shade = colour;' +
    'gl_PointSize = max(2.0 * radius * pixels / gl_Position.w, 3.0); }',
    'precision mediump float; varying vec4 shade;' +
    'void main() { vec2 p = 2.0 * gl_PointCoord - 1.0; float r = dot(p, p); if (r > 1.0) discard;' +
    'float light = 0.55 + 0.45 * dot(vec3(p.x, -p.y, sqrt(1.0 - r)), vec3(-0.4, 0.5, 0.77));' +
    'gl_FragColor = vec4(shade.rgb * light, 1.0); }');
  const placeBuffer = gl.createBuffer(), colourBuffer = gl.createBuffer(), radiusBuffer = gl.createBuffer();
  const feed = (location, buffer, data, size) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, 0, 0);
  };
  const draw = (program, mode, places, colours, sizesOfPoints) => {
    if (!places.length) return;
    gl.useProgram(program);
    gl.uniformMatrix4fv(gl.getUniformLocation(program, 'view'), false, camera.matrix);
    feed(0, placeBuffer, new Float32Array(places), 3);
    feed(1, colourBuffer, new Float32Array(colours), 4);
    gl.disableVertexAttribArray(2);
    if (sizesOfPoints) {
      feed(2, radiusBuffer, new Float32Array(sizesOfPoints), 1);
      gl.uniform1f(gl.getUniformLocation(program, 'pixels'), camera.pixels);
    }
    gl.drawArrays(mode, 0, places.length / 3);
  };

  // ---- camera: orbits a target, `up` stays up
  const up = 'xyz'.indexOf(scene.up), ahead = (up + 1) % 3, aside = (up + 2) % 3;
  const camera = { yaw: -0.9, pitch: 0.3, distance: 1.25 * extent, target: center.slice(), matrix: new Float32Array(16), pixels: 1 };
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const unit = (a) => { const l = Math.hypot(...a) || 1; return a.map((x) => x / l); };
  const axes = () => {
    const back = [0, 0, 0], upward = [0, 0, 0];
    back[ahead] = Math.cos(camera.pitch) * Math.cos(camera.yaw);
    back[aside] = Math.cos(camera.pitch) * Math.sin(camera.yaw);
    back[up] = Math.sin(camera.pitch);
    upward[up] = 1;
    const right = unit(cross(upward, back));
    return { back, right, top: cross(back, right) };
  };
  const placeCamera = () => {
    const { back, right, top } = axes();
    const eye = camera.target.map((x, d) => x + camera.distance * back[d]);
    const f = 2, aspect = canvas.width / canvas.height, near = camera.distance / 100, far = camera.distance * 3 + 4 * extent;
    const depth = (far + near) / (near - far), shift = 2 * far * near / (near - far);
    // The shorter side of the window sees the same, however wide the other is.
    const rows = [right.map((x) => x * f / Math.max(aspect, 1)), top.map((x) => x * f * Math.min(aspect, 1))];
    const m = camera.matrix;
    for (let d = 0; d < 3; ++d) {
      m[4 * d] = rows[0][d];
      m[4 * d + 1] = rows[1][d];
      m[4 * d + 2] = depth * back[d];
      m[4 * d + 3] = -back[d];
    }
    m[12] = -dot(rows[0], eye);
    m[13] = -dot(rows[1], eye);
    m[14] = -depth * dot(back, eye) + shift;
    m[15] = dot(back, eye);
    camera.pixels = f * Math.min(canvas.height, canvas.width) / 2;
  };

  // ---- what stands still: planes as grids, spheres as shaded triangles
  const still = { lines: [], lineColours: [], faces: [], faceColours: [] };
  const grid = (point, normal, colour) => {
    const n = unit(normal), helper = Math.abs(n[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    const a = unit(cross(n, helper)), b = cross(n, a), half = 0.7 * extent, lines = 12;
    const foot = dot(center.map((x, d) => x - point[d]), n);
    const origin = center.map((x, d) => x - foot * n[d]);
    for (let k = -lines / 2; k <= lines / 2; ++k)
      for (const [along, across] of [[a, b], [b, a]])
        for (const end of [-half, half]) {
          for (let d = 0; d < 3; ++d) still.lines.push(origin[d] + end * along[d] + (2 * k * half / lines) * across[d]);
          still.lineColours.push(...colour);
        }
  };
  for (const surface of scene.surfaces) {
    if (surface.kind === 'plane') grid(surface.point, surface.normal, [0.5, 0.55, 0.6, 0.35]);
    if (surface.kind !== 'sphere') continue;
    const rings = 24, at = (i, j) => {
      const t = Math.PI * i / rings, p = Math.PI * j / rings;
      return [Math.sin(t) * Math.cos(p), Math.sin(t) * Math.sin(p), Math.cos(t)];
    };
    for (let i = 0; i < rings; ++i)
      for (let j = 0; j < 2 * rings; ++j)
        for (const [x, y] of [[i, j], [i + 1, j], [i + 1, j + 1], [i, j], [i + 1, j + 1], [i, j + 1]]) {
          const n = at(x, y), light = 0.35 + 0.25 * n[up] + 0.15 * n[ahead];
          for (let d = 0; d < 3; ++d) still.faces.push(surface.center[d] + 0.985 * surface.radius * n[d]);
          still.faceColours.push(0.75 * light, 0.8 * light, 0.9 * light, 1);
        }
  }
  if (!scene.surfaces.some((s) => s.kind === 'plane')) {
    const floor = center.slice(), normal = [0, 0, 0];
    floor[up] = low[up];
    normal[up] = 1;
    grid(floor, normal, [0.4, 0.42, 0.45, 0.2]);
  }

  // ---- one moment: positions between two frames where the same particles live in both
  const moment = (t) => {
    let k = 0, top = last;
    while (k < top) { const middle = (k + top + 1) >> 1; if (times[middle] <= t) k = middle; else top = middle - 1; }
    const n = counts[k], base = 6 * firstParticle[k];
    const between = !emits && k < last ? (t - times[k]) / (times[k + 1] - times[k]) : 0;
    const next = base + 6 * n;
    const state = new Float32Array(6 * n);
    for (let i = 0; i < 6 * n; ++i)
      state[i] = between > 0 ? states[base + i] + between * (states[next + i] - states[base + i]) : states[base + i];
    return { k, n, state };
  };
  const radiusOf = (id) => Math.max(id < scene.listed ? radii[id] : 0, extent / 400);

  const drawTrails = (now) => {
    const step = Math.max(1, Math.round(times.length / 600)), length = 40, places = [], colours = [];
    const every = Math.max(1, Math.ceil(now.n / 150));
    for (let i = 0; i < now.n; i += every) {
      const id = idOf(now.k, i);
      if (id < scene.listed && fixed[id]) continue;
      let from = [now.state[3 * i], now.state[3 * i + 1], now.state[3 * i + 2]];
      for (let back = 0; back < length; ++back) {
        const k = now.k - back * step;
        if (k < 0) break;
        const j = indexOf(k, id);
        if (j < 0) break;
        const to = [position(k, j, 0), position(k, j, 1), position(k, j, 2)];
        const fade = 0.5 * (1 - back / length);
        places.push(...from, ...to);
        colours.push(0.6, 0.75, 1, fade, 0.6, 0.75, 1, fade * (1 - 1 / length));
        from = to;
      }
    }
    draw(flat, gl.LINES, places, colours);
  };
  const drawSprings = (now) => {
    const places = [], colours = [];
    for (let s = 0; s < rest.length; ++s) {
      const a = 3 * ends[2 * s], b = 3 * ends[2 * s + 1], q = now.state;
      const length = Math.hypot(q[b] - q[a], q[b + 1] - q[a + 1], q[b + 2] - q[a + 2]);
      const colour = strainColour(0.5 + 0.5 * strainOf(length, s) / strainMax);
      places.push(q[a], q[a + 1], q[a + 2], q[b], q[b + 1], q[b + 2]);
      for (let twice = 0; twice < 2; ++twice) colours.push(...colour, 0.8);
    }
    draw(flat, gl.LINES, places, colours);
  };
  const drawCloths = (now) => {
    const places = [], colours = [], q = now.state;
    const corner = (i) => [q[3 * i], q[3 * i + 1], q[3 * i + 2]];
    for (const cloth of scene.cloths)
      for (let i = 0; i + 1 < cloth.rows; ++i)
        for (let j = 0; j + 1 < cloth.columns; ++j) {
          const a = cloth.first + i * cloth.columns + j, c = a + cloth.columns;
          for (const [x, y, z] of [[a, c, c + 1], [a, c + 1, a + 1]]) {
            const p = corner(x), r = corner(y), s = corner(z);
            const n = unit(cross(r.map((v, d) => v - p[d]), s.map((v, d) => v - p[d])));
            const light = 0.25 + 0.4 * Math.abs(0.8 * n[up] + 0.5 * n[ahead] + 0.33 * n[aside]);
            for (const v of [p, r, s]) { places.push(...v); colours.push(0.55 * light, 0.6 * light, 0.75 * light, 1); }
          }
        }
    draw(flat, gl.TRIANGLES, places, colours);
  };
  const drawParticles = (now) => {
    const colours = [], sizesOfPoints = [], q = now.state, half = 3 * now.n;
    for (let i = 0; i < now.n; ++i) {
      const id = idOf(now.k, i), v = half + 3 * i;
      const colour = id < scene.listed && fixed[id] ? [0.75, 0.75, 0.75]
        : speedColour(Math.hypot(q[v], q[v + 1], q[v + 2]) / fastest);
      colours.push(...colour, 1);
      sizesOfPoints.push(radiusOf(id));
    }
    draw(sprite, gl.POINTS, q.subarray(0, half), colours, sizesOfPoints);
  };

  // ---- energy: the whole curve faint, up to now in full colour
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

  // ---- the page's own time
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
  // How many pixels differ from the background, for the page's test.
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
})();
