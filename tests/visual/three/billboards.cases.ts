/** Smoke in the host's scene that changes to billboards before their code is loaded. */
import { drawPuff } from '../../../src/renderer/puffs/drawing/drawPuff.ts';
import type { Line } from '../../../src/renderer/puffs/drawing/drawing.ts';
import type { PuffShape } from '../../../src/renderer/puffs/shapes.ts';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { changedPixels, dispose, draw, emptyHost, HANGING, smokeIn, type Host, type Pixels } from './scene.ts';

export const BILLBOARDS: Values = { 'puff.form': 'billboards' };

export interface Asked {
  readonly host: Host;
  readonly smoke: CartoonSmoke;
  /** The picture before the change. */
  readonly before: Pixels;
  /** Notices since then. */
  readonly notified: string[];
}

/** Smoke with lobes that changes to billboards. */
export async function ask(): Promise<Asked> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const before = draw(host);
  const notified: string[] = [];
  smoke.addEventListener('error', ({ error }) => notified.push(`${error.name}: ${error.message}`));
  smoke.set(BILLBOARDS);
  return { host, smoke, before, notified };
}

/**
 * Draws some frames of the host while a value changes.
 * @returns pixels that differ between the last frame and the picture before
 */
export function frames({ host, smoke, before }: Asked): number {
  const { 'style.outlineWidth': width } = smoke.get();
  for (const changed of [1, 2, 3, Number(width)]) {
    smoke.set({ 'style.outlineWidth': changed });
    smoke.update(0);
    host.renderer.render(host.scene, host.camera);
  }
  return changedPixels(before, draw(host));
}

/** Pixels that differ from the picture of smoke that has billboards from the start. */
export async function fromStart({ host }: Asked): Promise<number> {
  const other = emptyHost();
  await smokeIn(other, { ...HANGING, ...BILLBOARDS });
  const changed = changedPixels(draw(other), draw(host));
  dispose(other.renderer);
  return changed;
}

const square = (half: number): Line =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => [128 + half * x, 128 + half * y]); // prettier-ignore

/** Pixels that differ from the picture of `puff.drawing`, and errors, after calls of `setPuffs`. */
export async function setPuffs() {
  const host = emptyHost();
  const smoke = await smokeIn(host, { ...HANGING, ...BILLBOARDS });
  const lobes = draw(host);
  const frame = drawPuff({ areas: [{ color: '#ff8800', outlines: [square(90), square(40)] }], folds: [] });
  smoke.set({ 'puff.drawing': frame.drawing });
  smoke.step(0);
  const drawn = draw(host);
  smoke.set({ 'puff.drawing': '' });
  const differing = (shapes?: readonly PuffShape[]): number => {
    smoke.setPuffs(shapes);
    smoke.step(0);
    return changedPixels(drawn, draw(host));
  };
  const found = {
    byLobes: changedPixels(drawn, lobes),
    own: differing([frame]),
    error: await Promise.resolve()
      .then(() => differing([]))
      .then(String, String),
    afterError: changedPixels(drawn, draw(host)),
    restored: changedPixels(lobes, (differing(), draw(host))),
  };
  dispose(host.renderer);
  return found;
}

/** The error of smoke that has billboards from the start. */
export function beginWith(): Promise<string> {
  const host = emptyHost();
  return smokeIn(host, { ...HANGING, ...BILLBOARDS }).then(
    () => 'nothing',
    (error: Error) => error.name,
  );
}
