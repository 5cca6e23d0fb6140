import { ParameterError, requireOptions } from '../../base/errors.ts';
import { drive, OPTIONS, type DrivenSmoke, type Driver, type DriverOptions } from './driver.ts';
import { requireRanges, type DrivenRanges } from './ranges.ts';
import { requireSpeed, Speed } from './speed.ts';

export interface ScrollDriverOptions extends DriverOptions {
  drives: DrivenRanges;
  /**
   * What counts: `position`, from the start of the page to its end, or `speed`. Default: `position`.
   */
  by?: 'position' | 'speed';
  /**
   * The position is that of this element in the window: 0 where it enters at the lower edge, 1 where it leaves at the upper
   * edge.
   */
  along?: Element;
  /** The element that scrolls. Default: the page. */
  scroller?: Element;
  /** Speed that counts as 1, 1 to 100,000 CSS pixels per second. Default: 2000. */
  fullSpeed?: number;
}

/**
 * Changes parameters of smoke by vertical scrolling.
 * @throws ParameterError for an invalid option, a parameter that cannot be driven or an invalid value
 */
export function driveByScroll(smoke: DrivenSmoke, options: ScrollDriverOptions): Driver {
  requireOptions('driveByScroll', options, ['drives', 'by', 'along', 'scroller', 'fullSpeed', ...OPTIONS]);
  const { drives, by = 'position', along, scroller, fullSpeed } = options;
  if (by !== 'position' && by !== 'speed') throw new ParameterError('by', by, 'position, speed');
  for (const [name, element] of Object.entries({ along, scroller })) {
    if (element !== undefined && !(element instanceof Element)) throw new ParameterError(name, element, 'an Element');
  }
  const speed = new Speed(requireSpeed(fullSpeed));
  const page = () => scroller ?? document.scrollingElement ?? document.documentElement;
  const position = () => (along ? shareOf(along) : scrolled(page()));
  let top = page().scrollTop;
  return drive(
    smoke,
    {
      tracks: [requireRanges('drives', drives)],
      isLive: () => speed.isMoving,
      start(wake, signal) {
        const follow = () => {
          const before = top;
          top = page().scrollTop;
          if (wake()) speed.add(Math.abs(top - before));
        };
        // Also boxes around `along` scroll.
        addEventListener('scroll', follow, { signal, passive: true, capture: true });
        addEventListener('resize', follow, { signal });
      },
      measure: (seconds) => [by === 'speed' ? speed.over(seconds) : position()],
    },
    options,
  );
}

function scrolled({ scrollTop, scrollHeight, clientHeight }: Element): number {
  return scrollTop / (scrollHeight - clientHeight);
}

function shareOf(element: Element): number {
  const { top, height } = element.getBoundingClientRect();
  return (innerHeight - top) / (innerHeight + height);
}
