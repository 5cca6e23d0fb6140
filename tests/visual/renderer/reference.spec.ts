import { longIf, test } from '../../support/fixtures.ts';
import { buildReference, expectReference } from '../../support/reference.ts';

type Cases = typeof import('./reference.cases.ts');
type SceneName = Parameters<Cases['drawn']>[0];
type Mode = Parameters<Cases['drawn']>[1][number];
const CASES = '/tests/visual/renderer/reference.cases.ts';

const STOPS = [
  { from: 0, color: [52, 56, 104] },
  { from: 0.12, color: [140, 96, 150] },
  { from: 0.55, color: [250, 214, 170] },
] as const;
const FIRE = [
  { from: 0, color: [70, 66, 80] },
  { from: 0.4, color: [226, 88, 44] },
  { from: 0.8, color: [255, 226, 150] },
] as const;

const BILLBOARDS = { form: 'billboards' } as const;

/** A few modes of each scene; reference.long.spec.ts covers every mode, also those without combined settings. */
const CLUSTERS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['perspective', [{ tones: 3, inkSwell: 0.7 }]],
  ['offAxis', [{ outlines: false }]],
  ['orthographic', [{ shading: false }]],
  ['eyeInside', [{}]],
];
const LIGHTS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['touching', [{ shadowSteps: 2, shadowDepth: 3, outlineWidth: 3 }]],
  ['underParts', [{ shadowSteps: 2, shadowDepth: 2 }]],
  ['byLamp', [{ tones: 1, outlineWidth: 5, innerLine: 0.15, innerTaper: 2, boil: 0.8 }]],
  ['byLampAmongPuffs', [{ tones: 3 }]],
  ['backlit', [{ gradient: 'height' }, { gradient: 'screen' }]],
];
const MANY: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['lampAmongPuffs', [{}, BILLBOARDS]],
  ['besideEye', [{}]],
  ['coincident', [{}, BILLBOARDS]],
];
const ON_BOARDS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['perspective', [BILLBOARDS]],
  ['orthographic', [BILLBOARDS]],
  ['eyeInside', [BILLBOARDS]],
  ['byLampAmongPuffs', [BILLBOARDS]],
];
const MORE_BOARDS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['perspective', [{ ...BILLBOARDS, tones: 1 }]],
  ['offAxis', [BILLBOARDS]],
  ['backlit', [BILLBOARDS]],
  ['byLamp', [BILLBOARDS]],
];
const MESHES: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['meshesByLamp', [BILLBOARDS, { ...BILLBOARDS, volumes: 'counted' }]],
  ['meshes', [BILLBOARDS, { ...BILLBOARDS, tones: 3, gradient: 'height', shadowSteps: 2, shadowDepth: 3 }]],
];
const DRAWINGS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['drawings', [BILLBOARDS, { ...BILLBOARDS, tones: 3, rim: 0.3, shadowSteps: 2, shadowDepth: 3 }]],
  ['drawingsByLamp', [BILLBOARDS]],
];
const SHEET: readonly (readonly [SceneName, readonly Mode[]])[] = [['sheet', [BILLBOARDS]]];
/** Painted colours change within a region, so that the rounding of the GPU's filter shows at their borders. */
const PAINTED = { maxWithin: 0.0025, maxOfEdges: 0.015 };
/** Measured: 0.02 % at tones of drawn parts, which meet at sharp borders. */
const DRAWN = { maxWithin: 0.0004 };
/** Measured: 0.02 % for dots, which are hidden if their centre is. */
const PRINTED = { maxWithin: 0.0004 };
const COUNTED: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['eyeInside', [{ ...BILLBOARDS, volumes: 'counted' }]],
  ['underParts', [{ volumes: 'counted', shadowSteps: 2, shadowDepth: 2 }]],
  ['byLampAmongPuffs', [{ volumes: 'counted' }]],
];
const MORE_COUNTED: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['offAxis', [{ volumes: 'counted' }]],
  ['eyeInside', [{ volumes: 'counted' }]],
  ['coincident', [{ volumes: 'counted' }]],
];
const LOOKS: readonly (readonly [SceneName, readonly Mode[]])[] = [['looks', [{}, BILLBOARDS, { plumeForm: 0.6 }]]];
const STRETCHED = { isDeformed: true, stretch: 3 };
const UNFOLDING = { ...STRETCHED, billow: 1 };
const DEFORMED: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['deformed', [STRETCHED, UNFOLDING, { ...UNFOLDING, volumes: 'counted' }, { ...STRETCHED, tones: 3 }]],
  ['deformedByLamp', [UNFOLDING]],
  ['eyeInsideDeformed', [STRETCHED]],
];
const ERODED = { isEroded: true };
const DISSOLVING: readonly (readonly [SceneName, readonly Mode[]])[] = [
  [
    'eroded',
    [
      { ...ERODED, tones: 3, inkSwell: 0.7, boil: 0.5 },
      { ...ERODED, volumes: 'counted' },
    ],
  ],
  ['erodedByLamp', [{ ...ERODED, outlineWidth: 4 }]],
  [
    'erodedAndDeformed',
    [
      { ...ERODED, ...STRETCHED },
      { ...ERODED, ...UNFOLDING, tones: 3 },
      { ...ERODED, ...STRETCHED, isTorn: true },
    ],
  ],
];
const REVERSED: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['perspective', [{}]],
  ['offAxis', [BILLBOARDS]],
  ['orthographic', [{}, BILLBOARDS]],
  ['touching', [{}]],
  ['eyeInside', [{}]],
];
const TONES: readonly (readonly [SceneName, readonly Mode[]])[] = [
  [
    'perspective',
    [
      { fill: 0.4, rim: 0.5 },
      { stops: STOPS },
      { stops: STOPS, isBlended: true, fill: 0.5 },
      { ageColors: FIRE, heatColors: STOPS },
    ],
  ],
  ['backlit', [{ stops: STOPS, fill: 0.4, rim: 0.3 }]],
];
/** A red sun and a blue sky, which ink and the rim follow. */
const DUSK = { illumination: { direct: [0.9, 0.35, 0.2], ambient: [0.25, 0.3, 0.6] }, inkLight: 0.8 } as const;
/** Smoke that glows the more the hotter it is. */
const FIERY = {
  glow: [
    { at: 0.2, value: 0 },
    { at: 0.9, value: 1 },
  ],
} as const;
/** A lamp whose light weakens with distance. */
const FADING = { lampLight: [3, 1.8, 0.9] } as const;
const OTHER_LIGHT: readonly (readonly [SceneName, readonly Mode[]])[] = [
  [
    'perspective',
    [
      { ...DUSK, tones: 3, fill: 0.4, rim: 0.5 },
      { ...DUSK, stops: STOPS, isBlended: true, fill: 0.5 },
      { ...DUSK, ageColors: FIRE, heatColors: STOPS, gradient: 'height' },
      { ...DUSK, plumeForm: 0.6, shadowSteps: 2, shadowDepth: 3 },
      { ...DUSK, ...FIERY, heatColors: STOPS, tones: 3, fill: 0.4, rim: 0.5 },
      { ...DUSK, ...FIERY, ageColors: FIRE },
      { ...DUSK, ...FIERY, plumeForm: 0.6 },
    ],
  ],
  [
    'byLamp',
    [
      { ...DUSK, ...BILLBOARDS, stops: STOPS },
      { ...DUSK, ...FADING, tones: 3, fill: 0.4, rim: 0.5 },
      { ...DUSK, ...FADING, ...BILLBOARDS, stops: STOPS },
      { ...DUSK, ...FADING, ageColors: FIRE, heatColors: STOPS, plumeForm: 0.6 },
      { ...DUSK, ...FADING, ...FIERY, heatColors: STOPS, tones: 3, fill: 0.4, rim: 0.5 },
      { ...DUSK, ...FADING, ...FIERY, ...BILLBOARDS, stops: STOPS, isBlended: true, fill: 0.5 },
    ],
  ],
  ['erodedByLamp', [{ ...ERODED, ...FADING, ...STRETCHED }]],
];
const MARKS = { patternCoverage: 0.4, patternBackdrop: 0.3, patternSize: 7, patternOn: 'both' } as const;
const PRINTS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  [
    'perspective',
    [
      { ...MARKS, pattern: 'dots' },
      { ...MARKS, pattern: 'lines', patternAngle: 20, tones: 3 },
      { ...MARKS, pattern: 'crosshatch', patternOn: 'shadow' },
      { ...MARKS, pattern: 'grain', patternSoftness: 1 },
      { ...MARKS, ...BILLBOARDS, pattern: 'dots', patternShiftX: 3, patternShiftY: -2 },
      { ...MARKS, ...BILLBOARDS, pattern: 'lines' },
    ],
  ],
  ['orthographic', [{ ...MARKS, pattern: 'dots', patternOn: 'tones', patternAngle: 0 }]],
  ['deformed', [{ ...MARKS, ...STRETCHED, pattern: 'lines' }]],
  ['byLamp', [{ ...MARKS, pattern: 'crosshatch' }]],
];
/** Limits other than the usual ones. */
const LIMITS = new Map<typeof MESHES, { maxWithin?: number; maxOfEdges?: number }>([
  [MESHES, PAINTED],
  [SHEET, PAINTED],
  [DRAWINGS, DRAWN],
  [PRINTS, PRINTED],
]);
/** Light by the form of the whole smoke. */
const FORMS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['perspective', [{ plumeForm: 0.6 }, { plumeForm: 1, tones: 3 }]],
  ['byLamp', [{ plumeForm: 0.6, fill: 0.4, rim: 0.3 }]],
];
const LAMPS: readonly (readonly [SceneName, readonly Mode[]])[] = [
  ['lampRising', [{}, { gradient: 'age', tones: 3 }]],
  ['lampFull', [{}, { gradient: 'puff' }, { shadowSteps: 2, shadowDepth: 3 }]],
  ['eyeInPlume', [{}]],
];

