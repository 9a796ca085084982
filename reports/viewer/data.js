// SPDX-License-Identifier: BSD-3-Clause
// The report's data: scripts in data/ that hand compressed JSON to `receive`
// (src/odeum/report/columns.hpp), since a page that is opened from a disk may load scripts and
// nothing else. `facts` is the content of page.json.
'use strict';
(() => {
  const { html, sum } = odeum;

  const arrived = new Map(), wanted = new Map();
  const inflate = async (text) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return JSON.parse(await new Response(stream).text());
  };
  const receive = ([name, text]) => {
    arrived.set(name, inflate(text));
  };

  const loadScript = (address) =>
    new Promise((resolve, reject) => {
      document.head.append(
        html('script', {
          src: address, onload: resolve,
          onerror: () => reject(new Error(`${address} is not there`)),
        }),
      );
    });
  // The data of a file in data/; rejected where it is not there, or hands over nothing of its name.
  const load = (name) => {
    if (arrived.has(name)) return arrived.get(name);
    if (!wanted.has(name))
      wanted.set(
        name,
        loadScript(`data/${name}.js`).then(() => {
          if (!arrived.has(name)) throw new Error(`data/${name}.js holds no data of that name`);
          return arrived.get(name);
        }),
      );
    return wanted.get(name);
  };

  const notNumbers = { inf: Infinity, '-inf': -Infinity };
  const decoded = (column) =>
    !column
      ? []
      : Array.isArray(column)
        ? column.map((v) => (v === null ? NaN : typeof v === 'string' ? notNumbers[v] : v))
        : column.of.map((i) => column.words[i]);
  // A table, column by column. A column is decoded when it is first asked for.
  class Rows {
    constructor(name, parts, length, names) {
      this.name = name;
      this.parts = parts;
      this.length = length;
      this.names = names;
      this.columns = new Map();
    }
    has(name) {
      return this.names.includes(name);
    }
    column(name) {
      if (!this.columns.has(name))
        this.columns.set(
          name,
          this.parts.length === 1
            ? decoded(this.parts[0][name])
            : this.parts.flatMap((part) => decoded(part[name])),
        );
      return this.columns.get(name);
    }
    // The numbers of the rows for which `holds(i)`; of all where it is null.
    indices(holds) {
      const found = [];
      for (let i = 0; i < this.length; ++i) if (!holds || holds(i)) found.push(i);
      return found;
    }
    objects() {
      const columns = this.names.map((name) => this.column(name));
      return Array.from({ length: this.length }, (_, i) =>
        Object.fromEntries(this.names.map((name, k) => [name, columns[k][i]])),
      );
    }
  }
  const idOf = (row) => `${row.library}/${row.solver}`;
  const isClosedForm = (row) => Boolean(facts.solverOf.get(idOf(row))?.closed_form);
  // Rows of which no other has less cost and less error; a closed form competes with none.
  const frontOf = (rows, cost, error) => {
    let least = Infinity;
    return rows
      .filter((row) => !isClosedForm(row))
      .sort((a, b) => a[cost] - b[cost] || a[error] - b[error])
      .filter((row) => row[error] < least && (least = row[error]));
  };

  const facts = {
    cases: [], solvers: [], libraries: [], studies: [], tables: [], questions: [], solutions: {},
  };
  const takeFacts = (page) => {
    Object.assign(facts, page);
    facts.libraryNames = [...new Set(facts.solvers.map((solver) => solver.library))];
    facts.solverOf = new Map(
      facts.solvers.map((solver) => [`${solver.library}/${solver.method}`, solver]),
    );
    // The families of most solvers have shapes of their own; the others share the last.
    const counts = d3.rollups(facts.solvers, (list) => list.length, (solver) => solver.family);
    facts.shapeOfFamily = new Map(
      d3.sort(counts, ([, a], [, b]) => b - a).map(([family], i) => [family, Math.min(i, 7)]),
    );
    facts.caseOf = new Map(facts.cases.map((c) => [c.id, c]));
    facts.tableOf = new Map(facts.tables.map((table) => [table.name, table]));
  };

  const tablesRead = new Map();
  // The rows of a file of the report by its name without endings, of one case where `id` is given;
  // no rows where it was not measured.
  const rowsOf = (name, id) => {
    const table = facts.tableOf.get(name), split = table && table.parts.some((part) => part.case);
    const key = split && id ? `${name}:${id}` : name;
    if (!tablesRead.has(key))
      tablesRead.set(
        key,
        Promise.all(
          (table ? table.parts : [])
            .filter((part) => !split || !id || part.case === id)
            .map((part) => load(part.data).then((data) => [data, part.rows])),
        ).then(
          (parts) =>
            new Rows(
              name, parts.map(([data]) => data), sum(parts.map(([, rows]) => rows)),
              table ? table.columns : [],
            ),
        ),
      );
    if (split || !id) return tablesRead.get(key);
    return tablesRead.get(key).then((rows) => onlyOf(rows, id));
  };
  // The rows of one case, of a table that has all cases together.
  const onlyOf = (rows, id) => {
    if (!rows.has('case')) return rows;
    const cases = rows.column('case'), kept = rows.indices((i) => cases[i] === id);
    const part = new Rows(rows.name, [], kept.length, rows.names);
    part.column = (name) => {
      if (!part.columns.has(name)) {
        const all = rows.column(name);
        part.columns.set(name, kept.map((i) => all[i]));
      }
      return part.columns.get(name);
    };
    return part;
  };
  // Cases with runs, whether of their orders or timed.
  const measuredCases = () => {
    const ids = new Set(
      ['convergence', 'precision'].flatMap((name) => facts.tableOf.get(name)?.cases || []),
    );
    return facts.cases.filter((c) => ids.has(c.id));
  };
  const isMeasured = (name) => (facts.tableOf.get(name)?.rows || 0) > 0;

  const casesRead = new Map();
  // The runs, timed runs and orders of a case as lists of objects.
  const loadCase = (id) => {
    if (!casesRead.has(id))
      casesRead.set(
        id,
        Promise.all(
          ['convergence', 'precision', 'orders'].map((name) =>
            rowsOf(name, id).then((rows) => rows.objects()),
          ),
        ).then(([runs, timed, orders]) => ({ runs, timed, orders })),
      );
    return casesRead.get(id);
  };

  // Colour means library: the same everywhere, by its place in the list of libraries. Shape means
  // family.
  const styleNumbers = [0, 1, 2, 3, 4, 6, 7, 5];
  const colourOf = (library) =>
    `var(--s${styleNumbers[Math.max(0, facts.libraryNames.indexOf(library)) % 8]})`;
  const shapeOf = (solver) => facts.shapeOfFamily.get(solver ? solver.family : '') ?? 7;

  Object.assign(odeum, {
    receive, loadScript, load, Rows, idOf, isClosedForm, frontOf, facts, takeFacts, tablesRead,
    rowsOf, measuredCases, isMeasured, loadCase, colourOf, shapeOf,
  });
})();
