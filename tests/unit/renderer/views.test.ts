import { PerspectiveCamera, Vector3, Vector4 } from 'three';
import { expect, test } from 'vitest';
import { FrameView } from '../../../src/renderer/gpu/frameView.ts';
import { defaults } from '../../../src/parameters/values.ts';
import type { FrameInput } from '../../../src/renderer/frameInput.ts';
import { styleOf, styleUniforms } from '../../../src/renderer/style.ts';
import { eyeView, type ViewSources } from '../../../src/renderer/views.ts';

test('hidden puffs are culled among more than 100 particles, and if their number is unknown', () => {
  const eye = new FrameView(styleUniforms());
  eye.look(new PerspectiveCamera(), new Vector4(0, 1, 0, 0), 64, 48);
  const extents = { reach: 1, depth: 1, capRange: [0, 1], solids: {} } as unknown as ViewSources['extents'];
  const sources: ViewSources = { eye, extents, boxes: [], minCap: 0, isFlat: false };
  const isCulled = (alive: number | undefined): boolean => {
    const input = { simulator: { alive }, style: styleOf(defaults()), pixelRatio: 1, cull: true, blend: 1 };
    return eyeView(sources, input as unknown as FrameInput).coverage !== undefined;
  };
  expect([0, 100, 101, undefined].map(isCulled)).toEqual([false, false, true, true]);
});

test('the light has a direction at the place of a lamp, too', () => {
  const eye = new FrameView(styleUniforms());
  eye.look(new PerspectiveCamera(), new Vector4(0, 2, 0, 1), 64, 48);
  expect(eye.travelAt(new Vector3(0, 2, 3)).z).toBe(1);
  expect(eye.travelAt(new Vector3(0, 2, 0)).length()).toBe(1);
});