test.beforeAll(buildReference);

for (const [what, scenes, reversedDepth] of [
  ['puffs among solids', CLUSTERS, false],
  ['puffs that touch solids, by a lamp, against the light', LIGHTS, false],
  ['puffs that turn, stretch and unfold', DEFORMED, false],
  ['puffs that are eroded, also while they turn and stretch', DISSOLVING, false],
  ['billboards', ON_BOARDS, false],
  ['billboards of meshes with colours', MESHES, false],
  ['billboards of drawings', DRAWINGS, false],
  ['billboards of a puff sheet', SHEET, false],
  ['billboards from other sides', MORE_BOARDS, false],
  ['a lamp among puffs, puffs beside the eye, more than a stencil counts', MANY, false],
  ['volumes counted by entry and exit', COUNTED, false],
  ['more volumes counted by entry and exit', MORE_COUNTED, false],
  ['puffs among solids under a reversed depth buffer', REVERSED, true],
  ['puffs in tones of all kinds', TONES, false],
  ['puffs with three looks', LOOKS, false],
  ['puffs and solids in light of other colours', OTHER_LIGHT, false],
  ['puffs with the light of their whole form', FORMS, false],
  ['puffs with the marks of a print', PRINTS, false],
  ['the lamp', LAMPS, false],
] as const) {
  const isOften = new Set([CLUSTERS, TONES, SHEET]).has(scenes);
  const tag = longIf(reversedDepth || !isOften);
  test(`${what}: the picture equals the reference${tag}`, async ({ load }, testInfo) => {
    const cases = await load<Cases>(CASES);
    for (const [scene, modes] of scenes) {
      const input = [scene, modes, reversedDepth] as const;
      const pictures = await cases.evaluate((module, given) => module.drawn(...given), input);
      for (const [index, picture] of pictures.entries()) {
        await expectReference(`${scene} ${JSON.stringify(modes[index])}`, picture, testInfo, LIMITS.get(scenes));
      }
    }
  });
}
