/** The demo page, built on the public API. Parses the address, creates the stage and adds the controls. */
import { createStage, LoadError, type Stage } from '../index.ts';
import { ORBIT_PER_KEY, readEnvironment, restWhileHidden, sizeOf, watchSize, type Environment } from '../internal.ts';
import { decode, type Decoded, type Values } from '../preset.ts';
import { followAddress } from './share/address.ts';
import { BallKeys } from './input/ball.ts';
import { textButton } from './ui/dom.ts';
import { Editor } from './editor/editor.ts';
import { enterScene } from './editor/entering.ts';
import { toggleFullScreen } from './playback/fullScreen.ts';
import { GestureEnd } from './input/gestureEnd.ts';
import { listenToKeys } from './input/keyboard.ts';
import { showSlowProgress } from './ui/progress.ts';
import { goToMoment, type LinkedMoment } from './share/moment.ts';
import { Notices } from './ui/notices.ts';
import { workOffline } from './offline/register.ts';
import { buildPage, type Page } from './page.ts';
import { Pointers } from './input/pointer.ts';
import { Progress, windForward } from './ui/progress.ts';
import { createErrorScreen } from './ui/errorScreen.ts';
import { Scrubber } from './playback/scrubber.ts';
import { strings } from './strings.ts';
import { takeStep, togglePlaying } from './playback/transport.ts';

declare global {
  interface Window {
    /** The page's stage, for use in the console. */
    cartoonSmoke?: Stage;
  }
}

/**
 * With reduced motion the page starts with a still frame. After this time in seconds the smoke has filled its column.
 */
const STILL_SECONDS = 4;
/** Number of late frames before a notice appears. By then the governor has ruled out a temporary load. */
const LATE_FRAMES = 8;

const canvas = document.querySelector<HTMLCanvasElement>('#smoke')!;
const container = document.querySelector<HTMLElement>('#interface')!;
const calm = matchMedia('(prefers-reduced-motion: reduce)');

async function start(): Promise<void> {
  const environment = readEnvironment(location.search);
  const decoded = await decode(location.hash);
  const notices = new Notices();
  container.classList.toggle('is-bare', !environment.hasInterface);
  container.append(notices.element);
  const moment = momentOf(decoded, environment);
  const stage = await load(decoded.state.values, environment);
  // Add messages after the live region, otherwise screen readers treat them as initial content.
  notifyAll(notices, decoded);
  notifyAll(notices, environment);
  window.cartoonSmoke = stage;
  if (!stage.stats.writesDepth) notices.notify(strings.notices.flat);
  stage.on('error', (error) => (error instanceof LoadError ? notices.notify(error.message) : showError(error)));
  // Before anything follows the stage, so that the address keeps the moment until the first edit.
  if (moment) await goToMoment(stage, moment, notices, container);
  const editor = new Editor(stage, decoded.state.preset, {
    nextFrame: () => new Promise(requestAnimationFrame),
    enter: (values) => enterScene(stage, values, container),
    notify: (message) => notices.notify(message),
  });
  followAddress(editor, async (read, isNewest) => {
    notifyAll(notices, read);
    const shared = momentOf(read);
    if (!shared) return;
    await editor.delivered();
    if (isNewest()) await goToMoment(stage, shared, notices, container);
  });
  const scrubber = new Scrubber(stage);
  showSlowProgress(scrubber, container);
  const { hasStatistics } = environment;
  const page = buildPage(container, { editor, stage, canvas, notices, scrubber, hasStatistics });
  connectInput(stage, editor, page, scrubber);
  notifyOfSlowMachine(stage, notices);
  describeScene(stage);
  watchSize(canvas, ({ width, height, pixelRatio }) => stage.resize(width, height, pixelRatio));
  restWhileHidden(stage);
  await begin(stage, moment ? { ...environment, time: 0 } : environment, notices);
  workOffline((takeOver) => notices.offer(strings.notices.newVersion, strings.notices.reload, takeOver));
}

