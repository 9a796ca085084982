// SPDX-License-Identifier: BSD-3-Clause
// Tables over rows: sorted by a click on a heading, filtered by a word, of any length (rows are
// added as one scrolls).
'use strict';
(() => {
  const {
    Rows, tablesRead, html, plural, wide, blocks, checkKeys, columnOf, byHeading, Template, prepare,
    grouped, linkOf,
  } = odeum;

  const firstRows = 60;

  // Rows that a study's view.js makes of others, under a name of their own: addRows('ends', async
  // () => [{case, …}, …]). They are made when they are first asked for.
  const addRows = (name, make) => {
    let made = null;
    const rows = async () => {
      const list = await make(), names = Object.keys(list[0] || {}),
        table = new Rows(name, [], list.length, names);
      for (const each of names)
        table.columns.set(each, list.map((row) => row[each]));
      return table;
    };
    tablesRead.set(name, {
      then: (resolve, reject) => (made = made || rows()).then(resolve, reject),
    });
  };

  // The order of two cells in a sorted column: numbers, texts, then what is not known; the kinds
  // stand in this order both ways. JavaScript's < between a number and a text is false both ways,
  // which would be no order at all.
  const kindOf = (key) => (Number.isNaN(key) || key === '' ? 2 : typeof key === 'number' ? 0 : 1);
  const compareKeys = (a, b, down) => {
    const kinds = kindOf(a) - kindOf(b);
    if (kinds || kindOf(a) === 2) return kinds;
    const [x, y] = kindOf(a) === 1 ? [String(a), String(b)] : [a, b];
    return (x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1);
  };

  // What cells tell when pointed at, for those who do not point: arrows move from cell to cell, a
  // click or a tap chooses one, and the text stands below the table.
  const cellsTell = (box, body, headings) => {
    const told = html('p', { class: 'told', role: 'status' });
    let at = null;
    const tell = (cell) => {
      at?.classList.remove('at');
      at = cell;
      cell.classList.add('at');
      cell.scrollIntoView({ block: 'nearest', inline: 'nearest' });
      const [head] = cell.parentElement.cells, heading = headings[cell.cellIndex];
      const names = [head.textContent, heading?.text || heading?.node?.textContent];
      told.textContent = `${names.filter(Boolean).join(', ')}: ${cell.title}`;
    };
    const titled = (cells) => [...cells].find((cell) => cell?.title);
    const rows = () => [...body.rows];
    const across = (step) => {
      const cells = [...body.querySelectorAll('td[title], th[title]')];
      return cells[cells.indexOf(at) + step];
    };
    const along = (step) => {
      const all = rows(), from = all.indexOf(at.parentElement);
      const next = step > 0 ? all.slice(from + 1) : all.slice(0, from).reverse();
      return titled(next.map((row) => row.cells[at.cellIndex]));
    };
    box.addEventListener('keydown', (event) => {
      if (!event.key.startsWith('Arrow') || event.target !== box) return;
      const step = ['ArrowRight', 'ArrowDown'].includes(event.key) ? 1 : -1;
      const sideways = ['ArrowRight', 'ArrowLeft'].includes(event.key);
      const next = !at?.isConnected
        ? body.querySelector('td[title], th[title]')
        : sideways
          ? across(step)
          : along(step);
      if (!next) return;
      event.preventDefault();
      tell(next);
    });
    body.addEventListener('click', (event) => {
      const cell = event.target.closest('td[title], th[title]');
      if (cell && !event.target.closest('a, button, summary')) tell(cell);
    });
    return told;
  };

  // A table of `lines`: [{cells: [{text, node, value, class, title, span}], class}], under
  // `headings` [{text, title, class, span}]. The first cell of a line is its header.
  const tableOf = (headings, lines, style = 'numbers', above = null) => {
    const body = html('tbody', {}), state = { by: -1, down: false, word: '' };
    const cellOf = (cell, first) =>
      html(
        first ? 'th' : 'td',
        {
          class: cell.class, title: cell.title, colspan: cell.span,
          scope: first ? 'row' : undefined,
        },
        cell.node || cell.text,
      );
    const rowOf = (line) =>
      html('tr', { class: line.class }, line.cells.map((cell, k) => cellOf(cell, k === 0)));
    const keyOf = (line) => line.cells[state.by]?.value ?? line.cells[state.by]?.text ?? '';
    const compare = (a, b) => compareKeys(keyOf(a), keyOf(b), state.down);
    let shown = [], drawn = 0;
    const more = html(
      'p', { class: 'more' },
      html('button', { type: 'button', onclick: () => append(10 * firstRows) }, 'more rows'),
    );
    const append = (count) => {
      body.append(...shown.slice(drawn, drawn + count).map(rowOf));
      drawn = Math.min(shown.length, drawn + count);
      more.hidden = drawn >= shown.length;
      more.firstChild.textContent = `more rows (${(shown.length - drawn).toLocaleString('en')})`;
    };
    const refresh = () => {
      const words = state.word.toLowerCase().split(/\s+/).filter(Boolean);
      shown = words.length
        ? lines.filter((line) => {
            const text = line.cells
              .map((cell) => cell.text)
              .join(' ')
              .toLowerCase();
            return words.every((word) => text.includes(word));
          })
        : lines;
      if (state.by >= 0) shown = [...shown].sort(compare);
      body.replaceChildren();
      drawn = 0;
      append(firstRows);
    };
    const turn = (k) => {
      state.down = state.by === k && !state.down;
      state.by = k;
      heads.forEach((head, i) =>
        head.setAttribute(
          'aria-sort', i === k ? (state.down ? 'descending' : 'ascending') : 'none',
        ),
      );
      refresh();
    };
    const heads = headings.map((heading, k) =>
      html(
        'th', { class: heading.class, title: heading.title, scope: 'col', 'aria-sort': 'none' },
        heading.node?.cloneNode(true) ||
          html('button', { type: 'button', class: 'sort', onclick: () => turn(k) }, heading.text),
      ),
    );
    refresh();
    const search =
      lines.length > 10
        ? html(
            'label', { class: 'field filter' }, 'Filter ',
            html('input', {
              type: 'search', 'aria-label': 'filter the rows',
              oninput: (event) => {
                state.word = event.target.value;
                refresh();
              },
            }),
            html('small', {}, ` ${plural(lines.length, 'row')}`),
          )
        : null;
    const tells = lines.some((line) => line.cells.some((cell) => cell.title));
    const box = wide(
      tells ? 'table; arrow keys read what its cells tell' : 'table',
      html('table', { class: style }, html('thead', {}, above, html('tr', {}, heads)), body),
    );
    const told = tells ? cellsTell(box, body, headings) : null;
    new IntersectionObserver(
      (seen) => {
        if (seen.some((each) => each.isIntersecting) && drawn < shown.length) append(4 * firstRows);
      },
      { rootMargin: '400px' },
    ).observe(more);
    return html('div', { class: 'table-host' }, search, box, told, more);
  };

  const emptyText = (host, spec) => {
    if (spec.empty !== '') host.append(html('p', { class: 'missing' }, spec.empty || 'No rows.'));
  };

  // A cell of list(…) alone: more than three names are counted, and open on demand.
  const isList = (template) => template.alone && template.trees[0].call === 'list';
  const folded = (text, noun) => {
    const count = text.split(', ').length;
    return count > 3
      ? html('details', {}, html('summary', {}, `${count.toLocaleString('en')} ${noun}`), text)
      : text;
  };

  //   columns:      heading = template, a line each
  //   sort: -value  of an expression; without it, the order of the file
  //   group: name   a table for each text of an expression, closed but for the first
  //   one: text     only the first row of each text of this template; aggregates are over all of
  //                 its rows
  //   shade:        heading = expression that gives a class (shade(…), if(…))
  //   tips:         heading = template, shown when pointed at
  //   class:        of the table in the style sheet
  blocks.table = async (host, spec, context) => {
    checkKeys(spec, 'table', ['columns', 'sort', 'group', 'one', 'shade', 'tips', 'class']);
    if (!Array.isArray(spec.columns)) throw new Error('columns: is a list, a line each');
    const columns = spec.columns.map(columnOf), shades = byHeading(spec.shade),
      tips = byHeading(spec.tips);
    const templates = [
      ...columns.map((c) => c.template), ...columns.map((c) => shades.get(c.heading)),
      ...columns.map((c) => tips.get(c.heading)),
      ...['sort', 'group', 'one'].map((key) => (spec[key] ? new Template(spec[key]) : null)),
    ];
    const { indices, bound } = await prepare(spec, context, templates);
    if (!indices.length) return emptyText(host, spec);
    const n = columns.length, [sort, group, one] = bound.slice(3 * n);
    let lines = one ? [...grouped(indices, one.text).values()] : indices.map((i) => [i]);
    if (sort) lines = d3.sort(lines, ([i, ...rest]) => sort.value(i, [i, ...rest]));
    const lineOf = (members) => ({
      first: members[0],
      cells: columns.map((column, k) => {
        const i = members[0], text = bound[k].text(i, members),
          node = isList(column.template)
            ? folded(text, column.heading)
            : linkOf(column.cell.trim(), text);
        return {
          text, node: node === text ? null : node, value: bound[k].value(i, members),
          class: bound[n + k]?.text(i, members) || (text.length > 40 ? 'reason' : undefined),
          title: bound[2 * n + k]?.text(i, members),
        };
      }),
    });
    const tableFor = (some) =>
      tableOf(
        columns.map((c) => ({ text: c.heading })), some.map(lineOf), spec.class || 'numbers words',
      );
    if (!group) return host.append(tableFor(lines));
    [...grouped(lines, (line) => group.text(line[0], line))].forEach(([name, some], k) =>
      host.append(
        lazyDetails(
          [html('strong', {}, name), ` ${plural(some.length, 'row')}`],
          () => tableFor(some), k === 0,
        ),
      ),
    );
    return null;
  };

  // A <details> whose content is made when it is opened.
  const lazyDetails = (summary, make, open) => {
    const details = html('details', { open }, html('summary', {}, summary));
    const fillIn = () => {
      if (details.open && details.children.length === 1) details.append(...[make()].flat());
    };
    details.addEventListener('toggle', fillIn);
    fillIn();
    return details;
  };

  Object.assign(odeum, { addRows, compareKeys, tableOf, emptyText, lazyDetails });
})();
