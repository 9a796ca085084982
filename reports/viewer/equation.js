// SPDX-License-Identifier: BSD-3-Clause
// Equations as a paper has them: the text of a case, y'' + 0.5 y' = -sin(t), read as a tree and
// drawn as MathML, which browsers know. A text that is not a formula stays text.
'use strict';
(() => {
  const { html } = odeum;

  const greek = {
    alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', eps: 'ε', epsilon: 'ε', zeta: 'ζ', theta: 'θ',
    kappa: 'κ', lambda: 'λ', mu: 'μ', nu: 'ν', xi: 'ξ', pi: 'π', rho: 'ρ', sigma: 'σ', tau: 'τ',
    phi: 'φ', psi: 'ψ', omega: 'ω',
  };
  const functions = [
    'sin', 'cos', 'tan', 'exp', 'log', 'sinh', 'cosh', 'tanh', 'asin', 'acos', 'atan',
  ];
  const signs = { '-': '−', '*': '·', '..': '…' };

  // A token is [kind, text, whether a space stands before it]; null: the text is not a formula.
  const tokensOf = (text) => {
    const digits = '\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?',
      name = "[A-Za-z]+[A-Za-z0-9]*(?:_(?:\\{[^{}]*\\}|[A-Za-z0-9]+))?'*";
    const mark = "\\.\\.|'+|[-+*/^=<>(),|[\\]]";
    const pattern = new RegExp(`(\\s*)(?:(${digits})|(${name})|(${mark}))`, 'y');
    const tokens = [];
    for (const body = text.trimEnd(); pattern.lastIndex < body.length;) {
      const at = pattern.exec(body);
      if (!at) return null;
      const kind = at[2] ? 'number' : at[3] ? 'name' : at[4];
      tokens.push([kind, at[2] || at[3] || at[4], at[1] !== '']);
    }
    return tokens;
  };

  // The tree of a text: ['row', ...], ['over', a, b], ['power', a, b], ['below', a, index],
  // ['primed', a, primes], ['root', a], ['space'], and with a text 'number', 'name', 'function',
  // 'sign', 'tall' (brackets around fractions), 'unary' (before an operand). Throws where it is
  // not a formula; `known`: whether a name of several letters is one.
  const treeOf = (text, known = () => false) => {
    const tokens = tokensOf(text);
    if (!tokens || !tokens.length) throw new Error('no formula');
    let at = 0;
    const kind = () => tokens[at]?.[0], spaced = () => tokens[at]?.[2];
    const take = (wanted) => {
      if (kind() !== wanted) throw new Error(`no ${wanted}`);
      at += 1;
    };
    const row = (list) => (list.length === 1 ? list[0] : ['row', ...list]);
    const sign = (symbol) => ['sign', signs[symbol] || symbol];
    // Brackets are as tall as fractions between them.
    const within = (open, content, close) => {
      const kind = JSON.stringify(content).includes('"over"') ? 'tall' : 'sign';
      return [[kind, open], content, [kind, close]];
    };

    const nameOf = (name) => {
      const [, stem, digits, index, primes] =
        /^([A-Za-z]+?)(\d+[A-Za-z0-9]*)?(?:_(.*?))?('*)$/.exec(name) || [];
      if (stem.length > 1 && !greek[stem] && !known(name.replace(/'+$/, '')) && !digits)
        throw new Error(`${name} is a word`);
      const plain = ['name', greek[stem] || stem],
        primed = (tree) => (primes ? ['primed', tree, '′'.repeat(primes.length)] : tree);
      const below = index?.replace(/^\{|\}$/g, '') || digits;
      if (!below) return primed(plain);
      const parts = below.split(',').map((part) => {
        try {
          return treeOf(part, known);
        } catch {
          return ['name', part];
        }
      });
      return primed([
        'below', plain, row(parts.flatMap((part, k) => (k ? [sign(','), part] : [part]))),
      ]);
    };
    // x[i], and its rate x[i]'.
    const elementOf = (word) => {
      take('[');
      const element = ['below', ['name', greek[word] || word], relation()];
      take(']');
      if (!/^'/.test(kind() || '')) return element;
      at += 1;
      return ['primed', element, '′'.repeat(tokens[at - 1][1].length)];
    };
    const inside = (close) => {
      const list = [relation()];
      while (kind() === ',') {
        take(',');
        list.push(sign(','), relation());
      }
      take(close);
      return row(list);
    };
    const base = () => {
      const [type, word] = tokens[at] || [];
      if (type === 'number') {
        at += 1;
        const [, digits, power] = /^(.*?)(?:e\+?(.*))?$/.exec(word);
        return power
          ? row([
              ['number', digits], sign('*'),
              [
                'power', ['number', '10'],
                ['number', power.replace(/^(-?)0*/, (_, less) => (less ? '−' : ''))],
              ],
            ])
          : ['number', word];
      }
      if (type === '(') {
        take('(');
        return row(within('(', inside(')'), ')'));
      }
      if (type === '|') {
        take('|');
        const content = sum();
        take('|');
        return row(within('|', content, '|'));
      }
      if (type !== 'name') throw new Error('no operand');
      at += 1;
      if (word === 'sqrt') {
        take('(');
        return ['root', inside(')')];
      }
      if (word === 'sum' && kind() === '(') {
        take('(');
        const index = base();
        take(',');
        return row([['below', sign('∑'), index], ...within('(', inside(')'), ')')]);
      }
      if (functions.includes(word))
        return row([['function', word], ...(kind() === '(' ? [] : [['space']]), power()]);
      const name = kind() === '[' && !spaced() ? elementOf(word) : nameOf(word);
      if (kind() !== '(' || spaced()) return name;
      take('(');
      return row([name, ...within('(', inside(')'), ')')]);
    };
    const bare = (tree) =>
      tree[0] === 'row' && tree.length === 4 && tree[1][1] === '(' && tree[3][1] === ')'
        ? tree[2]
        : tree;
    const power = () => {
      const of = base();
      if (kind() !== '^') return of;
      take('^');
      if (kind() !== '-') return ['power', of, bare(base())];
      take('-');
      return ['power', of, row([sign('-'), base()])];
    };
    const term = () => {
      let list = [power()];
      for (;;) {
        if (kind() === '*') {
          take('*');
          list.push(sign('*'), power());
        } else if (kind() === '/') {
          take('/');
          list = [['over', bare(row(list)), bare(power())]];
        } else if (['number', 'name', '('].includes(kind())) list.push(['space'], power());
        else return row(list);
      }
    };
    const sum = () => {
      const list = [];
      if (kind() === '-' || kind() === '+') {
        list.push(['unary', signs[kind()] || kind()]);
        at += 1;
      }
      list.push(term());
      while (kind() === '-' || kind() === '+') {
        list.push(sign(kind()));
        at += 1;
        list.push(term());
      }
      return row(list);
    };
    const relation = () => {
      const list = [sum()];
      while (['=', '<', '>', '..'].includes(kind())) {
        list.push(sign(kind()));
        at += 1;
        list.push(sum());
      }
      return row(list);
    };
    const tree = relation();
    if (at < tokens.length) throw new Error('more than a formula');
    return tree;
  };

  // A text in parts, at commas and semicolons outside of brackets: each a tree, or text.
  const partsOf = (text) => {
    const pieces = [''];
    let depth = 0;
    for (const letter of text) {
      depth += '([{'.includes(letter) ? 1 : ')]}'.includes(letter) ? -1 : 0;
      if ((letter === ',' || letter === ';') && depth === 0) pieces.push(letter, '');
      else pieces[pieces.length - 1] += letter;
    }
    // A name that the text defines, as in "amplitude = 5", is not a word.
    const named = new Set(
      [...text.matchAll(/([A-Za-z]\w*)'*(?:\(0\))? = /g)].map(([, name]) => name),
    );
    const read = (piece) => {
      if (piece === ',' || piece === ';') return [piece];
      try {
        return [treeOf(piece.trim(), (name) => named.has(name))];
      } catch {
        // A formula may end where words begin.
        const [, start, words] = /^(.+?)( (?:from|where|at|and|for|in) .*)$/.exec(piece) || [];
        return start ? [...read(start), words] : [piece];
      }
    };
    return pieces.filter(Boolean).flatMap(read);
  };

  const element = (tag, ...children) => {
    const made = document.createElementNS('http://www.w3.org/1998/Math/MathML', tag);
    made.append(...children);
    return made;
  };
  const tags = {
    row: 'mrow', over: 'mfrac', power: 'msup', below: 'msub', primed: 'mrow', root: 'msqrt',
    number: 'mn', sign: 'mo', tall: 'mo', unary: 'mo', name: 'mi', function: 'mi', space: 'mspace',
  };
  const drawn = ([kind, ...of]) => {
    // The sign of a prime is raised already.
    const parts = kind === 'primed' ? [of[0], ['sign', of[1]]] : of;
    const made = element(
      tags[kind], ...parts.map((each) => (Array.isArray(each) ? drawn(each) : each)),
    );
    const set = (name, value) => made.setAttribute(name, value);
    if (kind === 'unary') set('form', 'prefix');
    if (kind === 'space') set('width', '0.17em');
    if (['sign', 'tall'].includes(kind) && /^[(),|′]/.test(of[0])) {
      set('stretchy', String(kind === 'tall'));
      set('lspace', '0');
      set('rspace', of[0] === ',' ? '0.25em' : '0');
    }
    return made;
  };

  // The longest text that is typeset: a screen of it is read by nobody.
  const longest = 2000;
  // A case's equation for a page. `display`: fractions of full height.
  const equationOf = (text, display = false) => {
    if (!text || text.length > longest) return html('code', {}, text || '');
    const parts = partsOf(text);
    if (parts.every((part) => typeof part === 'string')) return html('code', {}, text);
    const made = parts.map((part) => {
      if (part === ',' || part === ';') return `${part} `;
      if (typeof part === 'string') return part.trim();
      const math = element('math', drawn(part));
      if (display) math.setAttribute('displaystyle', 'true');
      return math;
    });
    // It scrolls where a part of it is wider than the page.
    return html(
      'span', { class: 'formula', tabindex: 0, role: 'group', 'aria-label': 'equation' }, made,
    );
  };

  Object.assign(odeum, { treeOf, partsOf, equationOf });
})();
