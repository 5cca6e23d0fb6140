import type { Values } from '../../parameters/parameter.ts';
import { hexOfComputed } from '../cssColor.ts';

/** The values that a CSS property sets. Ramps have colours of their own, so a colour of the smoke replaces them. */
const PROPERTIES: Readonly<Record<string, (color: string) => Values>> = {
  '--cartoon-smoke-color': (color) => ({ 'style.smokeColor': color, 'style.ramp': '', 'style.ageRamp': '' }),
  '--cartoon-smoke-ink': (color) => ({ 'style.inkColor': color }),
  '--cartoon-smoke-backdrop': (color) => ({ 'style.backdrop': `0:${color.slice(1)},1:${color.slice(1)}` }),
};

/**
 * The colours that the style sheets of the page set by custom properties. CSS has no event for changed custom properties.
 * Hidden elements use them as background colours with a transition, whose end is an event, whatever the reason: a class, a
 * media query or a theme.
 */
export class CssColors {
  private readonly probes: readonly (readonly [probe: HTMLElement, valuesOf: (color: string) => Values])[];

  /** @param root of the shadow tree: `currentColor` is the colour of the element, which its frame replaces */
  constructor(root: Node) {
    const canMix = CSS.supports('color', 'color-mix(in srgb, red, red)');
    this.probes = Object.entries(PROPERTIES).map(([name, valuesOf]) => {
      const probe = document.createElement('i');
      // Browsers that mix colours compute sRGB for all of them.
      const color = canMix ? `color-mix(in srgb, var(${name}), var(${name}))` : `var(${name})`;
      probe.style.cssText = `all: initial; position: absolute; visibility: hidden; forced-color-adjust: none;
        color: inherit; color-scheme: inherit; background-color: ${color}; transition: background-color 1ms`;
      root.appendChild(probe);
      return [probe, valuesOf];
    });
  }

  /** The values of the properties that have a colour. */
  values(): Values {
    const set = this.probes.flatMap(([probe, valuesOf]) => {
      const computed = getComputedStyle(probe).backgroundColor;
      return isTransparent(computed) ? [] : [valuesOf(hexOfComputed(computed))];
    });
    return Object.assign({}, ...set) as Values;
  }

  /** Calls `update` after a colour has changed. */
  watch(update: () => void): void {
    for (const [probe] of this.probes) probe.addEventListener('transitionend', update);
  }

  dispose(): void {
    for (const [probe] of this.probes) probe.remove();
  }
}

/** Properties that are not set, and those that are not colours, have the initial background colour. */
function isTransparent(computed: string): boolean {
  return /(,|\/) ?0(\.0*)?\)$/.test(computed);
}
