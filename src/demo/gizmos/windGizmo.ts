import type { Stage } from '../../index.ts';
import type { Values } from '../../preset.ts';
import { clampTo, type Gizmo } from './gizmo.ts';
import type { Changes } from '../editor/editor.ts';
import type { Direction } from '../input/keyboard.ts';
import { strings } from '../strings.ts';

type Vector = readonly [x: number, y: number, z: number];

const KEYS = ['forces.wind.x', 'forces.wind.y', 'forces.wind.z'] as const;
const PIXELS_PER_SPEED = 40;
/** Start of the arrow, as fractions of the overlay's size. */
const BEGIN = { x: 0.2, y: 0.66 };

/** Handle of the wind: the head of an arrow. */
export class WindGizmo implements Gizmo {
  readonly key = 'wind';
  readonly icon = 'wind';
  private readonly sight: () => Stage['sight'];
  private readonly size: () => { width: number; height: number };

  constructor(sight: () => Stage['sight'], size: () => { width: number; height: number }) {
    this.sight = sight;
    this.size = size;
  }

  describe(values: Values): string {
    return strings.gizmos.wind(Math.hypot(...velocityOf(values)));
  }

  get begin(): { x: number; y: number } {
    const { width, height } = this.size();
    return { x: BEGIN.x * width, y: BEGIN.y * height };
  }

  /** Clamps the head to the overlay, for strong wind. */
  place(values: Values): { x: number; y: number } {
    const { width, height } = this.size();
    const [right, up] = this.sight().across(velocityOf(values));
    const { x, y } = this.begin;
    return {
      x: Math.min(Math.max(x + right * PIXELS_PER_SPEED, 0), width),
      y: Math.min(Math.max(y - up * PIXELS_PER_SPEED, 0), height),
    };
  }

  move(from: Values, [right, up, near]: Direction): Changes {
    const speed = (pixels: number) => pixels / PIXELS_PER_SPEED;
    const added = this.sight().along([speed(right), speed(up), speed(near)]);
    const velocity = velocityOf(from);
    return Object.fromEntries(KEYS.map((key, axis) => [key, clampTo(key, velocity[axis] + added[axis], 2)]));
  }
}

function velocityOf(values: Values): Vector {
  const [x, y, z] = KEYS.map((key) => Number(values[key]));
  return [x, y, z];
}
