/**
 * Lazy modules of the element. None is fetched before the element comes near the viewport, and each only when an
 * attribute requires it.
 */
import { fetched } from '../preset/timeout.ts';
import { fetchPreset, FIRST_PRESET } from '../preset/byScene/fetchPreset.ts';
import type { Preset } from '../preset/byScene/preset.ts';
import { ignoreRejection } from './ignoreRejection.ts';

const parts = {
  /** Always. */
  session: () => import('./session.ts'),
  /** With `src` or `start`. */
  link: () => import('./attributes/link.ts'),
  /** With a link to a moment of a take. */
  moment: () => import('./moment.ts'),
  /** With `interactive`. */
  pointers: () => import('./pointers.ts'),
  /** With `collide` or `emit-from`. */
  onPage: () => import('./layout/onPage.ts'),
};

type Name = keyof typeof parts;
type LazyModule<Each extends Name> = Awaited<ReturnType<(typeof parts)[Each]>>;

const called: Partial<Record<Name, string>> = {
  pointers: 'What turns the view',
  onPage: 'The page in the smoke',
};

/**
 * Fetches a module, or returns the loaded one.
 * @throws LoadError when it cannot be fetched
 */
export function part<Each extends Name>(name: Each): Promise<LazyModule<Each>> {
  return fetched(called[name] ?? 'The smoke', parts[name]() as Promise<LazyModule<Each>>);
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
