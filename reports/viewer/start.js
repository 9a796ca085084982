// SPDX-License-Identifier: BSD-3-Clause
// Shows the views; each again when the address names it, or the window changes its width.
const views = { answers: showAnswers, compare: showCompare, regions: showRegions, methods: showMethods };
const hostOf = (view) => document.querySelector(`[data-view="${view}"]`);
const failed = (view) => (error) => {
  document.documentElement.dataset.error = String(error);
  hostOf(view).replaceChildren(html('p', { class: 'missing', role: 'alert' }, `This view could not be shown: ${error.message}.`));
};
const show = (view, choice) => Promise.resolve(views[view](hostOf(view), choice)).catch(failed(view));
const follow = () => {
  const { view, choice } = readAddress();
  return views[view] ? show(view, choice).then(() => document.getElementById(view).scrollIntoView()) : null;
};
const start = async () => {
  takeIndex(await load('index'));
  const { view, choice } = readAddress();
  await show('answers', view === 'answers' ? choice : {});
  document.documentElement.dataset.drawn = 'answers';
  // The others when the first has been painted.
  setTimeout(async () => {
    for (const other of ['compare', 'regions', 'methods']) await show(other, view === other ? choice : {});
    document.documentElement.dataset.drawn = 'all';
    if (view !== 'answers' && views[view]) document.getElementById(view).scrollIntoView();
  }, 30);
  window.addEventListener('hashchange', follow);
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    const now = readAddress();
    for (const each of Object.keys(views)) show(each, now.view === each ? now.choice : {});
  });
};
if (typeof DecompressionStream === 'undefined') for (const view of Object.keys(views)) failed(view)(new Error('this browser is too old to unpack its data'));
else start().catch(failed('answers'));
