// SPDX-License-Identifier: BSD-3-Clause
// The report's data: scripts in data/ that hand over compressed JSON (report/columns.hpp).
const arrived = new Map(), awaited = new Map();
const inflate = async (text) => {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
};
const receive = ([name, text]) => {
  arrived.set(name, inflate(text));
  if (awaited.has(name)) awaited.get(name)(arrived.get(name));
};
(self.odeumData || []).forEach(receive);
self.odeumData = { push: receive };

const wanted = new Map();
// The data of a file in data/; rejected where it is not there.
const load = (name) => {
  if (arrived.has(name)) return arrived.get(name);
  if (!wanted.has(name)) wanted.set(name, new Promise((resolve, reject) => {
    awaited.set(name, resolve);
    document.head.append(html('script', { src: `data/${name}.js`, onerror: () => reject(new Error(`data/${name}.js is not there`)) }));
  }));
  return wanted.get(name);
};

// A table of columns as a list of rows.
const rowsOf = (columns) => {
  const names = Object.keys(columns || {});
  if (!names.length) return [];
  const decode = { inf: Infinity, '-inf': -Infinity };
  const read = names.map((name) => {
    const column = columns[name];
    if (Array.isArray(column)) return column.map((v) => (v === null ? NaN : typeof v === 'string' ? decode[v] : v));
    return column.of.map((i) => column.words[i]);
  });
  return read[0].map((_, i) => Object.fromEntries(names.map((name, k) => [name, read[k][i]])));
};
const idOf = (row) => `${row.library}/${row.solver}`;

// What index.js has: cases, solvers, questions, who is fastest, limits of stability.
const facts = { cases: [], solvers: [], libraries: [], questions: [], fastest: [], limits: [], solutions: [] };
const takeIndex = (index) => {
  Object.assign(facts, { ...index, fastest: rowsOf(index.fastest), limits: rowsOf(index.limits) });
  facts.solverOf = new Map(facts.solvers.map((solver) => [`${solver.library}/${solver.method}`, solver]));
  facts.caseOf = new Map(facts.cases.map((c) => [c.id, c]));
};

const casesRead = new Map();
// The runs, timed runs and orders of a case; empty lists where none were measured.
const loadCase = (id) => {
  const c = facts.caseOf.get(id);
  if (!c || !c.data) return Promise.resolve({ runs: [], timed: [], orders: [] });
  if (!casesRead.has(id)) casesRead.set(id, load(c.data).then((data) => ({
    runs: rowsOf(data.runs), timed: rowsOf(data.timed), orders: rowsOf(data.orders) })));
  return casesRead.get(id);
};

// Colour means library: the same everywhere, by its place in the list of libraries. Shape means family.
const styleNumbers = [0, 1, 2, 3, 4, 6, 7, 5];
const colourOf = (library) => `var(--s${styleNumbers[Math.max(0, facts.libraries.indexOf(library)) % 8]})`;
const families = ['explicit_rk', 'implicit_rk', 'symplectic', 'multistep', 'linearly_implicit', 'extrapolation', 'physics_engine'];
const shapeOf = (solver) => { const i = families.indexOf(solver ? solver.family : ''); return i < 0 ? 7 : i; };
