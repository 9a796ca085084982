// SPDX-License-Identifier: BSD-3-Clause
// Replays in frames, moved together by one set of controls, with one camera and one scale.
'use strict';
(() => {
  const { html, blocks, prepare, emptyText, idOf } = odeum;

  // The scales of all replays: the widest of each.
  const widest = (scales) => ({
    fastest: d3.max(scales, (each) => each.fastest),
    strain: d3.max(scales, (each) => each.strain),
    offset: d3.min(scales, (each) => each.offset),
    kinetic: d3.extent(scales.flatMap((each) => each.kinetic)),
    others: d3.extent(scales.flatMap((each) => each.others)),
    coordinate: d3.extent(scales.flatMap((each) => each.coordinate)),
  });
  // Replays in frames, moved together by one set of controls, with one camera and one scale:
  // {name, address}.
  const replaysInStep = (host, replays) => {
    const frames = replays.map(({ name, address }) =>
      html('iframe', { src: address, title: `replay of ${name}` }),
    );
    const state = {
      duration: 0, time: 0, playing: false, before: null, camera: null, ready: new Map(),
    };
    const tell = (message, except) => {
      for (const frame of frames)
        if (frame.contentWindow && frame.contentWindow !== except)
          frame.contentWindow.postMessage(message, '*');
    };
    const range = html('input', {
        type: 'range', min: 0, value: 0, step: 'any', 'aria-label': 'time of all replays',
        oninput: () => {
          state.time = Number(range.value);
          show();
        },
      }),
      now = html('output', {});
    const boxes = [
      ['trails', 'trails', true], ['springs', 'springs', true], ['surface', 'cloth', true],
      ['arrows', 'velocities', false],
    ].map(([name, text, checked]) => ({
      name, box: html('input', { type: 'checkbox', checked, onchange: () => show() }), text,
    }));
    const play = html(
      'button',
      {
        type: 'button',
        onclick: () => {
          state.playing = !state.playing;
          play.textContent = state.playing ? 'Pause' : 'Play';
        },
      },
      'Play',
    );
    const rate = html(
      'select', { 'aria-label': 'speed' },
      [
        ['0.1', '1/10'], ['0.5', '1/2'], ['1', '1'], ['2', '2'],
      ].map(([value, text]) => html('option', { value, selected: value === '1' }, text)),
    );
    const show = () => {
      range.value = state.time;
      now.textContent = `t = ${state.time.toFixed(3)} s`;
      tell({
        odeum: 'time', time: state.time,
        ...Object.fromEntries(boxes.map(({ name, box }) => [name, box.checked])),
      });
    };
    const hear = (event) => {
      const from = frames.findIndex((frame) => frame.contentWindow === event.source);
      if (!host.isConnected) return removeEventListener('message', hear);
      if (from < 0 || !event.data) return null;
      if (event.data.odeum === 'ready') {
        state.ready.set(from, event.data.scales);
        state.duration = Math.max(state.duration, event.data.duration);
        range.max = state.duration;
        document.documentElement.dataset.ready = state.ready.size;
        if (state.camera) tell({ odeum: 'camera', camera: state.camera });
        tell({ odeum: 'scales', scales: widest([...state.ready.values()]) });
        show();
      }
      // At first the view of the first replay, later that of the one that was turned.
      if (event.data.odeum === 'camera' && (state.camera || from === 0)) {
        state.camera = event.data.camera;
        tell({ odeum: 'camera', camera: state.camera }, event.source);
      }
      return null;
    };
    addEventListener('message', hear);
    const tick = (time) => {
      if (!host.isConnected) return;
      if (state.playing && state.before !== null) {
        state.time += Math.min((time - state.before) / 1000, 0.1) * Number(rate.value);
        if (state.time > state.duration) state.time = 0;
        show();
      }
      state.before = time;
      requestAnimationFrame(tick);
    };
    host.append(
      html('h2', {}, 'Replays in step'),
      html(
        'div', { class: 'controls together' }, play, range, now,
        html('label', { class: 'field' }, 'speed ', rate),
        boxes.map(({ box, text }) => html('label', {}, box, ` ${text}`)),
      ),
      html(
        'div', { class: 'replays' },
        replays.map(({ name, address }, i) =>
          html(
            'figure', {},
            html('figcaption', {}, html('a', { href: address }, html('code', {}, name))), frames[i],
          ),
        ),
      ),
    );
    requestAnimationFrame(tick);
  };
  //   rows: a table with the columns library, solver and replay (the address of a page)
  blocks.replays = async (host, spec, context) => {
    const { rows, indices } = await prepare(spec, context, []);
    if (!indices.length) return emptyText(host, spec);
    const all = rows.objects();
    replaysInStep(host, indices.map((i) => ({ name: idOf(all[i]), address: all[i].replay })));
    return null;
  };

  Object.assign(odeum, { replaysInStep });
})();
