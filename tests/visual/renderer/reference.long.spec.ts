import { presets } from '../../../src/parameters/presets.ts';
import { sceneEntries } from '../../../src/scenes/scenes.ts';
import { expect, test } from '../../support/fixtures.ts';
import { buildReference, expectReference } from '../../support/reference.ts';

type Cases = typeof import('./reference.cases.ts');
type SceneName = Parameters<Cases['drawn']>[0];
type Mode = Parameters<Cases['drawn']>[1][number];
const CASES = '/tests/visual/renderer/reference.cases.ts';

const SCENES: readonly SceneName[] = [
  'perspective',
  'offAxis',
  'orthographic',
  'eyeInside',
  'backlit',
  'touching',
  'byLamp',
  'byLampAmongPuffs',
  'lampAmongPuffs',
  'lampRising',
  'lampFull',
  'eyeInPlume',
];

/** Each of the paper's four effects on and off, with each number of tones and each gradient type. */
function everyMode(): Mode[] {
  const modes: Mode[] = [];
  for (const tones of [1, 2, 3] as const)
    for (const gradient of ['none', 'puff', 'height', 'screen', 'age'] as const)
      for (const shading of [true, false])
        for (const shadows of [true, false])
          for (const outlines of [true, false]) modes.push({ tones, gradient, shading, shadows, outlines });
  return modes;
}

/** Simulated seconds after which a scene has enough smoke. */
const SECONDS = 4;
/**
 * Later, the campfire has mainly edges of small puffs, and dust has settled. At 4 s the sun grazes the cab of this train (N . L = 0.004): the start of
 * its shadow is within the rounding of depth behind its lit side, and the count there is undecided, but not the colour.
 * At 4 s the puffs of this firework are small and their lines thin and translucent: whether a line lies in the shadow of
 * its own puff is within the rounding of depth, and 2.4 % of the edge pixels differ.
 */
const OTHER_SECONDS: Readonly<Record<string, number>> = { campfire: 3, dust: 2, firework: 1.5, 'train-rubber-hose': 5 };
/** Smallest number of particles in a picture. */
const FEWEST = 40;
/** Looks of few large puffs. */
const FEWEST_OF: Readonly<Record<string, number>> = { 'wisp-hearts': 10, 'air-pow': 20 };
/**
 * SwiftShader clips triangles at the border of the picture, where their shared edges then separate. Pixels of the
 * meadow show through these cracks in shadow volumes that cross the lower border: 13 to 17 of 76,800. A dot is drawn
 * whole or not at all by the shadow at its centre, so that one whose centre is within rounding of a border differs as a
 * whole: another 15 pixels of seven dots, and 4 of a dot on a crack.
 */
const MAX_WITHIN: Readonly<Record<string, number>> = {
  cloudscape: 0.0003,
  'cloudscape-gouache': 0.0003,
  'cloudscape-night': 0.0003,
  'cloudscape-woodcut': 0.0003,
  'cloudscape-riso': 0.0005,
};
/**
 * The word is of 2,600 puffs, each a few pixels wide, so the snapped corners of their boards move a larger share of their
 * edges: 1.1 to 1.2 % of single, scattered pixels from 1 to 6 s.
 */
const MAX_OF_EDGES: Readonly<Record<string, number>> = { teapot: 0.0125 };
/** Pictures per transfer: a description with all triangles has about one megabyte. */
const BATCH = 12;

test.beforeAll(buildReference);

for (const scene of SCENES) {
  test(`${scene} equals the reference in every mode`, async ({ load }, testInfo) => {
    const cases = await load<Cases>(CASES);
    const modes = everyMode();
    for (let first = 0; first < modes.length; first += BATCH) {
      const batch = modes.slice(first, first + BATCH);
      const pictures = await cases.evaluate((module, input) => module.drawn(...input), [scene, batch] as const);
      for (const [index, picture] of pictures.entries()) {
        await expectReference(`${scene} ${JSON.stringify(batch[index])}`, picture, testInfo);
      }
    }
  });
}

for (const [form, names] of [
  ['lobes', presets.map(({ name }) => name)],
  // The first preset of each scene.
  ['billboards', Object.keys(sceneEntries)],
] as const) {
  for (const name of names) {
    test(`the preset ${name} of ${form} equals the reference`, async ({ load }, testInfo) => {
      const cases = await load<Cases>(CASES);
      const input = [name, form, OTHER_SECONDS[name] ?? SECONDS] as const;
      const picture = await cases.evaluate((module, given) => module.drawnPreset(...given), input);
      expect(picture.bodies).toBeGreaterThan(FEWEST_OF[name] ?? FEWEST);
      await expectReference(`${name} of ${form}`, picture, testInfo, {
        maxWithin: MAX_WITHIN[name],
        maxOfEdges: MAX_OF_EDGES[name],
      });
    });
  }
}
