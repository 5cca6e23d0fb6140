/**
 * The one table of parameters. The order of the rows is the order of keys in a link and of controls in the panel, so
 * new rows may go anywhere but a key is never renamed: links that people keep would lose it.
 *
 * The defaults are the lamp's (see presets.ts). Multipliers are relative to what the scene has: 1 changes nothing.
 */
import type {
  ChoiceParameter,
  ColorParameter,
  NumberParameter,
  Parameter,
  RampParameter,
  Reader,
  ToggleParameter,
} from './parameter.ts';
import { itemLabel, LIST_LIMIT, listNames, listParameters } from './lists.ts';

/** The groups of the panel in their order; `advanced` ones start folded. */
export const groups: readonly { readonly key: string; readonly label: string; readonly advanced: boolean }[] = [
  { key: 'emission', label: 'Smoke', advanced: false },
  { key: 'style', label: 'Ink and colour', advanced: false },
  { key: 'light', label: 'Light', advanced: false },
  { key: 'camera', label: 'Camera', advanced: true },
  { key: 'puff', label: 'Shape of the puffs', advanced: true },
  { key: 'forces', label: 'Forces', advanced: false },
  { key: 'turbulence', label: 'Turbulence', advanced: true },
  { key: 'air', label: 'Air and weight', advanced: true },
  { key: 'simulation', label: 'Simulation', advanced: true },
];

/** A group of the panel for each item that a list can have; it comes up when the item is added. */
export const itemGroups: readonly { readonly key: string; readonly list: string; readonly label: string }[] =
  listNames.flatMap((list) =>
    Array.from({ length: LIST_LIMIT }, (_, index) => ({
      key: `${list}.${index}`,
      list,
      label: itemLabel(list, index),
    })),
  );

type Named = Pick<Parameter, 'label' | 'text'>;
type Quantity = Named & Partial<NumberParameter> & Pick<NumberParameter, 'min' | 'max' | 'step' | 'default'>;

function quantity(key: string, group: string, reader: Reader, rest: Quantity): NumberParameter {
  return { kind: 'number', unit: '', slider: 'even', ...rest, key, group, reader };
}

function multiplier(name: string, label: string, text: string): NumberParameter {
  const range = { min: 0, max: 10, step: 0.05, default: 1, unit: '\u00d7' } as const;
  return quantity(`forces.${name}`, 'forces', 'simulator', { label, text, ...range, slider: 'fine' });
}

function wind(axis: 'x' | 'y' | 'z', label: string, text: string): NumberParameter {
  const range = { min: -50, max: 50, step: 0.05, default: 0, unit: 'm/s' } as const;
  return quantity(`forces.wind.${axis}`, 'forces', 'simulator', { label, text, ...range, slider: 'fine' });
}

/** What shapes the lobes of puffs. */
function knob(name: string, initial: number, label: string, text: string): NumberParameter {
  const range = { min: 0, max: 1, step: 0.01, default: initial } as const;
  return quantity(`puff.${name}`, 'puff', 'style', { label, text, ...range });
}

/** What a scene sets and anybody may change. */
function ofScene(
  key: string,
  group: string,
  rest: Named & Partial<NumberParameter> & { max: number; default: number },
): NumberParameter {
  const range = { min: 0, step: 0.05, slider: 'fine' } as const;
  return { ...quantity(key, group, 'simulator', { ...range, ...rest }), isOptional: true };
}

/** Where the eye is; whatever has no value follows the scene's own eye and its move. */
function eye(name: string, rest: Quantity): NumberParameter {
  return { ...quantity(`camera.${name}`, 'camera', 'camera', rest), isOptional: true };
}

function eyeTarget(axis: 'x' | 'y' | 'z', initial: number): NumberParameter {
  const range = { min: -50, max: 50, step: 0.05, unit: 'm', slider: 'fine' } as const;
  const text = { x: "right of the scene's middle", y: 'above the ground', z: "in front of the scene's middle" }[axis];
  const label = `Looks at ${axis}`;
  return eye(`target.${axis}`, {
    ...range,
    label,
    text: `How far ${text} the point lies that the camera looks at and circles.`,
    default: initial,
  });
}

function toggle(name: string, label: string, text: string, initial: 0 | 1 = 1): ToggleParameter {
  return { kind: 'toggle', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: initial };
}

function ramp(name: string, label: string, text: string): RampParameter {
  return { kind: 'ramp', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: '' };
}

