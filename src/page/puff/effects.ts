/** The effects: emitters in a vertical plane, in metres and seconds. One metre is 150 CSS pixels. */
import { DRAG, type Emission } from './emission.ts';
import { RANGES, type Effect, type PuffOptions } from './options.ts';
import { HOLD, sizeOfWord } from './words.ts';

/** Half sides of the target, metres; 0 for a point. */
export interface Extent {
  readonly halfWidth: number;
  readonly halfHeight: number;
}

interface EffectDesign {
  /** Whether smoke flows around the element. */
  readonly isAround: boolean;
  /** Default of the option, degrees. */
  readonly direction: number;
  /** @param text of the word that smoke forms */
  readonly emissions: (extent: Extent, text: string) => readonly Emission[];
}

/** Half angle of a cone of all directions, degrees. */
const ALL_AROUND = 180;
/** Seconds in which a burst's number of puffs appears when it is asked to last. */
const BURST_SECONDS = 0.5;
/** A shorter emission is a burst, seconds. */
const MIN_DURATION = 0.05;
/** Puffs of a call. */
const MAX_COUNT = RANGES.count[1];
/** The simulator's limit, m/s. */
const MAX_SPEED = 50;
/** Puffs for each metre of the target's outline, relative to those of a point. */
const CROWD = 0.3;

const made = (given: Partial<Emission>): Emission => ({
  shape: 'box',
  x: 0,
  y: 0,
  halfWidth: 0.03,
  halfHeight: 0.03,
  direction: 90,
  spread: ALL_AROUND,
  speed: 1,
  speedVariation: 0.4,
  size: 0.22,
  sizeVariation: 0.35,
  life: 1.2,
  lifeVariation: 0.25,
  temperature: 1,
  delay: 0,
  duration: 0,
  count: 16,
  ...given,
});

const crowd = ({ halfWidth, halfHeight }: Extent) => 1 + CROWD * 4 * (halfWidth + halfHeight);

