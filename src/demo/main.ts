/** The demo page, built on the public API. Parses the address, creates the stage and then adds the controls. */
import { ContextError, createStage, LoadError, type Stage } from '../index.ts';
import { nextTask, readEnvironment, pauseWhileHidden, sizeOf, watchSize, type Environment } from '../internal.ts';
import { decode, type Values } from '../preset.ts';
import { fadePoster, linkOf, removePoster } from './poster.ts';
import { textButton } from './ui/dom.ts';
import { goToMoment, momentOf } from './share/moment.ts';
import { notifyAll, Notices } from './ui/notices.ts';
import { workOffline } from './offline/register.ts';
import { fetchSimulator, followSimulator, windForward, withProgress } from './ui/progress.ts';
import { createErrorScreen } from './ui/errorScreen.ts';
import { strings } from './strings.ts';

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
/** After this time in milliseconds the controls appear even without a picture. */
const LATE_MS = 3000;

const canvas = document.querySelector<HTMLCanvasElement>('#smoke')!;
const container = document.querySelector<HTMLElement>('#interface')!;
const calm = matchMedia('(prefers-reduced-motion: reduce)');

async function start(): Promise<void> {
  // Evaluating the modules was a task of its own.
  await nextTask();
  const environment = readEnvironment(location.search);
  container.classList.toggle('is-bare', !environment.hasInterface);
  const decoded = await decode(linkOf(location.hash));
  const notices = new Notices();
  container.append(notices.element);
  const moment = momentOf(decoded, environment);
  const stage = await load(decoded.state.values, environment);
  // Add messages after the live region, otherwise screen readers treat them as initial content.
  notifyAll(notices, decoded);
  notifyAll(notices, environment);
  window.cartoonSmoke = stage;
  if (!stage.stats.writesDepth) notices.notify(strings.notices.flat);
  stage.on('error', (error) => {
    if (error instanceof LoadError) offerRetry(stage, error, notices);
    else if (error instanceof ContextError) showUntilRestored(stage, error);
    else showError(error);
  });
  followSimulator(stage, container);
  // Before anything follows the stage, so that the address keeps the moment until the first edit.
  if (moment) await goToMoment(stage, moment, notices, container);
  watchSize(canvas, ({ width, height, pixelRatio }) => stage.resize(width, height, pixelRatio));
  pauseWhileHidden(stage);
  const seen = firstPicture(stage);
  const beginning = begin(stage, moment ? { ...environment, time: 0 } : environment, notices);
  await Promise.all([
    Promise.all([seen, beginning]).then(fadePoster),
    seen.then(async () => {
      const { addControls } = await import('./controls.ts');
      await addControls({ stage, canvas, container, notices, environment, decoded });
      container.classList.remove('is-incomplete');
    }),
  ]);
  workOffline((takeOver) => notices.offer(strings.notices.newVersion, strings.notices.reload, takeOver));
}

/** Resolves when the first picture is presented, or is late, for example because the stage has no area. */
async function firstPicture(stage: Stage): Promise<void> {
  await new Promise<void>((resolve) => {
    const end = stage.on('frame', () => resolve(end()));
    setTimeout(resolve, LATE_MS);
  });
  // A frame is presented when the next one begins. Hidden pages have no frames.
  await new Promise((resolve) => {
    requestAnimationFrame(resolve);
    setTimeout(resolve, LATE_MS);
  });
}

function load(values: Values, { quality, view }: Environment): Promise<Stage> {
  const { loading } = strings.scenes[String(values.scene)];
  return withProgress(loading, container, (onProgress) =>
    createStage(canvas, { values, ...sizeOf(canvas), quality, view, visible: false, onProgress }),
  );
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

/** Code could not be loaded. The stage runs on without it. */
function offerRetry(stage: Stage, { message }: Error, notices: Notices): void {
  const complete = async () => {
    if (stage.running.simulation.lacksForces) await fetchSimulator(container);
    await stage.complete();
  };
  notices.offer(message, strings.notices.retry, () => {
    complete().catch((error: Error) => offerRetry(stage, error, notices));
  });
}

/** The browser may restore a lost context later. */
function showUntilRestored(stage: Stage, error: ContextError): void {
  const screen = createErrorScreen(error);
  for (const child of container.children) (child as HTMLElement).inert = true;
  container.append(screen);
  const end = stage.on('frame', () => {
    end();
    screen.remove();
    for (const child of container.children) (child as HTMLElement).inert = false;
  });
}

function showError(error: unknown): void {
  canvas.hidden = true;
  removePoster();
  container.replaceChildren(createErrorScreen(error));
  container.classList.remove('is-bare');
}

start().catch(showError);
