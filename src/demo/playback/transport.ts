import type { Stage } from '../../index.ts';
import { create, iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import type { Scrubber } from './scrubber.ts';
import { strings } from '../strings.ts';

// Update interval of the clock in milliseconds. An update on every frame would flicker.
const READOUT_MS = 100;

/**
 * Play, pause, step, restart, timeline, simulated time, speed and full screen.
 * @param opener button below the timeline
 * @param more buttons after all others
 */
export function createTransport(
  stage: Stage,
  scrubber: Scrubber,
  opener: HTMLElement,
  ...more: HTMLElement[]
): HTMLElement {
  const { title, restart, step } = strings.transport;
  const restartButton = iconButton('icon-button', restart, icon('restart'), () => stage.restart());
  const stepButton = iconButton('icon-button', step, icon('step'), () => stepOnce(stage));
  const bar = create('div', { class: 'transport card', role: 'group', 'aria-label': title });
  bar.append(restartButton, createPlayButton(stage), stepButton);
  bar.append(
    create('div', { class: 'scrubber' }, createTimeline(stage, scrubber), opener),
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

/** Initial length of the timeline and its increment, in seconds: a compromise between range and precision. */
const SPAN_SECONDS = 10;
const STEP_SECONDS = 0.1;

/** A slider over simulated time. The thumb shows the requested time, the filled part the current time. */
function createTimeline(stage: Stage, scrubber: Scrubber): HTMLInputElement {
  const name = strings.transport.timeline;
  const range = { type: 'range', min: 0, max: SPAN_SECONDS, step: STEP_SECONDS, value: 0 };
  const line = create('input', { ...range, class: 'timeline', 'aria-label': name, title: name });
  let isHeld = false;
  const fill = (seconds: number) => line.style.setProperty('--filled', String(seconds / Number(line.max)));
  const show = (seconds: number) => {
    const wanted = scrubber.wanted ?? seconds;
    const last = Math.max(seconds, wanted);
    if (last >= Number(line.max)) line.max = String(SPAN_SECONDS * (Math.floor(last / SPAN_SECONDS) + 1));
    if (!isHeld) line.value = String(wanted);
    line.setAttribute('aria-valuetext', strings.transport.time(line.valueAsNumber));
    fill(seconds);
  };
  scrubber.listen(() => show(stage.stats.time));
  stage.on('frame', ({ time }) => show(time));
  line.addEventListener('input', () => void scrubber.go(line.valueAsNumber));
  pauseWhileDragging(line, stage, (held) => (isHeld = held));
  show(stage.stats.time);
  return line;
}

/** Pauses the stage while a pointer holds the thumb, and resumes afterwards if it was playing. */
export function pauseWhileDragging(line: HTMLElement, stage: Stage, notify: (isHeld: boolean) => void): void {
  line.addEventListener('pointerdown', () => {
    const goesOn = stage.playing;
    stage.pause();
    notify(true);
    const release = () => {
      removeEventListener('pointerup', release);
      removeEventListener('pointercancel', release);
      notify(false);
      if (goesOn) stage.play();
    };
    addEventListener('pointerup', release);
    addEventListener('pointercancel', release);
  });
}

/** Toggles full screen. Does nothing where the browser does not allow it. */
export async function toggleFullScreen(): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else if (document.fullscreenEnabled) await document.documentElement.requestFullscreen();
}

/** Full-screen button, hidden where full screen is unavailable, for example on some phones and in some iframes. */
function createFullScreenButton(): HTMLButtonElement {
  const { fullScreen } = strings.transport;
  const button = iconButton('icon-button', fullScreen, icon('fullScreen'), () => void toggleFullScreen());
  button.hidden = !document.fullscreenEnabled;
  document.addEventListener('fullscreenchange', () => {
    button.setAttribute('aria-pressed', String(document.fullscreenElement !== null));
  });
  button.setAttribute('aria-pressed', 'false');
  return button;
}
