import type {
  ColorParameter,
  Keyed,
  NumberParameter,
  Parameter,
  RampParameter,
  ToggleParameter,
} from '../parameter.ts';
import { choice, quantity, simulated } from './row.ts';

/** Shadows, tones, colours and ink. The types keep the keys: the fields of `Style` follow from them. */
export const styleRows = [
  toggle('shading', 'Shading', 'Light and shade on puffs; off draws them flat.'),
  toggle('outlines', 'Outlines', 'Ink around the smoke and between its puffs.'),
  toggle('creases', 'Creases', 'Ink along sharp edges of surfaces and where motionless surfaces meet.'),
  toggle('shadows', 'Shadows', 'Smoke casts shadows on itself and on the objects of the scene.'),
  choice(
    'style.shadowSteps',
    'style',
    'style',
    { label: 'Shadow steps', text: 'With two steps, shadow is darker where many puffs block the light.', default: 1 },
    [
      [1, 'One'],
      [2, 'Two'],
    ],
  ),
  choice(
    'style.volumes',
    'style',
    'style',
    {
      label: 'Volumes',
      text: 'How shadow volumes are counted: at the depth of each pixel, or by entry and exit as in the paper.',
      default: 'receiver',
    },
    [
      ['receiver', 'By receiver'],
      ['counted', 'By entry and exit'],
    ],
  ),
  quantity('style.shadowDepth', 'style', 'style', {
    kind: 'integer',
    min: 2,
    max: 100,
    step: 1,
    default: 6,
    label: 'Deep shadow from',
    text: 'Number of puffs that must shade a point for the second step of shadow. All objects of the scene count as one.',
  }),
  {
    ...color(
      'surfaceShadowColor',
      'Surface shadow',
      'Multiplies the colours of objects in shadow. By default it has the hue of the first custom tone.',
      '#968cc4',
    ),
    isOptional: true,
  },
  color('deepShadow', 'Deep shadow', 'Multiplies the colours of shadow in the second step.', '#a79bc9'),
  choice('style.tones', 'style', 'style', { label: 'Tones', text: 'Number of flat tones of the light.', default: 2 }, [
    [1, 'One'],
    [2, 'Two'],
    [3, 'Three'],
  ]),
  ramp('ramp', 'Custom tones', 'Colours from shadow to full light. They replace the number of tones.'),
  toggle('rampBlend', 'Blend custom tones', 'Blends neighbouring custom tones; off keeps them flat.', 0),
  quantity('style.fill', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Fill light',
    text: 'A second tone in shadow, lit by a weaker light from the other side.',
  }),
  quantity('style.simplify', 'style', 'style', {
    min: 0,
    max: 8,
    step: 0.25,
    default: 0,
    unit: 'px',
    label: 'Simplify',
    text: 'Merges small patches of light and shade into large shapes; 0 keeps them all.',
  }),
  quantity('style.form', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Form',
    text: 'How far light and shade follow the form of the whole smoke instead of that of each puff.',
  }),
  quantity('style.strokes', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Strokes',
    text: 'Tapered lines inside the smoke where a lobe stands before another, most of them on the shaded side.',
  }),
  quantity('style.rim', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.02,
    default: 0,
    label: 'Rim light',
    text: 'Width of a bright band along edges that face away from the light.',
  }),
  color('rimColor', 'Rim colour', 'Colour of the rim light.', '#fff6d8'),
  color('smokeColor', 'Smoke', 'Colour of the smoke in full light.', '#f6efe2'),
  color(
    'tint1',
    'Tint 1',
    'Colour of smoke that an emitter or an obstacle has given tint 1, 4, 7, 10 or 13.',
    '#f08a5d',
  ),
  color(
    'tint2',
    'Tint 2',
    'Colour of smoke that an emitter or an obstacle has given tint 2, 5, 8, 11 or 14.',
    '#7fb2e5',
  ),
  color(
    'tint3',
    'Tint 3',
    'Colour of smoke that an emitter or an obstacle has given tint 3, 6, 9, 12 or 15.',
    '#8fcf7a',
  ),
  ramp('ageRamp', 'Colour by age', 'Colours of the smoke over its lifetime. They replace the single colour.'),
  ramp(
    'heatRamp',
    'Colour by heat',
    'Colours of the smoke from cold (0) to temperature 1, such as from smoke to fire.',
  ),
  toggle('softColors', 'Soft colours', 'Blends neighbouring colours by age and heat; off keeps them separate.', 0),
  color('inkColor', 'Ink', 'Colour of the outlines.', '#1d1720'),
  ramp(
    'backdrop',
    'Custom backdrop',
    'Colours of the backdrop from bottom to top, blended between their heights. They replace those of the scene.',
  ),
  quantity('style.wash', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Wash',
    text: 'How much the objects of the scene take on shades of one colour.',
  }),
  color('washColor', 'Wash colour', 'The lightest shade of the wash.', '#f2ead8'),
  quantity('style.outlineWidth', 'style', 'style', {
    min: 0,
    max: 8,
    step: 0.1,
    default: 2.2,
    unit: 'px',
    label: 'Line width',
    text: 'Width of the outlines in CSS pixels, the same near and far.',
  }),
  quantity('style.inkSwell', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0.35,
    label: 'Line swell',
    text: 'How much lines widen on the side away from the light and narrow towards it; 0 keeps them even.',
  }),
  quantity('style.boil', 'style', 'style', {
    min: 0,
    max: 1,
    step: 0.05,
    default: 0,
    label: 'Line boil',
    text: 'How much lines tremble, twelve times a second, as if each drawing were traced by hand.',
  }),
  {
    ...simulated('style.hold', 'style', {
      step: 1,
      unit: '/ 24 s',
      label: 'Hold',
      text: 'Number of film frames that each puff stays still: 1 moves smoothly, 2 to 4 animate on twos, threes and fours.',
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
    text: 'Minimum depth between two puffs for ink between them; 0 outlines every puff.',
  }),
  quantity('style.innerTaper', 'style', 'style', {
    min: 0,
    max: 4,
    step: 0.1,
    default: 1,
    unit: '\u00d7',
    label: 'Inner taper',
    text: 'How gradually a line between puffs widens with their distance; 0 always draws the full width.',
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
  color('gradientColor', 'Second colour', 'Second colour of the gradient.', '#b9a6d8'),
  height('gradientBottom', 'Gradient from', 'Height at which a gradient by height has the second colour.', 0.9),
  height('gradientTop', 'Gradient to', 'Height at which a gradient by height has the colour of the smoke.', 3),
  choice(
    'style.renderer',
    'style',
    'style',
    {
      label: 'Renderer',
      text: 'The rendering method; selle is for comparison.',
      default: 'nailboards',
    },
    [
      ['nailboards', 'Nailboards'],
      ['selle', 'Depth lines (Selle 2004)'],
    ],
  ),
] as const satisfies readonly Parameter[];

type OfStyle<Row, Name extends string> = Keyed<Row, `style.${Name}`, 'style'>;

function toggle<const Name extends string>(
  name: Name,
  label: string,
  text: string,
  initial: 0 | 1 = 1,
): OfStyle<ToggleParameter, Name> {
  return { kind: 'toggle', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: initial };
}

function ramp<const Name extends string>(name: Name, label: string, text: string): OfStyle<RampParameter, Name> {
  return { kind: 'ramp', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: '' };
}

function color<const Name extends string>(
  name: Name,
  label: string,
  text: string,
  initial: string,
): OfStyle<ColorParameter, Name> {
  return { kind: 'color', key: `style.${name}`, group: 'style', reader: 'style', label, text, default: initial };
}

function height<const Name extends string>(
  name: Name,
  label: string,
  text: string,
  initial: number,
): OfStyle<NumberParameter, Name> {
  const range = { min: -100, max: 100, step: 0.05, unit: 'm', slider: 'fine' } as const;
  return quantity(`style.${name}`, 'style', 'style', { ...range, label, text, default: initial });
}
