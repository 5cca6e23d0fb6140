import type { Keyframe } from './order.ts';

/**
 * Camera values at a time: linear between two keyframes, by the shorter way around for `camera.azimuth`, and constant
 * before the first and after the last one. A key that a keyframe omits keeps the value between its neighbours.
 * @param keyframes in the order of their times
 */
export function cameraAt(keyframes: readonly Keyframe[], seconds: number): Record<string, number> {
  const keys = new Set(keyframes.flatMap(({ values }) => Object.keys(values)));
  return Object.fromEntries([...keys].map((key) => [key, valueAt(keyframes, key, seconds)]));
}

function valueAt(keyframes: readonly Keyframe[], key: string, seconds: number): number {
  const own = keyframes.filter(({ values }) => key in values);
  const after = own.findIndex((keyframe) => keyframe.seconds > seconds);
  if (after === 0) return own[0].values[key];
  if (after < 0) return own.at(-1)!.values[key];
  const [from, to] = [own[after - 1], own[after]];
  const share = (seconds - from.seconds) / (to.seconds - from.seconds);
  const [start, way] = [from.values[key], to.values[key] - from.values[key]];
  if (key !== 'camera.azimuth') return start + share * way;
  return wrapped(start + share * wrapped(way));
}

/** To degrees from -180 to 180. */
function wrapped(degrees: number): number {
  return degrees - 360 * Math.round(degrees / 360);
}
