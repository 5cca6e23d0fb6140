import { names } from './names.ts';

/** Attributes besides the parameters. */
export const FLAGS = ['paused', 'transparent', 'interactive'] as const;
/** Those about things of the page in the smoke. */
export const OF_PAGE: readonly string[] = ['collide', 'emit-from', 'emit-on'];
/** When smoke rises from an element of the page. */
export const EMIT_ON = ['always', 'hover', 'click'] as const;
/** What the button says to those who do not see it. */
export const LABELS: readonly string[] = ['label-play', 'label-pause'];
export const TEXTS = ['preset', 'src', 'start', 'alt', 'thread', 'loading', ...LABELS, ...OF_PAGE];

/** Values as properties take them; without one the attribute goes, and the preset decides. */
type Given = number | string | boolean | null | undefined;

/** Gives a class of elements a property for each attribute; what is set there stands in the attribute, and the other way round. */
export function defineProperties(prototype: HTMLElement): void {
  const flags = FLAGS.map((name) => [name, flag(name)]);
  const texts = TEXTS.map((name) => [camelCase(name), parameter(name, true)]);
  const parameters = names.map(({ property, attribute, isText }) => [property, parameter(attribute, isText)]);
  Object.defineProperties(prototype, Object.fromEntries([...flags, ...texts, ...parameters]));
}

/** What was set on an element before its class was known would lie over the properties of the class: it is set again. */
export function takeUpEarlier(element: HTMLElement): void {
  for (const [name, value] of Object.entries(element)) {
    if (!(name in Object.getPrototypeOf(element))) continue;
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}

function camelCase(name: string): string {
  return name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
}

function flag(name: string): PropertyDescriptor {
  return {
    configurable: true,
    enumerable: true,
    get(this: HTMLElement) {
      return this.hasAttribute(name);
    },
    set(this: HTMLElement, isOn: unknown) {
      this.toggleAttribute(name, Boolean(isOn));
    },
  };
}

function parameter(attribute: string, isText: boolean): PropertyDescriptor {
  return {
    configurable: true,
    enumerable: true,
    get(this: HTMLElement) {
      const text = this.getAttribute(attribute);
      return text === null ? undefined : isText ? text : Number(text);
    },
    set(this: HTMLElement, value: Given) {
      if (value === null || value === undefined) this.removeAttribute(attribute);
      else this.setAttribute(attribute, typeof value === 'boolean' ? String(Number(value)) : String(value));
    },
  };
}
