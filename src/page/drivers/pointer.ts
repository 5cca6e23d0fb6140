import { ParameterError, requireOptions } from '../../base/errors.ts';
import { drive, OPTIONS, type DrivenSmoke, type Driver, type DriverOptions } from './driver.ts';
import { requireRanges, type DrivenRanges } from './ranges.ts';
import { requireSpeed, Speed } from './speed.ts';

export interface PointerDriverOptions extends DriverOptions {
  drives: DrivenRanges;
  /** Only movements over this element count. Default: those over the whole page. */
  over?: Element;
  /** Speed that counts as 1, 1 to 100,000 CSS pixels per second. Default: 2000. */
  fullSpeed?: number;
}

/** Default seconds: events come in bursts. */
const SMOOTHING = 0.15;

interface Position {
  readonly clientX: number;
  readonly clientY: number;
}

/**
 * Changes parameters of smoke by the speed of the mouse, the pen or the finger. A resting pointer is 0. Of several pointers
 * each adds its way.
 * @throws ParameterError for an invalid option, a parameter that cannot be driven or an invalid value
 */
export function driveByPointer(smoke: DrivenSmoke, options: PointerDriverOptions): Driver {
  requireOptions('driveByPointer', options, ['drives', 'over', 'fullSpeed', ...OPTIONS]);
  const { drives, over, fullSpeed, smoothing = SMOOTHING } = options;
  if (over !== undefined && !(over instanceof Element)) throw new ParameterError('over', over, 'an Element');
  const speed = new Speed(requireSpeed(fullSpeed));
  const positions = new Map<number, Position>();
  return drive(
    smoke,
    {
      tracks: [requireRanges('drives', drives)],
      isLive: () => speed.isMoving,
      start(wake, signal) {
        const target: EventTarget = over ?? globalThis;
        const move = (event: Event) => {
          const { pointerId, clientX, clientY } = event as PointerEvent;
          const before = positions.get(pointerId);
          positions.set(pointerId, { clientX, clientY });
          if (before && wake()) speed.add(Math.hypot(clientX - before.clientX, clientY - before.clientY));
        };
        const leave = (event: Event) => void positions.delete((event as PointerEvent).pointerId);
        target.addEventListener('pointermove', move, { signal, passive: true });
        // A finger that touches elsewhere has not moved there. Others leave the window or the element.
        for (const end of ['pointerup', 'pointercancel', 'pointerleave', 'pointerout']) {
          const isLeft = (event: Event) => {
            const { pointerType, relatedTarget } = event as PointerEvent;
            if (end === 'pointerup' && pointerType !== 'touch') return;
            if (end === 'pointerout' && relatedTarget !== null) return;
            leave(event);
          };
          target.addEventListener(end, isLeft, { signal, passive: true });
        }
      },
      measure: (seconds) => [speed.over(seconds)],
    },
    { ...options, smoothing },
  );
}
