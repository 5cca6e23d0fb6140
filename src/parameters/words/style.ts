import type { styleRows } from '../rows/style.ts';
import type { WordsOf } from './words.ts';

/** What the panel says of shadows, tones, colours and ink. */
export const styleWords: WordsOf<typeof styleRows> = {
  'style.shading': { label: 'Shading', text: 'Light and shade on puffs; off draws them flat.' },
  'style.outlines': { label: 'Outlines', text: 'Ink around the smoke and between its puffs.' },
  'style.creases': { label: 'Creases', text: 'Ink along sharp edges of surfaces and where motionless surfaces meet.' },
  'style.shadows': { label: 'Shadows', text: 'Smoke casts shadows on itself and on the objects of the scene.' },
  'style.shadowSteps': {
    label: 'Shadow steps',
    text: 'With two steps, shadow is darker where many puffs block the light.',
    options: { 1: 'One', 2: 'Two' },
  },
  'style.volumes': {
    label: 'Volumes',
    text: 'How shadow volumes are counted: at the depth of each pixel, or by entry and exit as in the paper.',
    options: { receiver: 'By receiver', counted: 'By entry and exit' },
  },
  'style.shadowDepth': {
    label: 'Deep shadow from',
    text: 'Number of puffs that must shade a point for the second step of shadow. All objects of the scene count as one.',
    step: 1,
  },
  'style.surfaceShadowColor': {
    label: 'Surface shadow',
    text: 'Multiplies the colours of objects in shadow. By default it has the hue of the first custom tone.',
  },
  'style.deepShadow': { label: 'Deep shadow', text: 'Multiplies the colours of shadow in the second step.' },
  'style.tones': {
    label: 'Tones',
    text: 'Number of flat tones of the light.',
    options: { 1: 'One', 2: 'Two', 3: 'Three' },
  },
  'style.ramp': { label: 'Custom tones', text: 'Colours from shadow to full light. They replace the number of tones.' },
  'style.rampBlend': { label: 'Blend custom tones', text: 'Blends neighbouring custom tones; off keeps them flat.' },
  'style.fill': {
    label: 'Fill light',
    text: 'A second tone in shadow, lit by a weaker light from the other side.',
    step: 0.05,
  },
  'style.simplify': {
    label: 'Simplify',
    text: 'Merges small patches of light and shade into large shapes; 0 keeps them all.',
    step: 0.25,
  },
  'style.form': {
    label: 'Form',
    text: 'How far light and shade follow the form of the whole smoke instead of that of each puff.',
    step: 0.05,
  },
  'style.strokes': {
    label: 'Strokes',
    text: 'Tapered lines inside the smoke where a lobe stands before another, most of them on the shaded side.',
    step: 0.05,
  },
  'style.rim': {
    label: 'Rim light',
    text: 'Width of a bright band along edges that face away from the light.',
    step: 0.02,
  },
  'style.rimColor': { label: 'Rim colour', text: 'Colour of the rim light.' },
  'style.smokeColor': { label: 'Smoke', text: 'Colour of the smoke in full light.' },
  'style.tint1': {
    label: 'Tint 1',
    text: 'Colour of smoke that an emitter or an obstacle has given tint 1, 4, 7, 10 or 13.',
  },
  'style.tint2': {
    label: 'Tint 2',
    text: 'Colour of smoke that an emitter or an obstacle has given tint 2, 5, 8, 11 or 14.',
  },
  'style.tint3': {
    label: 'Tint 3',
    text: 'Colour of smoke that an emitter or an obstacle has given tint 3, 6, 9, 12 or 15.',
  },
  'style.ageRamp': {
    label: 'Colour by age',
    text: 'Colours of the smoke over its lifetime. They replace the single colour.',
  },
  'style.heatRamp': {
    label: 'Colour by heat',
    text: 'Colours of the smoke from cold (0) to temperature 1, such as from smoke to fire.',
  },
  'style.softColors': {
    label: 'Soft colours',
    text: 'Blends neighbouring colours by age and heat; off keeps them separate.',
  },
  'style.inkColor': { label: 'Ink', text: 'Colour of the outlines.' },
  'style.inkLight': {
    label: 'Ink in the light',
    text: 'How far outlines follow the colour and the strength of the light; 0 keeps their colour.',
    step: 0.05,
  },
  'style.backdrop': {
    label: 'Custom backdrop',
    text: 'Colours of the backdrop from bottom to top, blended between their heights. They replace those of the scene.',
  },
  'style.wash': { label: 'Wash', text: 'How much the objects of the scene take on shades of one colour.', step: 0.05 },
  'style.washColor': { label: 'Wash colour', text: 'The lightest shade of the wash.' },
  'style.outlineWidth': {
    label: 'Line width',
    text: 'Width of the outlines in CSS pixels, the same near and far.',
    step: 0.1,
  },
  'style.inkSwell': {
    label: 'Line swell',
    text: 'How much lines widen on the side away from the light and narrow towards it; 0 keeps them even.',
    step: 0.05,
  },
  'style.boil': {
    label: 'Line boil',
    text: 'How much lines tremble, twelve times a second, as if each drawing were traced by hand.',
    step: 0.05,
  },
  'style.hold': {
    label: 'Hold',
    text: 'Number of film frames that each puff stays still: 1 moves smoothly, 2 to 4 animate on twos, threes and fours.',
    step: 1,
    unit: '/ 24 s',
  },
  'style.innerLine': {
    label: 'Inner lines',
    text: 'Minimum depth between two puffs for ink between them; 0 outlines every puff.',
    step: 0.02,
  },
  'style.innerTaper': {
    label: 'Inner taper',
    text: 'How gradually a line between puffs widens with their distance; 0 always draws the full width.',
    step: 0.1,
    unit: '\u00d7',
  },
  'style.gradient': {
    label: 'Gradient',
    text: 'Blends towards the second colour.',
    options: { none: 'None', puff: 'Over each puff', height: 'By height', screen: 'Up the picture', age: 'By age' },
  },
  'style.gradientColor': { label: 'Second colour', text: 'Second colour of the gradient.' },
  'style.gradientBottom': {
    label: 'Gradient from',
    text: 'Height at which a gradient by height has the second colour.',
    step: 0.05,
    slider: 'fine',
  },
  'style.gradientTop': {
    label: 'Gradient to',
    text: 'Height at which a gradient by height has the colour of the smoke.',
    step: 0.05,
    slider: 'fine',
  },
  'style.pattern': {
    label: 'Pattern',
    text: 'Marks of a print that move with the puffs and keep their size on screen.',
    options: { none: 'None', dots: 'Dots', lines: 'Lines', crosshatch: 'Crosshatch', grain: 'Grain' },
  },
  'style.patternOn': {
    label: 'Pattern on',
    text: 'Where the marks are: in shadow, on lit tones below the lightest, or on both.',
    options: { shadow: 'Shadow', tones: 'Tones', both: 'Both' },
  },
  'style.patternCoverage': { label: 'Pattern coverage', text: 'Share of shadow that the marks cover.', step: 0.05 },
  'style.patternBackdrop': {
    label: 'Pattern on the backdrop',
    text: 'Share of the backdrop that marks cover at the top of the picture, falling to 0 at its bottom.',
    step: 0.05,
  },
  'style.patternColor': { label: 'Pattern colour', text: 'Colour of the marks.' },
  'style.patternSize': { label: 'Pattern size', text: 'Distance between marks in CSS pixels.', step: 0.5 },
  'style.patternAngle': {
    label: 'Pattern angle',
    text: 'Direction of lines and of rows of dots, counterclockwise in degrees.',
    step: 5,
  },
  'style.patternSoftness': {
    label: 'Pattern softness',
    text: 'Width of the soft edge of marks in CSS pixels.',
    step: 0.25,
  },
  'style.patternShiftX': {
    label: 'Pattern shift X',
    text: 'Offset of the marks to the right in CSS pixels, as of a plate that is out of register.',
    step: 0.5,
  },
  'style.patternShiftY': { label: 'Pattern shift Y', text: 'Offset of the marks upwards in CSS pixels.', step: 0.5 },
  'style.renderer': {
    label: 'Renderer',
    text: 'The rendering method; selle is for comparison.',
    options: { nailboards: 'Nailboards', selle: 'Depth lines (Selle 2004)' },
  },
};
