import type { ModelFile, Values } from '../../preset.ts';
import type { LoadProgress, Stage } from '../../index.ts';
import { create, textButton } from './dom.ts';
import { strings } from '../strings.ts';
import { fetchRareForces } from '../../internal.ts';
import type { Scrubber, Seek } from '../playback/scrubber.ts';

/** A progress bar over the page. */
export class Progress {
  readonly element: HTMLElement;
  private readonly bar: HTMLProgressElement;

  /** @param cancel adds a cancel button when given */
  constructor(message: string, cancel?: () => void) {
    this.bar = create('progress', { max: 1, 'aria-label': message });
    const button = cancel ? [textButton('loud', strings.progress.cancel, cancel)] : [];
    this.element = create(
      'div',
      { class: 'progress card', role: 'status' },
      create('p', {}, message),
      this.bar,
      ...button,
    );
  }

  /** @param share 0 to 1; undefined while the total is unknown */
  show(share: number | undefined): void {
    if (share === undefined) this.bar.removeAttribute('value');
    else this.bar.value = share;
  }

  /** Shows the progress of a download. */
  readonly follow = ({ loaded, total }: LoadProgress): void =>
    this.show(total === undefined ? undefined : loaded / total);
}

/** Delay in milliseconds before a loading message appears. */
const LOADING_DELAY_MS = 400;

/**
 * Runs a download, and shows its progress if it is slow.
 * @param container parent of the progress bar
 * @param download takes the function that follows its progress
 */
export async function withProgress<Result>(
  message: string,
  container: HTMLElement,
  download: (follow: Progress['follow']) => Promise<Result>,
): Promise<Result> {
  const progress = new Progress(message);
  const timer = setTimeout(() => container.append(progress.element), LOADING_DELAY_MS);
  try {
    return await download(progress.follow);
  } finally {
    clearTimeout(timer);
    progress.element.remove();
  }
}

/** Shows progress while the smoke waits for the larger simulator of flows and shapes. The stage reports errors. */
export function followSimulator(stage: Stage, container: HTMLElement): void {
  let isLoading = false;
  stage.on('statechange', () => {
    if (isLoading || !stage.running.simulation.isWaiting) return;
    isLoading = true;
    void fetchSimulator(container)
      .catch(() => undefined)
      .finally(() => (isLoading = false));
  });
}

/** Loads the simulator of flows and shapes, and shows progress if it is slow. @throws LoadError */
export function fetchSimulator(container: HTMLElement): Promise<unknown> {
  return withProgress(strings.progress.simulator, container, fetchRareForces);
}

/**
 * Simulates up to a time, with progress and a cancel button.
 * @param message describes the operation; by default, that time advances
 * @returns whether it reached the time; false when cancelled
 */
export async function windForward(
  stage: Stage,
  seconds: number,
  container: HTMLElement,
  message: (seconds: number) => string = strings.progress.winding,
): Promise<boolean> {
  const controller = new AbortController();
  const progress = new Progress(message(seconds), () => controller.abort());
  container.append(progress.element);
  try {
    await stage.seek(seconds, { onProgress: (share) => progress.show(share), signal: controller.signal });
    return true;
  } catch (error) {
    if (controller.signal.aborted) return false;
    throw error;
  } finally {
    progress.element.remove();
  }
}

/** Seeks shorter than this, in milliseconds, show no progress. */
const DELAY_MS = 700;

/**
 * Shows progress and a cancel button for slow seeks.
 * @param container parent of the progress bar
 */
export function showSlowProgress(scrubber: Scrubber, container: HTMLElement): void {
  let current: { seek: Seek; began: number } | undefined;
  let progress: Progress | undefined;
  const end = () => {
    progress?.element.remove();
    progress = undefined;
  };
  scrubber.listen((seek) => {
    if (seek !== current?.seek) {
      end();
      current = seek && { seek, began: performance.now() };
    }
    if (!seek || performance.now() - current!.began < DELAY_MS) return;
    if (!progress) {
      progress = new Progress(strings.progress.winding(seek.goal), () => scrubber.stop());
      container.append(progress.element);
    }
    progress.show(seek.share);
  });
}

/**
 * Makes a model stand in the scene, or removes it, and shows progress over the scene if that is slow.
 * @returns what the model lacks, as sentences
 * @throws the errors of `Stage.setModel`
 */
export async function standModel(
  stage: Stage,
  model: ModelFile | undefined,
  container: HTMLElement,
): Promise<readonly string[]> {
  const work = () => stage.setModel(model?.bytes ?? null, model?.options);
  const shown = model ? await withProgress(strings.model.reading(model.name), container, work) : await work();
  return shown?.notices ?? [];
}

/**
 * Enters the scene of these values, and shows progress over the previous scene if loading is slow.
 * @throws the errors of `Stage.enter`
 */
export function enterScene(stage: Stage, values: Values, container: HTMLElement): Promise<void> {
  const { loading } = strings.scenes[String(values.scene)];
  return withProgress(loading, container, (onProgress) => stage.enter(values, { onProgress }));
}
