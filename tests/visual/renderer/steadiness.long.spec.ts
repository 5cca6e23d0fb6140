import { findPreset } from '../../../src/parameters/presets.ts';
import { readTimeline } from '../../../src/parameters/timeline.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./steadiness.cases.ts');
const CASES = '/tests/visual/renderer/steadiness.cases.ts';

/**
 * Pixels of an area that may appear or vanish at once: slivers of light, shadow and ink from behind a lobe do. A puff
 * of the lamp covers about 300.
 */
const SLIVER = 12;
/** The line and the shadow below a letter appear in the step in which it leaves the stage: 19 pixels. */
const SLIVER_OF: Readonly<Record<string, number>> = { title: 20 };

/** Steps after which a scene has smoke. The dust of the mole settles between its holes. */
const STEPS: Readonly<Record<string, number>> = { dust: 120 };

/** Steps in which the smoke of a burst, or of an emitter that starts, grows or ends at once. */
const GROWTH = 6;

/** The steps after bursts and keyframes of emitters. @param last latest step */
function suddenSteps(scene: string, last: number): number[] {
  const { length, lanes, bursts } = readTimeline(findPreset(scene)!.values.timeline ?? '').timeline;
  const ofEmitters = lanes.filter(({ key }) => key.startsWith('emitters.'));
  const starts = [...bursts, ...ofEmitters.flatMap(({ keyframes }) => keyframes)].map(({ step }) => step);
  const steps = starts.flatMap((start) => Array.from({ length: GROWTH }, (_, after) => start + 1 + after));
  const isLooped = (step: number) => steps.some((sudden) => sudden % length === step % length);
  return Array.from({ length: last + 1 }, (_, step) => step).filter(isLooped);
}

for (const scene of Object.keys(sceneEntries)) {
  test(`no puff pops in the scene ${scene} during ten seconds`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const input = [scene, suddenSteps(scene, 630)] as const;
    const report = await cases.evaluate((module, [name, sudden]) => module.timePassing(name, 30, 600, sudden), input);
    console.log(`${scene}, ten seconds:`, report);
    expect(report.bodies).toBeGreaterThan(20);
    expect(report.smoke).toBeGreaterThan(200);
    expect(report.largest).toBeLessThanOrEqual(SLIVER_OF[scene] ?? SLIVER);
    expect(report.sudden).toBeLessThan(0.3 * report.pictures);
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
