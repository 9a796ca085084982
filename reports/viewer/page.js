// SPDX-License-Identifier: BSD-3-Clause
// The views of the report: answers, comparison, stability. No library, no network, no eval. The parts
// (page/*.js, shared/*.js) share one scope; the build puts them here, in this order.
'use strict';
(() => {
// part: dom
// part: axes
// part: plot
// part: data
// part: words
// part: address
// part: answers
// part: chosen
// part: solution
// part: compare
// part: regions
// part: methods
// part: start
})();
