import type { LoadProgress } from '../../sim/load.ts';
import type { Stage } from '../../stage/stage.ts';
import { create, textButton } from './dom.ts';
import { strings } from '../strings.ts';
import type { Scrubber, Seek } from '../playback/scrubber.ts';

/** A bar over the page while something takes its time. */
export class Progress {
  readonly element: HTMLElement;
  private readonly bar: HTMLProgressElement;

  /** @param cancel where given, a button ends the work */
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

  /** @param share 0 to 1; undefined while nobody knows */
  show(share: number | undefined): void {
    if (share === undefined) this.bar.removeAttribute('value');
    else this.bar.value = share;
  }

  /** Shows how far a download is. */
  readonly follow = ({ loaded, total }: LoadProgress): void =>
    this.show(total === undefined ? undefined : loaded / total);
}

/**
 * Simulates up to a time, with progress and a way out.
 * @param message what is being done; by default that time goes on
 * @returns whether it arrived; false when somebody stopped it
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

/** Shorter seeks show no progress. */
const DELAY_MS = 700;

/**
 * Shows the progress of a seek that takes its time, and lets people stop it.
 * @param container where that is shown
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
