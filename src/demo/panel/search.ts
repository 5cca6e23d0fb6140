import type { Parameter } from '../../preset.ts';
import { create, uniqueId } from '../ui/dom.ts';
import type { Row } from './row.ts';
import { strings } from '../strings.ts';

type ParameterRows = Iterable<readonly [Parameter, Row]>;

/**
 * Search field that filters the panel by labels, synonyms, keys, descriptions and group names, in both spellings.
 * Matching groups open; the best matches come first.
 * @param all returns the current rows in their order, which change with the items
 * @param panel contains the groups
 */
export function createSearch(all: () => ParameterRows, panel: HTMLElement): HTMLElement {
  const id = uniqueId();
  const field = create('input', { id, type: 'search', class: 'search-field', placeholder: strings.panel.search });
  field.setAttribute('aria-label', strings.panel.search);
  const found = create('p', { role: 'status', class: 'search-found' });
  // The groups in their order before the search, and whether they were open.
  const before = new Map<HTMLDetailsElement, boolean>();
  const filter = () => {
    const rows = all();
    for (const group of panel.querySelectorAll<HTMLDetailsElement>('details.group:not([hidden])')) {
      if (!before.has(group)) before.set(group, group.open);
    }
    const isSearch = field.value.trim() !== '';
    const count = showOnly(field.value, rows, [...before.keys()]);
    if (!isSearch) {
      for (const [group, wasOpen] of before) group.open = wasOpen;
      before.clear();
    }
    found.textContent = isSearch ? strings.panel.found(count) : '';
  };
  field.addEventListener('input', filter);
  return create('div', { class: 'search', role: 'search' }, field, found);
}

/** Shows the matches of a query, the best ones first; all rows in their order for an empty query. */
function showOnly(query: string, rows: ParameterRows, groups: readonly HTMLDetailsElement[]): number {
  const titles = new Map(groups.map((group) => [group, group.querySelector('summary')!.textContent]));
  const ranked = new Map<HTMLDetailsElement, [rank: number, row: HTMLElement][]>(groups.map((group) => [group, []]));
  for (const [parameter, { element }] of rows) {
    const group = element.closest('details')!;
    const rank = rankOf(query, parameter, titles.get(group) ?? '');
    element.classList.toggle('is-filtered', rank === undefined);
    ranked.get(group)?.push([rank ?? Infinity, element]);
  }
  let count = 0;
  const order: [rank: number, group: HTMLElement][] = [];
  for (const [group, members] of ranked) {
    const shown = members.filter(([rank]) => rank < Infinity);
    const isNamed = rankOf(query, NAMELESS, titles.get(group)!) !== undefined;
    group.classList.toggle('is-filtered', shown.length === 0 && !isNamed);
    group.open ||= shown.length > 0;
    count += shown.length;
    reorder(members);
    order.push([Math.min(Infinity, ...shown.map(([rank]) => rank)), group]);
  }
  for (const parent of new Set(groups.map((group) => group.parentElement))) {
    reorder(order.filter(([, group]) => group.parentElement === parent));
  }
  return count;
}

/** Sorts elements by rank, and those of equal rank as they are given. The others of their parent stay in place. */
function reorder(elements: [rank: number, element: HTMLElement][]): void {
  const sorted = elements.toSorted(([a], [b]) => a - b || 0).map(([, element]) => element);
  const siblings = [...(sorted[0]?.parentElement?.children ?? [])].filter((each) =>
    sorted.includes(each as HTMLElement),
  );
  if (siblings.every((each, index) => each === sorted[index])) return;
  const marker = new Comment();
  siblings[0].before(marker);
  marker.replaceWith(...sorted);
}

const NAMELESS = { key: '', label: '', text: '' };
/** British and American spellings of words in the panel. */
const SPELLINGS = ['colour color', 'neighbour neighbor', 'grey gray', 'centre center', 'metre meter'];

/**
 * How well a parameter matches a query: less is better, undefined for no match. Each word of the query must begin a word
 * of the parameter or be within its label.
 * @param title of its group
 */
export function rankOf(
  query: string,
  { key, label, text }: Pick<Parameter, 'key' | 'label' | 'text'>,
  title: string,
): number | undefined {
  const name = label.toLowerCase();
  const isNamed = (word: string) => spellings(name).some((each) => each.includes(word));
  const tests: ((word: string) => boolean)[] = [
    (word) => spellings(name).includes(word),
    (word) => begins(word, label),
    (word) => word.length > 2 && isNamed(word),
    (word) => begins(word, synonyms[key.replace(/\d+/, '#')] ?? ''),
    (word) => begins(word, key.replaceAll(/[A-Z]/g, ' $&')),
    (word) => begins(word, text),
    (word) => begins(word, title),
  ];
  const ranks = query
    .toLowerCase()
    .split(/\s+/)
    .filter(Boolean)
    .map((word) => tests.findIndex((test) => test(word) || (word.length > 3 && test(word.replace(/s$/, '')))));
  return ranks.includes(-1) ? undefined : ranks.reduce((sum, rank) => sum + rank, 0);
}

/** Whether a word of a text begins with these letters. */
function begins(letters: string, text: string): boolean {
  return spellings(text.toLowerCase()).some((each) =>
    each.split(/[^\p{L}\p{N}]+/u).some((word) => word.startsWith(letters)),
  );
}

function spellings(text: string): readonly string[] {
  const pairs = SPELLINGS.map((pair) => pair.split(' '));
  const british = pairs.reduce((spelt, [uk, us]) => spelt.replaceAll(us, uk), text);
  return [british, pairs.reduce((spelt, [uk, us]) => spelt.replaceAll(uk, us), british)];
}

