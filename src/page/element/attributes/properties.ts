import type { PresetName } from '../../../parameters/valueTypes.ts';
import { onSelf } from '../../../base/onSelf.ts';
import { camelCase, names } from './names.ts';

/** Boolean attributes besides the parameters. */
export const FLAGS = ['paused', 'transparent', 'interactive'] as const;
/** Attributes that connect elements of the page with the smoke. */
export const OF_PAGE: readonly string[] = ['collide', 'emit-from', 'emit-on'];
/** When an element of the page emits smoke. */
export const EMIT_ON = ['always', 'hover', 'click'] as const;
/** Accessible names of the button. */
export const LABELS: readonly string[] = ['label-play', 'label-pause', 'label-restart'];
export const TEXTS = ['preset', 'src', 'start', 'alt', 'thread', 'loading', ...LABELS, ...OF_PAGE];

/** The properties besides the parameters. */
export interface ElementProperties {
  paused: boolean;
  transparent: boolean;
  interactive: boolean;
  get preset(): string | undefined;
  set preset(name: PresetName | null | undefined);
  src: string | undefined;
  start: string | undefined;
  alt: string | undefined;
  labelPlay: string | undefined;
  labelPause: string | undefined;
  labelRestart: string | undefined;
  thread: string | undefined;
  loading: string | undefined;
  collide: string | undefined;
  emitFrom: string | undefined;
  emitOn: string | undefined;
}

/** Value of a property. `null` and `undefined` remove the attribute, so that the preset applies. */
type Given = number | string | boolean | null | undefined;

interface Accessors {
  readonly get: (this: HTMLElement) => Given;
  readonly set: (this: HTMLElement, value: Given) => void;
}

/**
 * Defines a property on a class of elements for each attribute. Properties and attributes reflect each other, also on a
 * Proxy of an element.
 */
export function defineProperties(prototype: HTMLElement): void {
  const define = (name: string, { get, set }: Accessors) =>
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get: onSelf(get),
      set: onSelf(set),
    });
  for (const name of FLAGS) define(name, flag(name));
  for (const name of TEXTS) define(camelCase(name), parameter(name, true));
  for (const { property, attribute, isText } of names) define(property, parameter(attribute, isText));
}

/**
 * Properties that were set before the element was upgraded shadow the accessors of the class. Sets them again through
 * the accessors.
 */
export function upgradeProperties(element: HTMLElement): void {
  for (const [name, value] of Object.entries(element)) {
    if (!(name in Object.getPrototypeOf(element))) continue;
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}

function flag(name: string): Accessors {
  return {
    get(this: HTMLElement) {
      return this.hasAttribute(name);
    },
    set(this: HTMLElement, isOn: unknown) {
      // Also notifies of an attribute that is there: the page pauses smoke that the user has started.
      if (isOn) this.setAttribute(name, '');
      else this.removeAttribute(name);
    },
  };
}

function parameter(attribute: string, isText: boolean): Accessors {
  return {
    get(this: HTMLElement) {
      const text = this.getAttribute(attribute);
      return text === null ? undefined : isText ? text : Number(text);
    },
    set(this: HTMLElement, value: Given) {
      if (value === null || value === undefined) this.removeAttribute(attribute);
      else this.setAttribute(attribute, String(typeof value === 'boolean' ? Number(value) : value));
    },
  };
}
