// SPDX-License-Identifier: BSD-3-Clause
// What a chart tells of a point: to the pointer, to keys, and to those who cannot see it.
'use strict';
(() => {
  const { html, svg } = odeum;

  const pointsInside = (curve, x, y) => curve.points.filter((p) => x.holds(p.x) && y.holds(p.y));
  // The tooltip: the nearest run to the pointer; arrows and Enter do the same from the keyboard.
  const attachPointer = (host, picture, spec, x, y) => {
    if (!spec.tell) return;
    const tip = html('div', { class: 'tip', role: 'status', hidden: true });
    const ring = svg('circle', { class: 'ring', r: 7, visibility: 'hidden' });
    picture.append(ring);
    host.append(tip);
    const drawn = [
      ...spec.curves.flatMap((curve, c) =>
        pointsInside(curve, x, y).map((point) => ({ point, curve, c, near: 22 })),
      ),
      ...(spec.cloud || [])
        .filter((p) => x.holds(p.x) && y.holds(p.y))
        .map((point) => ({ point, curve: null, c: -1, near: 8 })),
    ];
    let shown = null;
    const show = (item) => {
      shown = item;
      tip.hidden = !item;
      ring.setAttribute('visibility', item ? 'visible' : 'hidden');
      if (!item) return;
      const left = x.at(item.point.x), top = y.at(item.point.y);
      ring.setAttribute('cx', left);
      ring.setAttribute('cy', top);
      tip.replaceChildren(
        ...spec
          .tell(item.point.run, item.curve)
          .map((line, i) => html(i ? 'div' : 'strong', {}, line)),
      );
      const most = Math.max(0, host.clientWidth - tip.offsetWidth - 4);
      tip.style.left = `${Math.min(left + 12, most)}px`;
      tip.style.top = `${top + 14}px`;
    };
    const nearest = (event) => {
      const box = picture.getBoundingClientRect(), px = event.clientX - box.left,
        py = event.clientY - box.top,
        scale = picture.viewBox.baseVal.width / (box.width || 1);
      const away = (item) =>
        Math.hypot(x.at(item.point.x) - scale * px, y.at(item.point.y) - scale * py) / item.near;
      const best = d3.least(drawn, away);
      return best && away(best) < 1 ? best : null;
    };
    picture.addEventListener('pointermove', (event) => show(nearest(event)));
    picture.addEventListener('pointerleave', () => show(null));
    picture.addEventListener('blur', () => show(null));
    picture.addEventListener('click', (event) => {
      const item = nearest(event);
      show(item);
      if (item && spec.pick) spec.pick(item.point.run, item.curve);
    });
    picture.addEventListener('keydown', (event) => {
      const own = drawn.filter((item) => item.curve), i = own.indexOf(shown);
      const onCurve = (c) => own.find((item) => item.c === c);
      const next = {
        ArrowRight: own[Math.min(own.length - 1, i + 1)], ArrowLeft: own[Math.max(0, i - 1)],
        ArrowDown: shown && onCurve(shown.c + 1), ArrowUp: shown && onCurve(shown.c - 1),
      }[event.key];
      if (event.key === 'Enter' && shown && spec.pick) spec.pick(shown.point.run, shown.curve);
      else if (event.key === 'Escape') show(null);
      else if (next) show(next);
      else if (!event.key.startsWith('Arrow')) return;
      event.preventDefault();
    });
  };

  Object.assign(odeum, { pointsInside, attachPointer });
})();
