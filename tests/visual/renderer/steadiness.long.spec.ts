import { sceneEntries } from '../../../src/scenes/scenes.ts';
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./steadiness.cases.ts');
const CASES = '/tests/visual/renderer/steadiness.cases.ts';

/**
 * Pixels of an area that may appear or vanish at once: slivers of light, shadow and ink from behind a lobe do. A puff
 * of the lamp covers about 300.
 */
const SLIVER = 12;

/** Steps after which a scene has smoke. The dust of the mole settles between its holes. */
const STEPS: Readonly<Record<string, number>> = { dust: 120 };

for (const scene of Object.keys(sceneEntries)) {
  test(`no puff pops in the scene ${scene} during ten seconds`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, name) => module.timePassing(name, 30, 600), scene);
    console.log(`${scene}, ten seconds:`, report);
    expect(report.bodies).toBeGreaterThan(20);
    expect(report.smoke).toBeGreaterThan(200);
    expect(report.largest).toBeLessThanOrEqual(SLIVER);
  });

  test(`the picture of the scene ${scene} is continuous while the camera orbits once`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const input = [scene, STEPS[scene] ?? 240] as const;
    const report = await cases.evaluate((module, [name, steps]) => module.orbiting(name, steps, 360), input);
    console.log(`${scene}, 360 degrees:`, report);
    expect(report.bodies).toBeGreaterThan(20);
    expect(report.smoke).toBeGreaterThan(200);
    expect(report.largest).toBeLessThanOrEqual(SLIVER);
  });
}
