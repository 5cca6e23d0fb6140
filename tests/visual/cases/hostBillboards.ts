/** Smoke in the host's scene that is asked for billboards, whose code is not here yet. */
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { Values } from '../../../src/preset/parameter.ts';
import { changedPixels, dispose, draw, emptyHost, HANGING, smokeIn, type Host, type Pixels } from './hostScene.ts';

export const BILLBOARDS: Values = { 'puff.form': 'billboards' };

export interface Asked {
  readonly host: Host;
  readonly smoke: CartoonSmoke;
  /** The picture before anybody asked. */
  readonly before: Pixels;
  /** What was told since. */
  readonly notified: string[];
}

/** Smoke as lobes, which is then asked for billboards. */
export async function ask(): Promise<Asked> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const before = draw(host);
  const notified: string[] = [];
  smoke.addEventListener('error', ({ error }) => notified.push(`${error.name}: ${error.message}`));
  smoke.set(BILLBOARDS);
  return { host, smoke, before, notified };
}

/** Some frames of the host in which a knob is turned: pixels by which the last one differs from what was before. */
export function frames({ host, smoke, before }: Asked): number {
  const { 'style.outlineWidth': width } = smoke.get();
  for (const changed of [1, 2, 3, Number(width)]) {
    smoke.set({ 'style.outlineWidth': changed });
    smoke.update(0);
    host.renderer.render(host.scene, host.camera);
  }
  return changedPixels(before, draw(host));
}

/** Pixels by which the picture differs from that of smoke that had billboards from its start. */
export async function fromStart({ host }: Asked): Promise<number> {
  const other = emptyHost();
  await smokeIn(other, { ...HANGING, ...BILLBOARDS });
  const changed = changedPixels(draw(other), draw(host));
  dispose(other.renderer);
  return changed;
}

/** How smoke fails to come that has billboards from its start. */
export function beginWith(): Promise<string> {
  const host = emptyHost();
  return smokeIn(host, { ...HANGING, ...BILLBOARDS }).then(
    () => 'nothing',
    (error: Error) => error.name,
  );
}
