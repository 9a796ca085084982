// SPDX-License-Identifier: BSD-3-Clause
// Expressions over rows, for the blocks and sentences of a study's page.md. A name is a column; a
// word beside == or != that is not a column is a text. There is no eval: an expression becomes a
// tree, the tree a function.
//
//   status == ok and factor < 2 * limit             or, and, not, == != < <= > >=, + - * / ^, ( )
//   if(c, a, b)  log10(x)  abs(x)  shade(x, a, b, c)   functions, see `functions`
//   max(error)                                       of the rows of a cell, see `aggregates`
//   max(factor of mesh where springs == structural)  of the rows of any table
//   count(limits where status == differs)            how many
'use strict';
(() => {
  const { sum, facts, number } = odeum;

  const tokenise = (text) => {
    const kinds = [
      /([0-9]+\.?[0-9]*(?:e[+-]?[0-9]+)?|\.[0-9]+(?:e[+-]?[0-9]+)?)/, /([A-Za-z_][A-Za-z_0-9]*)/,
      /'([^']*)'/, /"([^"]*)"/, /(==|!=|<=|>=|[-+*/^<>(),])/,
    ];
    const pattern = new RegExp(`\\s*(?:${kinds.map((kind) => kind.source).join('|')})`, 'y');
    const tokens = [];
    for (let at = 0; text.slice(at).trim();) {
      pattern.lastIndex = at;
      const found = pattern.exec(text);
      if (!found) throw new Error(`"${text}": "${text.slice(at).trim()[0]}" was not expected`);
      const [, digits, name, single, double, sign] = found;
      tokens.push(
        digits !== undefined
          ? { value: Number(digits) }
          : name !== undefined
            ? { name }
            : sign !== undefined
              ? { sign }
              : { value: single ?? double },
      );
      at = pattern.lastIndex;
    }
    return tokens;
  };

  const sorted = (list) => [...list].sort((a, b) => a - b);
  // Functions of a list of values. Numbers that are not known are left out of min, max, mean,
  // median and sum; where none is known, the first four are not known.
  const extreme = (list, of) => (known(list).length ? known(list).reduce((a, b) => of(a, b)) : NaN);
  const aggregates = {
    count: (list) => list.length, min: (list) => extreme(list, Math.min),
    max: (list) => extreme(list, Math.max), sum: (list) => sum(known(list)),
    mean: (list) => sum(known(list)) / known(list).length,
    median: (list) => sorted(known(list))[Math.floor(known(list).length / 2)] ?? NaN,
    first: (list) => list[0] ?? NaN, last: (list) => list[list.length - 1] ?? NaN,
    distinct: (list) => new Set(list).size,
    list: (list) => [...new Set(list)].filter((value) => value !== '').join(', '),
    any: (list) => list.some(Boolean), all: (list) => list.every(Boolean),
  };
  const known = (list) => list.filter((value) => !Number.isNaN(value));
  const functions = {
    // A number that a study's program gives its texts (Declaration::figures), by study.name.
    figure: (name) => {
      const [study, key] = name.split('.');
      const value = facts.studies.find((each) => each.name === study)?.figures?.[key];
      if (value === undefined) throw new Error(`there is no figure ${name}`);
      return value;
    },
    // Whether times were taken while the machine drifted, or other programs had the processor.
    disturbed: (drift, share) => {
      const most = functions.figure('precision.most_disturbance');
      return Math.abs(drift) > most || share < 1 - most;
    },
    if: (condition, yes, no) => (condition ? yes : no),
    abs: Math.abs,
    sqrt: Math.sqrt,
    exp: Math.exp,
    log10: Math.log10,
    log2: Math.log2,
    round: Math.round,
    floor: Math.floor,
    min: Math.min,
    max: Math.max,
    hypot: Math.hypot,
    known: (value) => !Number.isNaN(value) && value !== '',
    finite: Number.isFinite,
    starts: (text, with_) => String(text).startsWith(with_),
    text: String,
    // A class of the style sheet for a signed size against three limits: t1 to t3 above 0, t-1 to
    // t-3 below.
    shade: (size, slight, strong, extreme) => {
      const level = [slight, strong, extreme].filter((limit) => Math.abs(size) >= limit).length;
      return level ? `t${size < 0 ? '-' : ''}${level}` : '';
    },
    // The text of the first limit that a value is not above: grade(x, 'good', 1e-9, '', 1e-2,
    // 'bad').
    grade: (value, ...rest) =>
      Number.isNaN(value)
        ? ''
        : rest[2 * d3.range(1, rest.length, 2).filter((k) => value > rest[k]).length],
    // "1/60 s" for a step that is a whole part of a second, else "0.0125 s".
    seconds: (step) =>
      step < 1 && Math.abs(1 / step - Math.round(1 / step)) < 1e-6 / step && 1 / step < 1e5
        ? `1/${Math.round(1 / step)} s`
        : `${number(step)} s`,
    number: (value, digits) => number(value, digits),
  };

  class Parser {
    constructor(text) {
      this.text = text;
      this.tokens = tokenise(text);
      this.at = 0;
    }
    fail(what) {
      throw new Error(`"${this.text}": ${what}`);
    }
    peek() {
      return this.tokens[this.at] || {};
    }
    take(word) {
      const token = this.peek();
      if (token.sign !== word && token.name !== word) return false;
      this.at += 1;
      return true;
    }
    expect(word) {
      if (!this.take(word)) this.fail(`${word} was expected`);
    }
    chain(next, words) {
      let left = next.call(this);
      for (let found; (found = words.find((word) => this.take(word)));)
        left = { op: found, left, right: next.call(this) };
      return left;
    }
    expression() {
      return this.chain(this.conjunction, ['or']);
    }
    conjunction() {
      return this.chain(this.negation, ['and']);
    }
    negation() {
      return this.take('not') ? { op: 'not', left: this.negation() } : this.comparison();
    }
    comparison() {
      return this.chain(this.sum, ['==', '!=', '<=', '>=', '<', '>']);
    }
    sum() {
      return this.chain(this.product, ['+', '-']);
    }
    product() {
      return this.chain(this.factor, ['*', '/']);
    }
    factor() {
      if (this.take('-')) return { op: '-', left: { value: 0 }, right: this.factor() };
      const base = this.atom();
      return this.take('^') ? { op: '^', left: base, right: this.factor() } : base;
    }
    atom() {
      if (this.take('(')) {
        const inner = this.expression();
        this.expect(')');
        return inner;
      }
      const token = this.peek();
      this.at += 1;
      if ('value' in token) return token;
      if (!token.name)
        this.fail(token.sign ? `${token.sign} was not expected` : 'it ends too early');
      return this.take('(') ? this.call(token.name) : token;
    }
    call(name) {
      if (!Object.hasOwn(functions, name) && !Object.hasOwn(aggregates, name))
        this.fail(`there is no function ${name}`);
      if (this.take(')')) return { call: name, arguments: [] };
      const first = this.expression();
      if (
        aggregates[name] &&
        (this.take('of') ||
          (name === 'count' &&
            first.name &&
            (this.peek().name === 'where' || this.peek().sign === ')')))
      ) {
        const of =
          name === 'count' && first.name && this.tokens[this.at - 1].name !== 'of'
            ? first
            : this.atom();
        const where = this.take('where') ? this.expression() : null;
        this.expect(')');
        return { aggregate: name, value: of === first ? null : first, rows: of.name, where };
      }
      const list = [first];
      while (this.take(',')) list.push(this.expression());
      this.expect(')');
      return { call: name, arguments: list };
    }
    whole() {
      const tree = this.expression();
      if (this.at < this.tokens.length) this.fail('more than one expression stands here');
      return tree;
    }
  }
  const parse = (text) => new Parser(text).whole();

  // The names of the tables that a tree reads.
  const tablesIn = (tree, found = new Set()) => {
    if (!tree || typeof tree !== 'object') return found;
    if (tree.aggregate) found.add(tree.rows);
    for (const part of Object.values(tree))
      if (Array.isArray(part)) part.forEach((each) => tablesIn(each, found));
      else tablesIn(part, found);
    return found;
  };

  const operations = {
    or: (a, b) => a || b, and: (a, b) => a && b, not: (a) => !a,
    '==': (a, b) => a === b, '!=': (a, b) => a !== b, '<': (a, b) => a < b,
    '<=': (a, b) => a <= b, '>': (a, b) => a > b, '>=': (a, b) => a >= b,
    '+': (a, b) => a + b, '-': (a, b) => a - b, '*': (a, b) => a * b,
    '/': (a, b) => a / b, '^': (a, b) => a ** b,
  };
  // The function (i, group) of a tree over rows: the value at row i, `group` being the rows of its
  // cell. `tables` holds every table that the tree reads.
  const bind = (tree, rows, tables) => {
    if ('value' in tree && !tree.aggregate) return () => tree.value;
    if (tree.name) {
      if (!rows || !rows.has(tree.name))
        throw new Error(
          `there is no column ` +
            `${tree.name}${rows ? ` in ${rows.name}: ${rows.names.join(', ')}` : ''}`,
        );
      const column = rows.column(tree.name);
      return (i) => column[i];
    }
    if (tree.op) {
      // A word beside == is a text unless it is a column.
      const side = (part) =>
        ['==', '!='].includes(tree.op) && part.name && !(rows && rows.has(part.name))
          ? () => part.name
          : bind(part, rows, tables);
      const left = side(tree.left), right = tree.right ? side(tree.right) : null,
        apply = operations[tree.op];
      return right
        ? (i, group) => apply(left(i, group), right(i, group))
        : (i, group) => apply(left(i, group));
    }
    if (tree.aggregate) {
      const of = tables.get(tree.rows);
      if (!of) throw new Error(`there are no rows ${tree.rows}`);
      const chosen = of.indices(tree.where ? bind(tree.where, of, tables) : null);
      const value = tree.value ? bind(tree.value, of, tables) : (i) => i;
      const result = aggregates[tree.aggregate](chosen.map((i) => value(i, chosen)));
      return () => result;
    }
    const list = tree.arguments.map((part) => bind(part, rows, tables));
    if (aggregates[tree.call] && list.length <= 1) {
      const value = list[0] || ((i) => i);
      return (i, group) => aggregates[tree.call]((group || [i]).map((each) => value(each, group)));
    }
    const apply = functions[tree.call];
    return (i, group) => apply(...list.map((each) => each(i, group)));
  };

  Object.assign(odeum, { functions, parse, tablesIn, bind });
})();
