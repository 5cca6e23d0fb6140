import type { PresetName } from '../../../parameters/valueTypes.ts';
import { selfOf } from '../../../base/onSelf.ts';
import { names } from './names.ts';

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

/**
 * Defines a property on a class of elements for each attribute. Properties and attributes reflect each other, also on a
 * Proxy of an element for which `runOnSelf` was called.
 */
export function defineProperties(prototype: HTMLElement): void {
  const flags = FLAGS.map((name) => [name, flag(name)]);
  const texts = TEXTS.map((name) => [camelCase(name), parameter(name, true)]);
  const parameters = names.map(({ property, attribute, isText }) => [property, parameter(attribute, isText)]);
  Object.defineProperties(prototype, Object.fromEntries([...flags, ...texts, ...parameters]));
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

function camelCase(name: string): string {
  return name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
}

function flag(name: string): PropertyDescriptor {
  return {
    configurable: true,
    enumerable: true,
    get(this: HTMLElement) {
      return selfOf(this).hasAttribute(name);
    },
    set(this: HTMLElement, isOn: unknown) {
      // Also notifies of an attribute that is there: the page pauses smoke that the user has started.
      if (isOn) selfOf(this).setAttribute(name, '');
      else selfOf(this).removeAttribute(name);
    },
  };
}

function parameter(attribute: string, isText: boolean): PropertyDescriptor {
  return {
    configurable: true,
    enumerable: true,
    get(this: HTMLElement) {
      const text = selfOf(this).getAttribute(attribute);
      return text === null ? undefined : isText ? text : Number(text);
    },
    set(this: HTMLElement, value: Given) {
      if (value === null || value === undefined) selfOf(this).removeAttribute(attribute);
      else selfOf(this).setAttribute(attribute, typeof value === 'boolean' ? String(Number(value)) : String(value));
    },
  };
}
