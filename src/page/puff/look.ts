/** Colours, ink and light of the smoke. */
import { fetchValues } from '../../parameters/byScene/fetchValues.ts';
import type { Value, Values } from '../../parameters/parameter.ts';
import { defaults } from '../../parameters/values.ts';
import { hexOfComputed } from '../cssColor.ts';

const USUAL = 'air';
/** Number of tints of the simulator. Not imported: the module of constants is in the file of the renderer. */
export const TINT_LIMIT = 3;

/**
 * The values of a look, by flat key.
 * @param preset name of a preset, a share link, or its hash
 * @throws ParameterError for an unknown preset, LoadError when it cannot be fetched
 */
export async function lookOf(preset = USUAL): Promise<Values> {
  return lookIn(await fetchValues(preset));
}

/** Only values that every preset has, so that a look replaces all of the one before. */
export function lookIn(values: Values): Values {
  const usual = defaults();
  return Object.fromEntries(Object.entries(values).filter(([key]) => isOfLook(key) && key in usual));
}

/** The tints of the simulator, handed out to colours. */
export class Tints {
  /** The latest last. */
  private colors: string[] = [];
  private indices: number[] = [];

  /**
   * The number of a colour's tint; 0 without a colour. A new colour takes the tint of the oldest one.
   * @param values receives the colour
   */
  acquireTint(color: string | undefined, values: Record<string, Value>): number {
    if (color === undefined) return 0;
    const known = this.colors.indexOf(color);
    const tint = known >= 0 ? this.indices[known] : this.next();
    this.forget(tint);
    this.colors.push(color);
    this.indices.push(tint);
    values[`style.tint${tint}`] = color;
    return tint;
  }

  private next(): number {
    return this.indices.length < TINT_LIMIT ? this.indices.length + 1 : this.indices[0];
  }

  private forget(tint: number): void {
    const index = this.indices.indexOf(tint);
    if (index < 0) return;
    this.indices.splice(index, 1);
    this.colors.splice(index, 1);
  }
}

/**
 * `#rrggbb` of a CSS colour, without its opacity. The CSS parser computes it: browsers falsify the pixels of canvases
 * against fingerprinting.
 * @param element whose `currentColor` and custom properties apply
 */
export function hexOf(color: string, element: Element = document.documentElement): string {
  const probe = document.createElement('i');
  const given = getComputedStyle(element);
  const { style } = probe;
  style.cssText = 'all: initial; display: none; forced-color-adjust: none';
  for (const [name] of color.matchAll(/--[\w-]+/g)) style.setProperty(name, given.getPropertyValue(name));
  style.color = given.color;
  style.colorScheme = given.colorScheme;
  style.backgroundColor = color;
  // Browsers without color-mix() ignore this line, and compute rgb() for all colours that they know.
  style.backgroundColor = `color-mix(in srgb, ${color}, ${color})`;
  document.documentElement.append(probe);
  const computed = getComputedStyle(probe).backgroundColor;
  probe.remove();
  return hexOfComputed(computed);
}

/** What calls take from a preset. The rest of it is motion, which the effects have. */
const PARTS = ['style.', 'light.', 'puff.'];

/** Whether a parameter is part of the look. */
export function isOfLook(key: string): boolean {
  return PARTS.some((part) => key.startsWith(part));
}
