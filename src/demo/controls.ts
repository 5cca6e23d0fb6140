/** Everything that reacts to the user, apart from the stage itself: the page's controls and its input. */
import type { Stage } from '../index.ts';
import { nextTask, ORBIT_PER_KEY, type Environment } from '../internal.ts';
import type { Decoded } from '../preset.ts';
import { followAddress } from './share/address.ts';
import { BallKeys } from './input/ball.ts';
import { Editor } from './editor/editor.ts';
import { enterScene, showSlowProgress, standModel } from './ui/progress.ts';
import { toggleFullScreen, stepOnce, togglePlaying } from './playback/transport.ts';
import { GestureEnd, Pointers } from './input/pointer.ts';
import { Flag } from './ui/flag.ts';
import { listenToKeys } from './input/keyboard.ts';
import { goToMoment, momentOf } from './share/moment.ts';
import { notifyAll, type Notices } from './ui/notices.ts';
import { buildPage, type Page } from './page.ts';
import { Scrubber } from './playback/scrubber.ts';
import { strings } from './strings.ts';

/** What the controls act on. */
export interface Controlled {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Parent of the controls. */
  readonly container: HTMLElement;
  readonly notices: Notices;
  readonly environment: Environment;
  /** The address that the stage shows. */
  readonly decoded: Decoded;
}

/** Number of late frames before a notice appears. By then the governor has ruled out a temporary load. */
const LATE_FRAMES = 8;

/** Adds the controls, in several short tasks. Call it after the first frame. */
export async function addControls(controlled: Controlled): Promise<void> {
  const { stage, canvas, container, notices, environment, decoded } = controlled;
  const editor = new Editor(stage, decoded.state.preset, {
    nextFrame: () => new Promise(requestAnimationFrame),
    enter: (values) => enterScene(stage, values, container),
    setModel: async (model) => {
      for (const message of await standModel(stage, model, container)) notices.notify(message);
    },
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
  describeScene(stage, canvas);
  await nextTask();
  const { hasStatistics } = environment;
  const noShortcuts = new Flag('noShortcuts');
  const page = await buildPage(container, { editor, stage, canvas, notices, scrubber, hasStatistics, noShortcuts });
  connectInput(stage, canvas, editor, page, scrubber, () => !noShortcuts.value);
  showHint(stage, canvas, notices);
  notifyOfSlowMachine(stage, notices);
}

function connectInput(
  stage: Stage,
  canvas: HTMLCanvasElement,
  editor: Editor,
  page: Page,
  scrubber: Scrubber,
  hasShortcuts: () => boolean,
): void {
  const ball = new BallKeys(stage);
  const orbitEnd = new GestureEnd(() => editor.settle());
  new Pointers(stage, canvas, orbitEnd, () => page.dragsBlow);
  listenToKeys(
    {
      ...page,
      togglePlaying: () => togglePlaying(stage),
      step: () => stepOnce(stage),
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
    },
    hasShortcuts,
  );
}

/** Updates the canvas's accessible name with the current scene. */
function describeScene(stage: Stage, canvas: HTMLCanvasElement): void {
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

/** Explains the gestures on the picture at the first visit, until the first one or until it is dismissed. */
function showHint(stage: Stage, canvas: HTMLElement, notices: Notices): void {
  const isKnown = new Flag('knowsGestures');
  if (isKnown.value) return;
  const used = new AbortController();
  const learn = () => {
    isKnown.value = true;
    used.abort();
  };
  const held = strings.scenes[String(stage.get().scene)]?.hand;
  const remove = notices.explain(strings.hint(held), learn);
  used.signal.addEventListener('abort', remove);
  for (const gesture of ['pointerdown', 'wheel', 'keydown']) {
    canvas.addEventListener(gesture, learn, { signal: used.signal, passive: true });
  }
}
