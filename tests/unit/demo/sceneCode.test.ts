/** The code of the share sheet for three.js, of a stage without a picture. */
import { expect, test } from 'vitest';
import { ridingKeys, sceneOf } from '../../../src/demo/share/sceneCode.ts';
import type { Stage } from '../../../src/index.ts';
import { presets, presetValues, type Values } from '../../../src/preset.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';

const CAMERA = { 'camera.distance': 5 };
const SIGHT = {
  plane: { right: [0.01, 0, 0], up: [0, 0.01, 0] },
  centre: [0, 1, 0],
  change: ([x, y, z]: number[]) => [x, y + 2, z],
};

/** What the code reads of a stage that shows a preset. */
async function stageOf(name: string, changed: Values = {}): Promise<Stage> {
  const values = { ...presetValues(presets.find((preset) => preset.name === name)!), ...changed };
  const { rig } = await sceneEntries[String(values.scene)].load();
  const stage = { rig: { ...rig, ...CAMERA }, get: () => values, sight: SIGHT, canvas: { clientHeight: 360 } };
  return stage as unknown as Stage;
}

test('has no emitters and forces on objects of the scene, and names those that it changes', async () => {
  const stage = await stageOf('rocket');
  expect(ridingKeys(stage)).toEqual(['emitters.0.rigid']);
  const { values } = sceneOf(stage);
  const keys = Object.keys(values);
  expect(values['emitters.0.position.y']).toBe((stage.rig['emitters.0.position.y'] as number) + 2);
  expect(keys).toContain('emitters.0.speed');
  expect(keys.filter((key) => key.endsWith('.rigid'))).toEqual([]);
  expect(ridingKeys(await stageOf('wisp'))).toEqual([]);
});

test('leaves out what the scene of three.js has of its own, and emitters that emit nothing', async () => {
  const changed = { 'emitters.5.share': 0, 'emitters.5.speed': 3, 'emitters.6.share': 0.5, 'emitters.6.speed': 3 };
  const { values, eye, centre, fieldOfView } = sceneOf(await stageOf('wisp', changed));
  expect(Object.keys(values).filter((key) => /^(scene$|light|camera)/.test(key))).toEqual([]);
  expect(Object.keys(values).filter((key) => /^emitters.[56]/.test(key))).toEqual([
    'emitters.6.share',
    'emitters.6.speed',
  ]);
  expect(eye).toEqual([0, 1, 5]);
  expect(centre).toEqual([0, 1, 0]);
  // Half the picture is 1.8 m high, 5 m away.
  expect(fieldOfView).toBeCloseTo(39.6, 1);
});

test('has the lanes of a timeline that are of the smoke, and the emitters that only a timeline or a movement lets emit', async () => {
  const silent = Object.fromEntries([4, 5, 6, 7].map((index) => [`emitters.${index}.share`, 0])) as Values;
  const timeline = '90*loop;emitters.4.speed/0*1/60*2;camera.azimuth/0*0/60*90;light.azimuth/0*5;burst/30*5*12';
  const { values } = sceneOf(await stageOf('wisp', { ...silent, 'emitters.6.perMetre': 3, timeline }));
  expect(values.timeline).toBe('90*loop;emitters.4.speed/0*1/60*2;burst/30*5*12');
  expect(Object.keys(values).filter((key) => /^emitters\.[4-7]\.share/.test(key))).toEqual(
    [4, 5, 6].map((index) => `emitters.${index}.share`),
  );
  const { values: others } = sceneOf(await stageOf('wisp', { timeline: '60;camera.azimuth/0*0/60*90' }));
  expect(others).not.toHaveProperty('timeline');
});