/** Words that people search for, by key. Of items, `#` is their number. Labels and descriptions need not be repeated. */
export const synonyms: Readonly<Record<string, string>> = {
  'emission.rate': 'amount quantity count number intensity flow strength',
  'emission.lifetime': 'duration length age time fade',
  'emission.growthTime': 'grow expand swell',
  'emission.density': 'opacity transparency opaque transparent alpha thickness thick thin fade',
  'emission.glow': 'fire flame emissive emission bright night hot heat lamp',
  'emission.dissolve': 'fade vanish disappear erode opacity tear strand tatter',
  'emission.entrainment': 'expand spread widen grow',
  'emission.company': 'group cluster neighbours stragglers crumbs end',
  'puff.size': 'scale radius diameter big small large tiny',
  'emission.sizeSpread': 'uneven swell',
  'puff.variations': 'variety random',
  'puff.turn': 'rotation rotate spin roll',
  'puff.stretch': 'elongate smear squash motion blur',
  'puff.billow': 'unfold bloom curl swell',
  'puff.form': 'type sprites shape',
  'puff.drawing': 'draw paint pen own custom shape heart letter text svg png image logo',
  'puff.upright': 'roll rotation rotate angle tilt straight level',
  'puff.views': 'sides directions angles sprites rotations',
  'puff.precision': 'byte half float depth quality',
  'puff.lumpiness': 'bumpy bubbly fluffy shape',
  'puff.flatness': 'squash height shape',
  'puff.roughness': 'irregular random noise shape',
  'puff.lobes': 'bubbles balls blobs detail',
  'puff.seed': 'random',
  'style.shading': 'shade shadow toon cel lighting',
  'style.outlines': 'border stroke edge contour silhouette',
  'style.creases': 'edges lines',
  'style.shadows': 'shade dark darkness',
  'style.surfaceShadowColor': 'ground floor shade',
  'style.deepShadow': 'shade dark',
  'style.tones': 'bands steps levels cel toon posterize shades',
  'style.pattern': 'halftone screentone benday hatching hatch print comic newspaper engraving charcoal paper texture',
  'style.patternShiftX': 'register misregistration offset riso',
  'style.ramp': 'palette gradient bands shades cel toon import lospec image photo picture',
  'style.rampBlend': 'smooth soft gradient',
  'style.fill': 'ambient bounce',
  'style.simplify': 'detail clean smooth',
  'style.form': 'volume shape depth',
  'style.strokes': 'brush sketch pencil lines',
  'style.rim': 'glow halo backlight highlight edge shine',
  'style.rimColor': 'glow halo backlight highlight',
  'style.smokeColor': 'white grey gray black hue paint',
  'style.tint1': 'hue',
  'style.tint2': 'hue',
  'style.tint3': 'hue',
  'style.ageRamp': 'gradient palette fade',
  'style.heatRamp': 'fire flame glow temperature palette gradient',
  'style.softColors': 'smooth blend gradient',
  'style.inkColor': 'outlines border stroke contour edge pen lines black',
  'style.inkLight': 'outlines pen lines night dark',
  'style.backdrop': 'background bg sky wallpaper gradient',
  'style.wash': 'watercolour monochrome grey gray sepia tint',
  'style.outlineWidth': 'thickness border stroke edge contour pen weight size thick thin bold',
  'style.inkSwell': 'calligraphy brush pressure taper thickness',
  'style.boil': 'wobble jitter shake wiggle jiggle',
  'style.hold': 'fps rate stepped choppy twos animation speed',
  'style.innerLine': 'inside detail',
  'style.gradient': 'blend fade',
  'style.renderer': 'method engine',
  'light.hour': 'clock daytime night dusk dawn sunset sunrise noon evening morning moon',
  'light.kind': 'sun lamp source',
  'light.azimuth': 'sun angle rotation',
  'light.elevation': 'sun angle altitude',
  'light.decay': 'lamp falloff fade attenuation distance',
  'light.color': 'sun lamp hue night dusk sunset',
  'light.intensity': 'sun lamp brightness dark night dusk exposure',
  'light.ambientColor': 'sky shadow shade hue night dusk',
  'light.ambient': 'sky shadow shade brightness dark night dusk exposure',
  'camera.azimuth': 'view angle orbit rotate',
  'camera.elevation': 'view angle orbit tilt pitch',
  'camera.distance': 'zoom view near far',
  'camera.target.x': 'pan look centre',
  'camera.target.y': 'pan look centre height',
  'camera.target.z': 'pan look centre',
  'forces.gravity': 'weight fall heavy down sink',
  'forces.buoyancy': 'rise lift float up hot heat',
  'forces.turbulence': 'noise chaos curl swirl random',
  'forces.vortex': 'swirl spin tornado whirl curl',
  'forces.drag': 'friction resistance damping',
  'forces.wind.x': 'breeze blow left sideways',
  'forces.wind.y': 'breeze blow up down rise',
  'forces.wind.z': 'breeze blow forward back',
  'turbulence.speed': 'velocity strength',
  'turbulence.scale': 'size frequency',
  'turbulence.octaves': 'detail',
  'turbulence.evolution': 'change animation',
  'gravity.acceleration': 'weight fall heavy',
  'buoyancy.acceleration': 'rise lift float',
  'drag.rate': 'friction resistance damping',
  timeline: 'keyframe animate animation record burst easing driver drive music sound audio midi scroll',
  'simulation.maxParticles': 'limit count amount budget performance',
  'simulation.integrator': 'physics method',
  'emitters.#.shape': 'source',
  'emitters.#.speed': 'velocity',
  'emitters.#.spread': 'angle width',
  'emitters.#.size': 'scale big small',
  'emitters.#.share': 'amount rate weight',
  'emitters.#.temperature': 'heat hot warm',
};
