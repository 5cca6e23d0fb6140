/**
 * Five variants of a page: empty, with our element in a worker and on the main thread, and with two other libraries.
 */

import { PEERS, SCRIPTS } from './peers.mjs';

/** Number of tsParticles circles: as many as living puffs of the wisp, with the same motion. */
export const CIRCLES = 110;
/** CSS pixels. Forty widgets fit into the viewport. */
const [WIDTH, HEIGHT] = [160, 96];
export const VIEW = { width: 1280, height: 720 };

/**
 * @typedef {object} Contestant
 * @property {string} name
 * @property {string} head
 * @property {(index: number) => string} widget
 * @property {string} [event] that a widget fires with its first picture
 * @property {boolean} [isSingle] whether it takes part with one widget only
 */

/** @type {Contestant[]} */
export const contestants = [
  { name: 'nothing', head: '', widget: () => `<div class="widget"></div>` },
  ours('worker'),
  { ...ours('main'), isSingle: true },
  {
    name: 'tsParticles',
    head: `<script src="/${SCRIPTS.tsParticles}"></script><script>addEventListener('load', ${startParticles.toString()})</script>`,
    widget: (index) => `<div class="widget" id="particles${index}"></div>`,
    event: 'stands',
    isSingle: true,
  },
  {
    name: 'modelViewer',
    head: `<script type="module" src="/${SCRIPTS.modelViewer}"></script>`,
    widget: () =>
      `<model-viewer class="widget" src="/${PEERS}/ball.glb" auto-rotate auto-rotate-delay="0" interaction-prompt="none"></model-viewer>`,
    event: 'load',
  },
];

/** @param {'worker' | 'main'} thread @returns {Contestant} */
function ours(thread) {
  const map = '{ "imports": { "three": "/node_modules/three/build/three.module.js" } }';
  return {
    name: thread,
    head: `<script type="importmap">${map}</script><script type="module" src="/package/dist/element.js"></script>`,
    widget: () => `<cartoon-smoke class="widget" preset="wisp" thread="${thread}"></cartoon-smoke>`,
    event: 'ready',
  };
}

/**
 * An article that starts with widgets, with enough text below to scroll them out of view.
 * @param {Contestant} contestant
 * @param {number} count
 */
export function pageOf({ head, widget }, count) {
  const widgets = Array.from({ length: count }, (_, index) => widget(index)).join('');
  const text = '<p>Somebody writes about something else, and goes on for long.</p>'.repeat(200);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>An article</title><link rel="icon" href="data:,">
    <style>.widget { display: inline-block; width: ${WIDTH}px; height: ${HEIGHT}px; margin: 0; vertical-align: top }</style>
    <script>window.circles = ${CIRCLES}</script>${head}<body style="margin: 0"><div id="widgets" style="font-size: 0">${widgets}</div>${text}`;
}

/** Runs in the page: soft circles that rise in every box. */
async function startParticles() {
  const { tsParticles, loadSlim, circles } = /** @type {any} */ (window);
  await loadSlim(tsParticles);
  const options = {
    fullScreen: { enable: false },
    detectRetina: false,
    fpsLimit: 60,
    particles: {
      number: { value: circles },
      color: { value: '#c8c4cc' },
      opacity: { value: 0.8 },
      size: { value: { min: 3, max: 9 } },
      move: { enable: true, direction: 'top', speed: { min: 0.5, max: 1.5 }, outModes: 'out' },
    },
  };
  for (const { id } of document.querySelectorAll('.widget')) {
    await tsParticles.load({ id, options });
    document.getElementById(id)?.dispatchEvent(new CustomEvent('stands'));
  }
}