function height(name: string, label: string, text: string, initial: number): NumberParameter {
  const range = { min: -100, max: 100, step: 0.05, unit: 'm', slider: 'fine' } as const;
  return quantity(`style.${name}`, 'style', 'style', { ...range, label, text, default: initial });
}

function color(name: string, label: string, text: string, initial: string): ColorParameter {
  return { kind: 'color', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: initial };
}

type Options = readonly (readonly [value: string | number, label: string])[];

type Choice = Named & Pick<ChoiceParameter, 'default'>;

function choice(key: string, group: string, reader: Reader, rest: Choice, options: Options): ChoiceParameter {
  const list = options.map(([value, label]) => ({ value, label }));
  return { kind: 'choice', key, group, reader, ...rest, options: list };
}

/** Every parameter that a person, a link or an attribute can reach. */
export const table: readonly Parameter[] = [
  choice('scene', 'simulation', 'stage', { label: 'Scene', text: 'What stands in the smoke.', default: 'lamp' }, [
    ['lamp', 'Magic lamp'],
    ['airplane', 'Airplane'],
    ['train', 'Steam train'],
    ['campfire', 'Campfire'],
    ['rocket', 'Rocket launch'],
    ['genie', 'Genie'],
    ['dust', 'Dust'],
    ['cloudscape', 'Cloudscape'],
    ['wisp', 'Cup of tea'],
    ['air', 'Open air'],
  ]),
  quantity('seed', 'simulation', 'stage', {
    kind: 'integer',
    min: 0,
    max: 4294967295,
    step: 1,
    default: 1,
    label: 'Seed',
    text: 'Starts the random numbers: the same seed makes the same smoke. Changing it starts anew.',
  }),
  quantity('emission.rate', 'emission', 'simulator', {
    min: 0,
    max: 20000,
    step: 5,
    default: 28,
    unit: 'particles/s',
    slider: 'fine',
    label: 'Rate',
    text: 'How many puffs are born each second.',
  }),
  quantity('emission.lifetime', 'emission', 'simulator', {
    min: 0.1,
    max: 60,
    step: 0.1,
    default: 7,
    unit: 's',
    slider: 'fine',
    label: 'Lifetime',
    text: 'How long a puff lives before it has dissolved.',
  }),
  quantity('emission.growthTime', 'emission', 'simulator', {
    min: 0,
    max: 30,
    step: 0.05,
    default: 2.6,
    unit: 's',
    slider: 'fine',
    label: 'Growth',
    text: 'How long a young puff takes to swell to full size; 0 is born full, as in the paper.',
  }),
  {
    kind: 'curve',
    key: 'emission.density',
    group: 'emission',
    reader: 'simulator',
    label: 'Density',
    text: 'How large a puff is over its life, from birth to death, where it always ends at nothing.',
    default: '0:1,1:0',
  },
  ofScene('emission.entrainment', 'emission', {
    max: 1,
    default: 0,
    slider: 'even',
    step: 0.01,
    label: 'Entrainment',
    text: 'How much puffs swell on their way through the air.',
  }),
  quantity('puff.size', 'emission', 'simulator', {
    min: 0.1,
    max: 4,
    step: 0.05,
    default: 1,
    unit: '\u00d7',
    slider: 'fine',
    label: 'Puff size',
    text: 'Makes every puff larger or smaller.',
  }),
  quantity('puff.variations', 'puff', 'simulator', {
    kind: 'integer',
    min: 1,
    max: 32,
    step: 1,
    default: 4,
    slider: 'fine',
    label: 'Puff shapes',
    text: 'How many different shapes are mixed; a puff keeps the one it was born with.',
  }),
  choice(
    'puff.form',
    'puff',
    'style',
    {
      label: 'Puffs',
      text: 'Lobes are true shapes from every side; billboards are pictures of puffs that turn to the viewer, as in the paper.',
      default: 'lobes',
    },
    [
      ['lobes', 'Lobes'],
      ['billboards', 'Billboards'],
    ],
  ),
  knob('lumpiness', 0.8, 'Lumpiness', 'How far lobes stand out of a puff: 0 is nearly a ball, 1 a bunch.'),
  knob('flatness', 0.2, 'Flatness', 'How much puffs are pressed flat.'),
  knob('roughness', 0.6, 'Roughness', 'How unequal and how unevenly spread the lobes of a puff are.'),
  quantity('puff.lobes', 'puff', 'style', {
    kind: 'integer',
    min: 5,
    max: 12,
    step: 1,
    default: 10,
    label: 'Lobes',
    text: 'How many lobes a puff has; more of them cost time.',
  }),
  quantity('puff.seed', 'puff', 'style', {
    kind: 'integer',
    min: 0,
    max: 9999,
    step: 1,
    default: 0,
    label: 'Shapes from',
    text: 'Each number has shapes of its own; 0 has those that were chosen by hand.',
  }),
  toggle('shading', 'Shading', 'Light and shade on the puffs; off leaves them flat.'),
  toggle('outlines', 'Outlines', 'Ink around the smoke and between its puffs.'),
  toggle('creases', 'Creases', 'Ink along the sharp edges of surfaces, and where still ones meet.'),
  toggle('shadows', 'Shadows', 'Smoke shades itself and what stands below it.'),
  choice(
    'style.shadowSteps',
    'style',
    'style',
    { label: 'Shadow steps', text: 'Two steps let shadow grow darker where much stands in the light.', default: 1 },
    [
      [1, 'One'],
      [2, 'Two'],
    ],
  ),
  quantity('style.shadowDepth', 'style', 'style', {
    kind: 'integer',
    min: 2,
    max: 100,
    step: 1,
    default: 6,
    label: 'Deep from',
    text: 'How many puffs and things must shade a place for the second step of shadow.',
  }),
  color('deepShadow', 'Deep shadow', 'The colours of shadow are multiplied by this in its second step.', '#a79bc9'),
  choice(
    'style.tones',
    'style',
    'style',
    { label: 'Tones', text: 'How many flat tones the light is cut into.', default: 2 },
    [
      [1, 'One'],
      [2, 'Two'],
      [3, 'Three'],
    ],
  ),
  ramp('ramp', 'Own tones', 'Colours from shadow to full light in the place of the number of tones.'),
  toggle('rampBlend', 'Blend own tones', 'Lets your own tones run into each other; off keeps them flat.', 0),
  quantity('style.fill', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Fill light',
    text: 'A second tone inside the shadow, where a weaker light from the other side would reach.',
  }),
  quantity('style.rim', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.02,
    default: 0,
    label: 'Rim light',
    text: 'How broad a bright band runs along edges that look away from the light.',
  }),
  color('rimColor', 'Rim', 'Colour of the rim light.', '#fff6d8'),
  color('smokeColor', 'Smoke', 'Colour of the smoke in full light.', '#f6efe2'),
  color('tint1', 'Tint 1', 'Colour of smoke that an emitter or an obstacle has given tint 1.', '#f08a5d'),
  color('tint2', 'Tint 2', 'Colour of smoke that an emitter or an obstacle has given tint 2.', '#7fb2e5'),
  color('tint3', 'Tint 3', 'Colour of smoke that an emitter or an obstacle has given tint 3.', '#8fcf7a'),
  ramp('ageRamp', 'Colour by age', 'Colours of the smoke over its life, in the place of its one colour.'),
  ramp(
    'heatRamp',
    'Colour by heat',
    'Colours of the smoke from cold (0) to temperature 1, such as from smoke to fire.',
  ),
  toggle('softColors', 'Soft colours', 'Lets colours by age and heat run into each other; off keeps them apart.', 0),
  color('inkColor', 'Ink', 'Colour of the outlines.', '#1d1720'),
  ramp(
    'backdrop',
    'Own backdrop',
    "Two colours of what lies behind, from below to above, in the place of the scene's.",
  ),
  quantity('style.wash', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Wash',
    text: 'How far the things of the scene give up their colours for shades of one.',
  }),
  color('washColor', 'Wash colour', 'The lightest of those shades.', '#f2ead8'),
  quantity('style.outlineWidth', 'style', 'style', {
    min: 0,
    max: 8,
    step: 0.1,
    default: 2.2,
    unit: 'px',
    label: 'Line width',
    text: 'Width of the outlines in pixels of the page, the same near and far.',
  }),
  quantity('style.inkSwell', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0.35,
    label: 'Line swell',
    text: 'How much lines swell away from the light and thin towards it; 0 keeps them even.',
  }),
  quantity('style.boil', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Line boil',
    text: 'How much lines tremble, as if each drawing were traced anew, twelve times a second.',
  }),
  {
    ...quantity('style.hold', 'style', 'simulator', {
      kind: 'integer',
      min: 1,
      max: 4,
      step: 1,
      default: 1,
      unit: '/ 24 s',
      label: 'Hold',
      text: 'How many frames of film each puff stands still: 1 moves smoothly, 2 to 4 are drawn on twos, threes and fours.',
    }),
    isOptional: true,
  },
  quantity('style.innerLine', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.02,
    default: 0.18,
    unit: 'radii',
    label: 'Inner lines',
    text: 'How far one puff must stand before another for ink between them; 0 outlines every puff.',
  }),
  quantity('style.innerTaper', 'style', 'style', {
    min: 0,
    max: 4,
    step: 0.1,
    default: 1,
    unit: '\u00d7',
    label: 'Inner taper',
    text: 'How gradually a line between puffs grows with their distance; 0 gives each its full width at once.',
  }),
  choice(
    'style.gradient',
    'style',
    'style',
    { label: 'Gradient', text: 'Blends towards the second colour.', default: 'none' },
    [
      ['none', 'None'],
      ['puff', 'Over each puff'],
      ['height', 'By height'],
      ['screen', 'Up the picture'],
      ['age', 'By age'],
    ],
  ),
  color('gradientColor', 'Second colour', 'Where the gradient ends.', '#b9a6d8'),
  height('gradientBottom', 'Gradient from', 'Height at which a gradient by height has the second colour.', 0.9),
  height('gradientTop', 'Gradient to', 'Height at which a gradient by height has the colour of the smoke.', 3),
  choice(
    'style.renderer',
    'style',
    'style',
    {
      label: 'Renderer',
      text: 'How smoke is drawn: as here, or as others draw it, to compare.',
      default: 'nailboards',
    },
    [
      ['nailboards', 'Nailboards'],
      ['selle', 'Depth lines (Selle 2004)'],
      ['sprites', 'Soft sprites'],
      ['shadowMap', 'Shadow map'],
    ],
  ),
  choice(
    'light.kind',
    'light',
    'light',
    {
      label: 'Light',
      text: 'The sun lights all from one side; a lamp stands in the scene, and shadows spread away from it.',
      default: 'sun',
    },
    [
      ['sun', 'Sun'],
      ['lamp', 'Lamp'],
    ],
  ),
  quantity('light.azimuth', 'light', 'light', {
    min: -180,
    max: 180,
    step: 1,
    default: 40,
    unit: '\u00b0',
    label: 'Direction',
    text: 'Where the light comes from around the scene: 0 is the front, 90 the right.',
  }),
  quantity('light.elevation', 'light', 'light', {
    min: 5,
    max: 90,
    step: 1,
    default: 50,
    unit: '\u00b0',
    label: 'Height',
    text: 'How high the light stands: 90 is straight above.',
  }),
  quantity('light.distance', 'light', 'light', {
    min: 0.5,
    max: 50,
    step: 0.1,
    default: 4,
    unit: 'm',
    slider: 'fine',
    label: 'Distance',
    text: 'How far a lamp stands from the middle of the scene; the sun is as far as ever.',
  }),
  eye('azimuth', {
    min: -180,
    max: 180,
    step: 1,
    default: 8.6,
    unit: '\u00b0',
    label: 'Seen from',
    text: 'From where around the scene it is seen: 0 is the front, 90 the right.',
  }),
  eye('elevation', {
    min: -5,
    max: 88,
    step: 1,
    default: 9.2,
    unit: '\u00b0',
    label: 'Eye height',
    text: 'How far from above it is seen: 0 is level.',
  }),
  eye('distance', {
    min: 0.3,
    max: 40,
    step: 0.1,
    default: 6.3,
    unit: 'm',
    slider: 'fine',
    label: 'Eye distance',
    text: 'How far the eye is from what it looks at.',
  }),
  eyeTarget('x', 0.15),
  eyeTarget('y', 1.5),
  eyeTarget('z', 0),
  multiplier('gravity', 'Gravity', 'Pull down on all smoke.'),
  multiplier('buoyancy', 'Buoyancy', 'Lift of warm smoke; it fades as the smoke cools.'),
  multiplier('turbulence', 'Turbulence', 'Small irregular swirls in the air.'),
  multiplier('vortex', 'Vortices', 'Strength of all vortices together.'),
  multiplier('drag', 'Drag', 'How firmly the air takes smoke along.'),
  wind('x', 'Wind to the right', 'Steady wind along x; negative blows to the left.'),
  wind('y', 'Wind upwards', 'Steady wind along y; negative blows down.'),
  wind('z', 'Wind to the front', 'Steady wind along z; negative blows away from the viewer.'),
  quantity('turbulence.speed', 'turbulence', 'simulator', {
    min: 0,
    max: 20,
    step: 0.02,
    default: 0.13,
    unit: 'm/s',
    slider: 'fine',
    label: 'Speed',
    text: 'Typical (root mean square) speed of the swirls.',
  }),
  quantity('turbulence.scale', 'turbulence', 'simulator', {
    min: 0.05,
    max: 20,
    step: 0.05,
    default: 0.9,
    unit: 'm',
    slider: 'fine',
    label: 'Scale',
    text: 'Size of the largest swirls.',
  }),
  quantity('turbulence.octaves', 'turbulence', 'simulator', {
    kind: 'integer',
    min: 0,
    max: 4,
    step: 1,
    default: 2,
    label: 'Octaves',
    text: 'How many finer layers of swirls are added; 0 is still air.',
  }),
  quantity('turbulence.evolution', 'turbulence', 'simulator', {
    min: 0,
    max: 10,
    step: 0.02,
    default: 0.25,
    unit: '1/s',
    slider: 'fine',
    label: 'Evolution',
    text: 'How fast the pattern of swirls changes.',
  }),
  ofScene('gravity.acceleration', 'air', {
    max: 100,
    default: 0,
    unit: 'm/s\u00b2',
    label: 'Weight',
    text: 'How fast cold smoke falls.',
  }),
  ofScene('buoyancy.acceleration', 'air', {
    max: 100,
    default: 1.5,
    unit: 'm/s\u00b2',
    label: 'Lift',
    text: 'How fast smoke at temperature 1 rises.',
  }),
  ofScene('buoyancy.coolingTime', 'air', {
    min: 0.01,
    max: 1000,
    default: 4,
    unit: 's',
    label: 'Cooling',
    text: 'How long warm smoke takes to lose two thirds of its warmth.',
  }),
  ofScene('drag.rate', 'air', {
    max: 1000,
    default: 1.5,
    unit: '1/s',
    label: 'Drag rate',
    text: 'How firmly the air of this scene takes smoke along.',
  }),
  ofScene('drag.quadratic', 'air', {
    max: 1000,
    default: 0,
    unit: '1/m',
    label: 'Quadratic drag',
    text: 'Drag that grows with speed: fast smoke is stopped first.',
  }),
  ofScene('wind.gusts', 'air', {
    max: 20,
    default: 0,
    unit: 'm/s',
    label: 'Gusts',
    text: 'Typical (root mean square) speed of gusts along the wind.',
  }),
  ofScene('wind.gustTime', 'air', {
    min: 0.1,
    max: 60,
    default: 2,
    unit: 's',
    label: 'Gust time',
    text: 'How long a strong gust lasts.',
  }),
  ofScene('wind.shear', 'air', {
    min: -10,
    max: 10,
    default: 0,
    unit: '1/m',
    label: 'Wind shear',
    text: 'How much faster the wind is for each metre of height, as a share.',
  }),
  ofScene('wind.height', 'air', {
    min: -1000,
    max: 1000,
    default: 0,
    unit: 'm',
    label: 'Shear height',
    text: 'Height at which shear changes nothing.',
  }),
  {
    ...choice(
      'simulation.integrator',
      'simulation',
      'simulator',
      {
        label: 'Motion',
        text: 'How puffs follow the air; the paper lets vortices fling them out.',
        default: 'airAndSlip',
      },
      [
        ['airAndSlip', 'With the air'],
        ['paper', 'As in the paper'],
      ],
    ),
    isOptional: true,
  },
  quantity('simulation.maxParticles', 'simulation', 'stage', {
    kind: 'integer',
    min: 1,
    max: 1000000,
    linkMax: 50000,
    step: 100,
    default: 4000,
    slider: 'fine',
    label: 'Most particles',
    text: 'Room for living puffs; when it is full, new ones wait.',
  }),
  ...listParameters(),
];

const rows: ReadonlyMap<string, Parameter> = new Map(table.map((parameter) => [parameter.key, parameter]));

/** The row with this key, or undefined. Safe for keys from strangers, `__proto__` included. */
export function findParameter(key: string): Parameter | undefined {
  return rows.get(key);
}
