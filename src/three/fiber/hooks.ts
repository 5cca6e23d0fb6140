import type { ThreeElements } from '@react-three/fiber';
import { useLayoutEffect, useRef, useState, type Ref, type RefObject } from 'react';

const PLACEMENT = ['name', 'position', 'quaternion', 'rotation', 'scale', 'visible'] as const;

/** Props of a group. */
export type PlacementProps = Pick<ThreeElements['group'], (typeof PLACEMENT)[number]>;

/** The props of a group that are given, and the other props. */
export function placementIn(props: object): [object, object] {
  const entries = Object.entries(props);
  const isPlacement = (key: string) => (PLACEMENT as readonly string[]).includes(key);
  const placement = entries.filter(([key, value]) => isPlacement(key) && value !== undefined);
  return [Object.fromEntries(placement), Object.fromEntries(entries.filter(([key]) => !isPlacement(key)))];
}

/** An object, or a reference to one that exists when effects run. */
export type Target<Kind> = Kind | RefObject<Kind | null>;

export function targetOf<Kind extends object>(target: Target<Kind>): Kind {
  return 'current' in target ? target.current! : target;
}

/** A reference to the value of the latest render, for code that runs later. */
export function useLatest<Kind>(value: Kind): RefObject<Kind> {
  const latest = useRef(value);
  useLayoutEffect(() => {
    latest.current = value;
  });
  return latest;
}

/** The options of an earlier render as long as they are the same, without those that are undefined. */
export function useStable<Options extends object>(options: Options): Options {
  const given = Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as Options;
  const [stable, setStable] = useState(given);
  if (areSame(stable, given)) return stable;
  setStable(given);
  return given;
}

/** Sets a reference of any kind. */
export function assignRef<Kind>(ref: Ref<Kind> | undefined, value: Kind | null): void {
  if (typeof ref === 'function') ref(value);
  else if (ref) ref.current = value;
}

/** Whether options have the same keys and values. Vectors and other plain objects are compared by their own values. */
function areSame(one: object, other: object): boolean {
  const entries = Object.entries(one);
  if (entries.length !== Object.keys(other).length) return false;
  return entries.every(([key, value]) => {
    const against: unknown = other[key as never];
    return Object.is(value, against) || (isPlain(value) && isPlain(against) && areSame(value, against));
  });
}

function isPlain(value: unknown): value is object {
  return typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;
}
