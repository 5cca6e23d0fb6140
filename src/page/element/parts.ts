/**
 * Lazy modules of the element. None is fetched before the element comes near the viewport, and each only when an
 * attribute requires it.
 */
import { LazyModules } from '../../base/timeout.ts';
import { fetchPreset, FIRST_PRESET } from '../../parameters/byScene/fetchPreset.ts';
import type { Preset } from '../../parameters/parameter.ts';
import { ignoreRejection } from './deferred.ts';

const modules = new LazyModules({
  /** With `src` or `start`. */
  link: () => import('./attributes/link.ts'),
  /** With a link to a moment of a take. */
  moment: () => import('./moment.ts'),
  /** With `timeline`. */
  timeline: () => import('../../parameters/timeline.ts'),
  /** With `interactive`. */
  pointers: () => import('./pointers.ts'),
  /** With `collide` or `emit-from`. */
  onPage: () => import('./layout/onPage.ts'),
});

type Name = keyof typeof modules.loaded;

const called: Partial<Record<Name, string>> = {
  pointers: 'Camera controls',
  onPage: 'Collisions with the page',
};

/**
 * Loads a module, or returns the loaded one.
 * @throws LoadError if it cannot be loaded
 */
export function part<Each extends Name>(name: Each) {
  return modules.load(name, called[name] ?? 'The smoke');
}

/**
 * Fetches the preset that an element names. The name of a scene selects the scene's first preset.
 * @throws LoadError when it cannot be fetched
 */
export function presetOf(element: Element): Promise<Preset | undefined> {
  return fetchPreset(element.getAttribute('preset') ?? element.getAttribute('scene') ?? FIRST_PRESET);
}

/** Prefetches what the session needs first. Errors are reported where the result is used. */
export function fetchAhead(element: Element): void {
  const asks = (...names: string[]) => names.some((name) => element.hasAttribute(name));
  if (!asks('src')) ignoreRejection(presetOf(element));
  if (asks('src', 'start')) ignoreRejection(part('link'));
}
