import type { Stage } from '../../index.ts';
import { create, iconButton } from '../ui/dom.ts';
import { createFullScreenButton } from './fullScreen.ts';
import { icon } from '../ui/icons.ts';
import type { Scrubber } from './scrubber.ts';
import { strings } from '../strings.ts';
import { createTimeline } from './timeline.ts';

// Update interval of the clock in milliseconds. An update on every frame would flicker.
const READOUT_MS = 100;

/**
 * Play, pause, step, restart, timeline, simulated time, speed and full screen.
 * @param more buttons after all others
 */
export function createTransport(stage: Stage, scrubber: Scrubber, ...more: HTMLElement[]): HTMLElement {
  const { title, restart, step } = strings.transport;
  const restartButton = iconButton('icon-button', restart, icon('restart'), () => stage.restart());
  const stepButton = iconButton('icon-button', step, icon('step'), () => stepOnce(stage));
  const bar = create('div', { class: 'transport card', role: 'group', 'aria-label': title });
  bar.append(restartButton, createPlayButton(stage), stepButton);
  bar.append(
    createTimeline(stage, scrubber),
    createReadout(stage),
    createSpeed(stage),
    createFullScreenButton(),
    ...more,
  );
  return bar;
}

/** Steps and pauses: a single step during playback would not be visible. */
export function stepOnce(stage: Stage): void {
  stage.pause();
  stage.step(1);
}

export function togglePlaying(stage: Stage): void {
  if (stage.playing) stage.pause();
  else stage.play();
}

function createPlayButton(stage: Stage): HTMLButtonElement {
  const { play, pause } = strings.transport;
  const button = iconButton('icon-button play', play, icon('play'), () => togglePlaying(stage));
  const show = () => {
    const name = stage.playing ? pause : play;
    button.replaceChildren(icon(stage.playing ? 'pause' : 'play'));
    button.setAttribute('aria-label', name);
    button.title = name;
  };
  stage.on('statechange', show);
  show();
  return button;
}

function createSpeed(stage: Stage): HTMLSelectElement {
  const { speed, speeds } = strings.transport;
  const options = speeds.map(([value, label]) => create('option', { value }, label));
  const select = create('select', { class: 'speed', 'aria-label': speed, title: speed }, ...options);
  select.addEventListener('change', () => (stage.speed = Number(select.value)));
  return select;
}

function createReadout(stage: Stage): HTMLElement {
  const readout = create('span', { class: 'time', role: 'timer', 'aria-live': 'off' });
  let last = Number.NEGATIVE_INFINITY;
  stage.on('frame', ({ time }) => {
    const now = performance.now();
    if (stage.playing && now - last < READOUT_MS) return;
    last = now;
    readout.textContent = strings.transport.time(time);
  });
  readout.textContent = strings.transport.time(stage.stats.time);
  return readout;
}