const designs: Readonly<Record<Effect, EffectDesign>> = {
  /** A soft cloud opens, slows down and drifts up. */
  poof: {
    isAround: true,
    direction: 90,
    emissions: (extent) => [
      made({
        ...extent,
        speed: 1.3,
        speedVariation: 0.6,
        size: 0.26,
        life: 1.5,
        temperature: 1.2,
        count: 18 * crowd(extent),
      }),
    ],
  },
  /** A ring of small puffs opens fast and is gone. */
  pop: {
    isAround: false,
    direction: 90,
    emissions: (extent) => [
      made({
        shape: 'front',
        halfWidth: 0.12,
        spread: 86,
        speed: 2.8 + DRAG * Math.max(extent.halfWidth, extent.halfHeight),
        speedVariation: 0.06,
        size: 0.13,
        sizeVariation: 0.2,
        life: 0.55,
        lifeVariation: 0.08,
        count: 18 * crowd(extent),
      }),
    ],
  },
  /** Low clouds leave the lower edge to both sides and settle. */
  dust: {
    isAround: false,
    direction: 90,
    emissions: ({ halfWidth, halfHeight }) =>
      [-1, 1].map((side) =>
        made({
          x: (side * halfWidth) / 2,
          y: -halfHeight,
          halfWidth: halfWidth / 2,
          halfHeight: 0.04,
          direction: side < 0 ? 172 : 8,
          spread: 16,
          speed: 2.6,
          speedVariation: 0.75,
          size: 0.21,
          life: 1.7,
          temperature: 0.98,
          duration: 0.3,
          count: 12 * crowd({ halfWidth, halfHeight }),
        }),
      ),
  },
  /** A line of smoke along the way of the pointer or of an element. */
  trail: {
    isAround: false,
    direction: 90,
    emissions: () => [
      made({ speed: 0.25, size: 0.17, life: 1.3, lifeVariation: 0.1, temperature: 1.04, duration: 4, count: 150 }),
    ],
  },
  /** A fountain: small puffs shoot up, spread and fall. */
  burst: {
    isAround: true,
    direction: 90,
    emissions: ({ halfWidth, halfHeight }) => [
      made({
        y: halfHeight,
        halfWidth: halfWidth / 2,
        spread: 26,
        speed: 6,
        speedVariation: 0.45,
        size: 0.13,
        life: 1.9,
        temperature: 0,
        duration: 0.1,
        count: 34,
      }),
    ],
  },
  /** A gust carries a streak of smoke to the side. */
  whoosh: {
    isAround: false,
    direction: 0,
    emissions: ({ halfWidth, halfHeight }) => [
      made({
        halfWidth,
        halfHeight: Math.max(halfHeight, 0.08),
        direction: 0,
        spread: 5,
        speed: 9,
        speedVariation: 0.5,
        size: 0.16,
        life: 0.95,
        temperature: 1.01,
        duration: 0.35,
        count: 44 * crowd({ halfWidth: 0, halfHeight }),
      }),
    ],
  },
  /** An explosion: a ring along the ground, a stem, and a large ball of smoke that climbs. */
  boom: {
    isAround: false,
    direction: 90,
    emissions: ({ halfWidth, halfHeight }) => [
      made({
        halfWidth,
        halfHeight,
        speed: 2.6,
        speedVariation: 0.7,
        size: 0.34,
        life: 2.5,
        temperature: 1.43,
        count: 26,
      }),
      made({
        shape: 'ground',
        y: -halfHeight,
        halfWidth: 0.15,
        spread: 86,
        speed: 6.5 + DRAG * halfWidth,
        speedVariation: 0.25,
        size: 0.22,
        life: 1.5,
        count: 22,
      }),
      made({
        spread: 20,
        speed: 1.6,
        size: 0.24,
        life: 1.8,
        temperature: 1.3,
        delay: 0.1,
        duration: 0.6,
        count: 14,
      }),
    ],
  },
  /** The whole area of the target becomes smoke, which rises. */
  vanish: {
    isAround: false,
    direction: 90,
    emissions: (extent) => [
      made({
        ...extent,
        spread: 50,
        speed: 0.5,
        size: 0.24,
        life: 1.6,
        temperature: 1.25,
        duration: 0.35,
        count: 20 * (crowd(extent) + 6 * extent.halfWidth * extent.halfHeight),
      }),
    ],
  },
  /** Smoke gathers from both sides, and leaves the target behind. */
  appear: {
    isAround: false,
    direction: 90,
    emissions: ({ halfWidth, halfHeight }) =>
      [-1, 1].map((side) =>
        made({
          x: side * (halfWidth + 0.8),
          halfHeight: halfHeight + 0.25,
          direction: side < 0 ? 0 : 180,
          spread: 12,
          // Most of it is over the middle of a small target when that fades in, and comes to rest a little beyond.
          speed: DRAG * (1.05 + 0.7 * halfWidth),
          speedVariation: Math.min(0.9, (0.1 + halfWidth / 2) / (1 + halfWidth / 2)),
          size: 0.23,
          life: 1.3,
          lifeVariation: 0.15,
          duration: 0.25,
          count: 11 * crowd({ halfWidth, halfHeight }),
        }),
      ),
  },
  /** Small puffs leave the target, form its word, and drift away. */
  form: {
    isAround: false,
    direction: 90,
    emissions: (extent, text) => {
      const { height } = sizeOfWord(text, extent.halfWidth);
      return [
        made({
          ...extent,
          speed: 0.8,
          // A stroke is as wide as three puffs.
          size: 0.1 * height,
          sizeVariation: 0.25,
          // They shrink in the second half of their lives.
          life: 1.9 * HOLD,
          lifeVariation: 0.12,
          temperature: 1.1,
          duration: 0.4,
          count: 80 + 50 * text.length,
        }),
      ];
    },
  },
};

export type Asked = Pick<PuffOptions, 'text' | 'count' | 'size' | 'spread' | 'direction' | 'speed' | 'duration'>;

/** Whether the page's element is an obstacle for the smoke of an effect. */
export function flowsAround(effect: Effect): boolean {
  return designs[effect].isAround;
}

/** The emitters of an effect with these options. */
export function emissionsOf(effect: Effect, extent: Extent, asked: Asked): Emission[] {
  const { emissions, direction: usual } = designs[effect];
  const { size = 1, spread, direction = usual, speed = 1, duration } = asked;
  const all = emissions(extent, asked.text ?? '').map((each) => lasting(each, duration));
  const total = all.reduce((sum, each) => sum + each.count, 0);
  const share = Math.min(asked.count ?? total, MAX_COUNT) / total;
  return all.map((each) => {
    const isDisc = each.shape !== 'box';
    return {
      ...each,
      direction: isDisc ? undefined : each.direction! + direction - usual,
      spread: isDisc || spread === undefined ? each.spread : spread / 2,
      speed: Math.min(each.speed * speed * Math.sqrt(size), MAX_SPEED),
      size: each.size * size,
      count: Math.max(1, Math.round(each.count * share)),
    };
  });
}

/** An emission that lasts as long as asked, with as many puffs in each second. */
function lasting(emission: Emission, asked: number | undefined): Emission {
  if (asked === undefined) return emission;
  const duration = asked < MIN_DURATION ? 0 : asked;
  const { count } = emission;
  if (duration <= emission.duration) return { ...emission, duration };
  return {
    ...emission,
    duration,
    count: (count * duration) / Math.max(emission.duration, Math.min(BURST_SECONDS, duration)),
  };
}
