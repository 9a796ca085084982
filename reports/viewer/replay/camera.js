// SPDX-License-Identifier: BSD-3-Clause
// The camera orbits a target; `up` stays up.
const up = 'xyz'.indexOf(scene.up), ahead = (up + 1) % 3, aside = (up + 2) % 3;
const camera = {
  yaw: -0.9, pitch: 0.3, distance: 1.25 * extent, target: center.slice(),
  matrix: new Float32Array(16), pixels: 1,
};
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => {
  const l = Math.hypot(...a) || 1;
  return a.map((x) => x / l);
};
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
  const f = 2, aspect = canvas.width / canvas.height, near = camera.distance / 100,
    far = camera.distance * 3 + 4 * extent;
  const depth = (far + near) / (near - far), shift = (2 * far * near) / (near - far);
  // The field of view is that of the shorter side of the window.
  const rows = [
    right.map((x) => (x * f) / Math.max(aspect, 1)), top.map((x) => x * f * Math.min(aspect, 1)),
  ];
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
  camera.pixels = (f * Math.min(canvas.height, canvas.width)) / 2;
};
