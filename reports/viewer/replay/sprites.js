// SPDX-License-Identifier: BSD-3-Clause
// Emitted particles that have a look: soft sprites whose colour, size and opacity change over their
// life. They hide nothing and are drawn from the farthest to the nearest, or their light is added.
const lives = unpack(scene.lives, Float32Array), looks = scene.looks;
const lookOf = (id) => id < scene.listed ? null : looks[lives[3 * (id - scene.listed) + 2]] || null;
const anyLook = looks.some(Boolean);
const soft =
  anyLook &&
  build(
    'attribute vec3 place; attribute vec4 colour; attribute float radius; uniform mat4 view;' +
      'uniform float pixels; varying vec4 shade;' +
      'void main() { gl_Position = view * vec4(place, 1.0); shade = colour;' +
      'gl_PointSize = max(2.0 * radius * pixels / gl_Position.w, 2.0); }',
    'precision mediump float; varying vec4 shade; uniform float additive; uniform float ' +
      'textured; uniform sampler2D picture;' +
      'void main() { vec2 p = 2.0 * gl_PointCoord - 1.0; vec4 texel = texture2D(picture, ' +
      'gl_PointCoord);' +
      'float alpha = shade.a * mix(1.0 - smoothstep(0.0, 1.0, dot(p, p)), texel.a, textured);' +
      'vec3 light = shade.rgb * mix(vec3(1.0), texel.rgb, textured);' +
      'gl_FragColor = vec4(light * alpha, alpha * (1.0 - additive)); }',
  );
const textures = looks.map((look) => {
  if (!look) return null;
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(
    gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4).fill(255),
  );
  if (look.texture) {
    const image = new Image();
    image.onload = () => {
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
      for (const [name, value] of [
        [gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
        [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
      ])
        gl.texParameteri(gl.TEXTURE_2D, name, value);
      report.textures = Number(report.textures || 0) + 1;
      dirty = true;
    };
    image.src = look.texture;
  }
  return texture;
});
const drawSprites = (now, t) => {
  if (!anyLook) return;
  const { back } = axes(), q = now.state, lists = looks.map(() => []);
  for (let i = 0; i < now.n; ++i) {
    const id = idOf(now.k, i), look = lookOf(id);
    if (!look) continue;
    const birth = lives[3 * (id - scene.listed)], lifetime = lives[3 * (id - scene.listed) + 1];
    const age = lifetime > 0 ? Math.min(Math.max((t - birth) / lifetime, 0), 1) : 0;
    const mix = ([from, to]) => from + age * (to - from);
    const colour = [0, 1, 2].map((c) => mix([look.colour[0][c], look.colour[1][c]]));
    const place = [q[3 * i], q[3 * i + 1], q[3 * i + 2]];
    lists[lives[3 * (id - scene.listed) + 2]].push({
      place, near: dot(place, back), colour: [...colour, mix(look.opacity)], size: mix(look.size),
    });
  }
  gl.depthMask(false);
  looks.forEach((look, e) => {
    if (!look || !lists[e].length) return;
    const list = lists[e].sort((a, b) => a.near - b.near);
    gl.useProgram(soft);
    gl.uniform1f(gl.getUniformLocation(soft, 'additive'), look.additive ? 1 : 0);
    gl.uniform1f(gl.getUniformLocation(soft, 'textured'), look.texture ? 1 : 0);
    gl.bindTexture(gl.TEXTURE_2D, textures[e]);
    draw(
      soft, gl.POINTS, list.flatMap((s) => s.place), list.flatMap((s) => s.colour),
      list.map((s) => s.size),
    );
  });
  gl.depthMask(true);
};
