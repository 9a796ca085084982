// SPDX-License-Identifier: BSD-3-Clause
// The block `matrix`: rows against columns; and groups of solvers, by which lines are gathered.
'use strict';
(() => {
  const {
    blocks, checkKeys, columnOf, Template, prepare, emptyText, grouped, facts, html, linkOf,
    tableOf, lazyDetails, plural, functions,
  } = odeum;

  // What the lines of a matrix are: the first column that its template names, but "solver" where
  // that is one of them.
  const nameOfRows = (template = 'solver') => {
    const names = template.match(/\b[a-z_]+\b(?!\s*\()/g) || [''];
    return names.includes('solver') ? 'solver' : names[0];
  };

  //   row: template      of a line's header; default {library}/{solver}
  //   column: template   of a column; columns stand in the order in which they come first, cases in
  //                      that of the report
  //   order: expression  by which columns are sorted
  //   heading: template  of a column's head, of its first row
  //   before:            heading = template, columns before the others, of a line's first row
  //   cell, shade, tip   as columns, shade and tips of a table; aggregates are over the rows of
  //                      one cell
  //   keep: expression   lines for which it is false are left out; aggregates are over the rows of
  //                      the line
  //   missing: text      of a cell without rows; default ·
  //   group: template    a table each; default library where lines are solvers
  //   class: …           of the table
  blocks.matrix = async (host, spec, context) => {
    checkKeys(spec, 'matrix', [
      'row', 'column', 'order', 'heading', 'before', 'cell', 'shade', 'tip', 'keep', 'missing',
      'group', 'class',
    ]);
    const row = spec.row || '{library}/{solver}', group = spec.group || (spec.row ? '' : 'library');
    const before = (spec.before || []).map(columnOf);
    const templates = [
      row, spec.column, spec.order, spec.heading, spec.cell, spec.shade, spec.tip, spec.keep, group,
    ].map((text) => (text ? new Template(text) : null));
    const { indices, bound } = await prepare(spec, context, [
      ...templates, ...before.map((c) => c.template),
    ]);
    if (!indices.length) return emptyText(host, spec);
    const [rowOf, columnOf_, order, heading, cell, shade, tip, keep, groupOf] = bound;
    let columns = [...grouped(indices, columnOf_.text)];
    if (order) columns = d3.sort(columns, ([, members]) => order.value(members[0], members));
    else if (spec.column === 'case') {
      const at = new Map(facts.cases.map((c, k) => [c.id, k]));
      columns = d3.sort(columns, ([id]) => at.get(id) ?? Infinity);
    }
    const headings = [
      { text: nameOfRows(spec.row), class: 'corner' },
      ...before.map((c) => ({ text: c.heading, class: 'claim' })),
      ...columns.map(([name, members]) =>
        spec.column === 'case'
          ? { node: html('span', { class: 'turned' }, linkOf('case', name)), class: 'turned' }
          : { text: heading ? heading.text(members[0], members) : name },
      ),
    ];
    const lineOf = ([name, members]) => {
      const cells = grouped(members, columnOf_.text);
      return {
        cells: [
          { text: name, node: linkOf(row, name) },
          ...before.map((c, k) => ({
            text: bound[9 + k].text(members[0], members),
            value: bound[9 + k].value(members[0], members), class: 'claimed',
          })),
          ...columns.map(([key]) => {
            const some = cells.get(key);
            if (!some) return { text: spec.missing ?? '·', class: 'not_applicable', value: NaN };
            return {
              text: cell.text(some[0], some), value: cell.value(some[0], some),
              class: shade?.text(some[0], some), title: tip?.text(some[0], some),
            };
          }),
        ],
      };
    };
    const tableFor = (members) => {
      const lines = [...grouped(members, rowOf.text)].filter(
        ([, some]) => !keep || keep.value(some[0], some),
      );
      return tableOf(headings, lines.map(lineOf), spec.class || 'numbers drifts');
    };
    if (!groupOf) return host.append(tableFor(indices));
    const kept = [...grouped(indices, groupOf.text)]
      .map(([name, members]) => [
        name, members,
        [...grouped(members, rowOf.text).values()].filter(
          (some) => !keep || keep.value(some[0], some),
        ).length,
      ])
      .filter(([, , count]) => count);
    kept.forEach(([name, members, count], k) =>
      host.append(
        lazyDetails(
          [
            html('strong', {}, name), ` ${versionOf(name)} `,
            html('span', { class: 'dim' }, plural(count, spec.row ? 'row' : 'solver')),
          ],
          () => tableFor(members),
          k === 0,
        ),
      ),
    );
    return null;
  };
  const versionOf = (library) =>
    facts.libraries.find((each) => each.solvers.includes(library))?.version || '';

  // Solvers in groups: own ones by family, families of one or two together, peers by library.
  // [{name, title, own, ids}]
  const solverGroups = () => {
    if (facts.solverGroups) return facts.solverGroups;
    const [own, peers] = [true, false].map((is) =>
      facts.solvers.filter((s) => (s.library === 'odeum') === is),
    );
    const families = d3.sort(
        d3.groups(own, (s) => s.family), ([, list]) => -list.length,
      ),
      large = families.filter(([, list]) => list.length > 2);
    const other = families.filter(([, list]) => list.length <= 2).flatMap(([, list]) => list);
    const group =
      (isOwn) =>
      ([name, list]) => {
        const title = isOwn ? name.replaceAll('_', ' ').replace(/ rk$/, ' RK') : name;
        return {
          name: isOwn ? `odeum: ${title}` : title, title, own: isOwn,
          ids: list.map((s) => `${s.library}/${s.method}`),
        };
      };
    facts.solverGroups = [
      ...[...large, ...(other.length ? [['other', other]] : [])].map(group(true)),
      ...d3.groups(peers, (s) => s.library).map(group(false)),
    ];
    facts.groupOf = new Map(
      facts.solverGroups.flatMap((each) => each.ids.map((id) => [id, each.name])),
    );
    return facts.solverGroups;
  };
  functions.solver_group = (library, solver) =>
    solverGroups() && (facts.groupOf.get(`${library}/${solver}`) ?? library);

  Object.assign(odeum, { versionOf, solverGroups, nameOfRows });
})();