function momentOf({ take, state }: Decoded, environment?: Environment): LinkedMoment | undefined {
  return take && { take, state, seconds: environment?.time, isTrusted: false };
}

async function load(values: Values, { quality, view }: Environment): Promise<Stage> {
  const progress = new Progress(strings.scenes[String(values.scene)].loading);
  container.append(progress.element);
  try {
    return await createStage(canvas, {
      values,
      ...sizeOf(canvas),
      quality,
      view,
      visible: false,
      onProgress: progress.follow,
    });
  } finally {
    progress.element.remove();
  }
}

/**
 * Seeks to the first frame, then plays unless the address or the system requests a still frame. Smoke that plays from
 * its first step is shown only once it has particles.
 */
async function begin(stage: Stage, { paused, time }: Environment, notices: Notices): Promise<void> {
  const lead = time ?? (calm.matches ? STILL_SECONDS : 0);
  const playsAtOnce = lead === 0 && !calm.matches && !paused;
  if (playsAtOnce) stage.play();
  stage.visible = true;
  if (lead > 0 && !(await windForward(stage, lead, container))) {
    notices.mention(strings.progress.cancelled(stage.stats.time));
  }
  calm.addEventListener('change', () => calm.matches && stage.pause());
  if (calm.matches) offerToPlay(stage);
  else if (!paused) stage.play();
}

/** Shows a play button over the still frame until playback starts by any means. */
function offerToPlay(stage: Stage): void {
  const button = textButton('loud play-smoke', strings.transport.playSmoke, () => stage.play());
  const end = stage.on('statechange', ({ playing }) => {
    if (!playing) return;
    button.remove();
    end();
  });
  container.append(button);
}

function connectInput(stage: Stage, editor: Editor, page: Page, scrubber: Scrubber): void {
  const ball = new BallKeys(stage);
  const orbitEnd = new GestureEnd(() => editor.settle());
  new Pointers(stage, canvas, orbitEnd, () => page.dragsBlow);
  listenToKeys({
    ...page,
    togglePlaying: () => togglePlaying(stage),
    step: () => takeStep(stage),
    stepBack: () => void scrubber.stepBack(),
    shift: (seconds) => void scrubber.shift(seconds),
    stopSeeking: () => scrubber.stop(),
    fullScreen: () => void toggleFullScreen(),
    restart: () => stage.restart(),
    undo: () => editor.undo(),
    redo: () => editor.redo(),
    zoom: (factor) => {
      stage.camera.zoom(factor);
      orbitEnd.postpone();
    },
    push: (right, up, near) => ball.push(right, up, near),
    orbit: (right, up) => {
      stage.camera.orbit(right * ORBIT_PER_KEY, up * ORBIT_PER_KEY);
      orbitEnd.postpone();
    },
    resetView: () => {
      orbitEnd.now();
      stage.camera.reset();
      orbitEnd.now();
    },
  });
}

function notifyAll(notices: Notices, { notices: list }: Pick<Decoded, 'notices'>): void {
  for (const { message } of list) notices.notify(message);
}

function showError(error: unknown): void {
  canvas.hidden = true;
  container.replaceChildren(createErrorScreen(error));
  container.classList.remove('is-bare');
}

/** Updates the canvas's accessible name with the current scene. */
function describeScene(stage: Stage): void {
  const show = () => {
    const { picture, hand } = strings.scenes[String(stage.get().scene)];
    const label = strings.picture(picture, hand?.thing);
    if (canvas.ariaLabel !== label) canvas.ariaLabel = label;
  };
  stage.on('statechange', show);
  show();
}

/** Notifies once when the machine needs a lower resolution to keep up, and suggests a remedy. */
function notifyOfSlowMachine(stage: Stage, notices: Notices): void {
  let frames = 0;
  const stop = stage.on('frame', ({ scale }) => {
    // Do not report a quality that was set by `?quality=`.
    if (scale === 1 || stage.quality !== 'auto') return;
    frames += 1;
    if (frames < LATE_FRAMES) return;
    stop();
    notices.whisper(strings.notices.slow);
  });
}

start().catch(showError);
