// SPDX-License-Identifier: BSD-3-Clause
// The replay page: a scene's frames in WebGL, and its energy. No library, no network, no eval.
// Its parts (replay/*.js) share one scope; the build puts them here, in this order.
'use strict';
(() => {
// part: data
// part: ranges
// part: colours
// part: webgl
// part: camera
// part: still
// part: sprites
// part: moment
// part: curves
// part: energy
// part: controls
// part: together
})();
