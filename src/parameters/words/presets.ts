/** The named presets with what the gallery says of them. */
import type { Values } from '../parameter.ts';
import { presets as withoutWords } from '../presets.ts';
import type { PresetName } from '../valueTypes.ts';

export interface Preset {
  /** Name in links: the scene's name, followed by a dash and the look if it is not the scene's first preset. */
  readonly name: PresetName;
  /** Display name. */
  readonly label: string;
  /** One sentence about the look. */
  readonly text: string;
  readonly values: Values;
}

const words: Readonly<Record<PresetName, Pick<Preset, 'label' | 'text'>>> = {
  lamp: { label: 'Lamp', text: 'White smoke in two tones that rises from the spout and curls.' },
  'lamp-noir': { label: 'Noir', text: 'White, one grey and heavy ink, as printed in black and white.' },
  'lamp-sunset': { label: 'Sunset', text: 'Three warm tones under a low sun.' },
  'lamp-ghost': { label: 'Ghost', text: 'Pale smoke without ink that hangs in the air and thins out.' },
  'lamp-ember': { label: 'Ember', text: 'Fire that leaves the spout and cools to dark smoke.' },
  'lamp-storm': { label: 'Storm', text: 'Dark smoke torn by gusts from the right.' },
  'lamp-blueprint': { label: 'Blueprint', text: 'White lines on blue, without light and shade.' },
  'lamp-newspaper': { label: 'Newspaper', text: 'Two greys on yellowed paper, as in an old comic strip.' },
  'lamp-candy': { label: 'Candy', text: 'Three tones from violet through pink to vanilla.' },
  'lamp-papercut': { label: 'Paper cut', text: 'Sheets of paper without ink that fade upwards.' },
  'lamp-wind-waker': {
    label: 'Wind waker',
    text: 'Round white smoke under a saturated sky, with light along its edges.',
  },
  'lamp-engraving': { label: 'Engraving', text: 'Fine lines that follow the form and swell into shadow.' },
  airplane: { label: 'Airplane', text: 'A little biplane that parts the morning clouds. Steer it.' },
  'airplane-ukiyo-e': { label: 'Ukiyo-e', text: 'Indigo on rice paper, like a woodcut.' },
  'airplane-air-show': { label: 'Air show', text: 'Pink and yellow smoke rolls up behind the wings.' },
  'airplane-corkscrew': { label: 'Corkscrew', text: 'The vortex of the propeller winds two ribbons of smoke.' },
  'airplane-manga': { label: 'Manga', text: 'White smoke and a sky of screentone, with heavy ink.' },
  train: { label: 'Steam train', text: 'A toy train in a circle, with a puff for each piston stroke.' },
  'train-night-mail': { label: 'Night mail', text: 'Moonlight from behind on the last train of the day.' },
  'train-rubber-hose': {
    label: 'Rubber hose',
    text: 'Few round puffs and thick, even ink of the 1930s, drawn on twos.',
  },
  'train-ghost-fog': {
    label: 'Ghost-train fog',
    text: 'Violet fog that lies on the track, and green smoke above it at night.',
  },
  'train-dusk': { label: 'Dusk', text: 'The low sun turns the steam gold and its shadow violet.' },
  'train-night': { label: 'Night', text: 'Blue steam with a bright edge in the moonlight.' },
  campfire: { label: 'Campfire', text: 'Fire that cools to smoke under a night sky.' },
  'campfire-night': {
    label: 'Night',
    text: 'The fire lights the camp and its own smoke, and sparks rise into the dark.',
  },
  'campfire-popcorn': { label: 'Popcorn', text: 'Drawn popcorn that jumps out of the fire.' },
  rocket: { label: 'Rocket launch', text: 'A rocket that takes off in a ring of cloud, and returns.' },
  'rocket-night': { label: 'Night', text: 'The flame lights the sand, and the cloud from inside.' },
  'rocket-newsprint': { label: 'Newsprint', text: 'Shadow in black dots on yellowed paper.' },
  genie: { label: 'Genie', text: 'A genie of smoke at your service. Drag him anywhere.' },
  'genie-sumi-e': { label: 'Sumi-e', text: 'Brush and black ink on white paper; the lines tremble.' },
  'genie-potion': { label: 'Potion', text: 'Drawn skulls that rise in poisonous green.' },
  dust: { label: 'Dust', text: 'Falling objects raise dust. Throw the red ball, or leave it to the mole.' },
  cloudscape: { label: 'Cloudscape', text: 'Clouds drift over a meadow, and the sun moves on.' },
  'cloudscape-gouache': { label: 'Gouache', text: 'Evening clouds in three broad tones, painted without a line.' },
  'cloudscape-cumulus': {
    label: 'Cumulus',
    text: 'Great white summer clouds in three broad tones under a deep blue sky.',
  },
  'cloudscape-ink-wash': { label: 'Ink wash', text: 'Wet grey washes on paper, and a brush line that swells below.' },
  'cloudscape-dusk': { label: 'Dusk', text: 'The last sun on violet clouds.' },
  'cloudscape-night': { label: 'Night', text: 'Clouds in the moonlight over a sleeping meadow.' },
  'cloudscape-woodcut': { label: 'Woodcut', text: 'Drawn clouds with cut hatching, printed in two inks.' },
  'cloudscape-riso': { label: 'Riso', text: 'Pink and blue, printed a little out of register.' },
  wisp: { label: 'Cup of tea', text: 'Steam from a friendly cup of tea.' },
  'wisp-matcha': { label: 'Matcha', text: 'One green in three tones.' },
  'wisp-hearts': { label: 'Hearts', text: 'Drawn hearts that rise from a cup for two.' },
  'wisp-flourish': { label: 'Flourish', text: 'Steam along an S that is drawn into the air.' },
  'wisp-valentine': { label: 'Valentine', text: 'Steam along two strokes that are a heart.' },
  'wisp-charcoal': { label: 'Charcoal', text: 'Grain of charcoal on grey paper.' },
  firework: { label: 'Firework', text: 'Shells of six colours that rise, burst and fall over an island at night.' },
  title: { label: 'Title', text: 'Twelve seconds of film: four letters burst out of the stage in clouds of colour.' },
  dragon: { label: 'Dragon', text: 'A small dragon that breathes fire and smoke on the beat.' },
  'dragon-night': { label: 'Night', text: 'The fire lights the dragon, its gold and its smoke.' },
  teapot: { label: 'Teapot', text: 'Steam that writes a word, again every twelve seconds.' },
  air: { label: 'Open air', text: 'Only smoke, to flow over pages and around their elements.' },
  'air-ring': { label: 'Ring', text: 'Smoke runs in a closed stroke and turns about it.' },
  'air-comic-explosion': {
    label: 'Comic explosion',
    text: 'A burst from yellow to red in thick ink, again every two seconds.',
  },
  'air-leaves': { label: 'Autumn leaves', text: 'Drawn leaves that fall in the wind.' },
  'air-pow': { label: 'Pow', text: 'Drawn letters and stars of a comic blow, again every two seconds.' },
};

/** Presets grouped by scene. The first one of a scene has the scene's name and is its default look. */
export const presets: readonly Preset[] = withoutWords.map((preset) => ({ ...preset, ...words[preset.name] }));

const byName: ReadonlyMap<string, Preset> = new Map(presets.map((preset) => [preset.name, preset]));

/** Preset for a link without a preset or with an unknown one. */
export const defaultPreset: Preset = presets[0];

/** The preset with this name, or undefined. Safe for untrusted names. */
export function findPreset(name: string): Preset | undefined {
  return byName.get(name);
}
