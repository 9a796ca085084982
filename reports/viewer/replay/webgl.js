// SPDX-License-Identifier: BSD-3-Clause
// WebGL: one program for lines and triangles, one for sprites. Without WebGL the script ends here.
const canvas = byId('view');
const gl = canvas.getContext('webgl', { antialias: true });
if (!gl) {
  byId('message').hidden = false;
  byId('message').textContent =
    'This page draws with WebGL, which this browser does not offer here.';
  report.error = 'no WebGL';
  return;
}
const build = (vertex, fragment) => {
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(gl.getShaderInfoLog(shader));
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
    'void main() { gl_FragColor = vec4(shade.rgb * shade.a, shade.a); }',
);
const sprite = build(
  'attribute vec3 place; attribute vec4 colour; attribute float radius; uniform mat4 view;' +
    'uniform float pixels; varying vec4 shade;' +
    'void main() { gl_Position = view * vec4(place, 1.0); shade = colour;' +
    'gl_PointSize = max(2.0 * radius * pixels / gl_Position.w, 3.0); }',
  'precision mediump float; varying vec4 shade;' +
    'void main() { vec2 p = 2.0 * gl_PointCoord - 1.0; float r = dot(p, p); if (r > 1.0) discard;' +
    'float light = 0.55 + 0.45 * dot(vec3(p.x, -p.y, sqrt(1.0 - r)), vec3(-0.4, 0.5, 0.77));' +
    'gl_FragColor = vec4(shade.rgb * light, 1.0); }',
);
const placeBuffer = gl.createBuffer(), colourBuffer = gl.createBuffer(),
  radiusBuffer = gl.createBuffer();
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
