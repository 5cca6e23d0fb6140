/** What a lane shows between its keyframes: a curve of numbers, a strip of colours, or blocks of other values. */
import { valueAt, type Keyframe, type Lane } from '../../internal.ts';
import { findParameter } from '../../preset.ts';
import { create, createSvg } from '../ui/dom.ts';
import { valueText } from './words.ts';

/** Points of an eased curve between two keyframes. */
const SAMPLES = 20;

/** Elements behind the keyframes of a lane, placed by the step variables of the sheet. */
export function shapesOf(lane: Lane): readonly Element[] {
  const row = findParameter(lane.key)!;
  if (row.kind === 'number' || row.kind === 'integer') return [curveOf(lane)];
  return lane.keyframes.slice(0, -1).map((keyframe, at) => {
    const next = lane.keyframes[at + 1];
    const block = create('div', { class: `timeline-block block-${row.kind}` });
    block.style.setProperty('--step', String(keyframe.step));
    block.style.setProperty('--steps', String(next.step - keyframe.step));
    if (row.kind === 'color') block.style.background = gradientOf(lane, keyframe, next);
    else if (row.kind === 'choice' || row.kind === 'toggle') block.textContent = valueText(row, keyframe.value);
    return block;
  });
}

/** A polyline over the steps of the lane, scaled to its height. */
function curveOf(lane: Lane): Element {
  const { keyframes } = lane;
  const [first, last] = [keyframes[0].step, keyframes[keyframes.length - 1].step];
  const points = keyframes.flatMap((keyframe, at) => {
    const next = keyframes[at + 1];
    return next ? timesOf(keyframe, next).map((time) => [time, Number(valueAt(lane, time))] as const) : [];
  });
  points.push([last, Number(keyframes[keyframes.length - 1].value)]);
  const values = points.map(([, value]) => value);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const y = (value: number) => (high === low ? 0.5 : 1 - (value - low) / (high - low));
  const text = points.map(([time, value]) => `${time - first},${y(value)}`).join(' ');
  const line = createSvg('polyline', { points: text, 'vector-effect': 'non-scaling-stroke' });
  const box = `0 0 ${Math.max(1, last - first)} 1`;
  const drawing = createSvg('svg', { class: 'timeline-curve', viewBox: box, preserveAspectRatio: 'none' }, line);
  drawing.style.setProperty('--step', String(first));
  drawing.style.setProperty('--steps', String(last - first));
  return drawing;
}

/** The times from a keyframe to the next that the curve needs, the last one just before the next. */
function timesOf({ step, easing }: Keyframe, next: Keyframe): readonly number[] {
  const steps = next.step - step;
  if (easing === 'linear') return [step];
  if (easing === 'hold') return [step, next.step - 1e-3];
  return Array.from({ length: SAMPLES }, (_, at) => step + (at / SAMPLES) * steps);
}

function gradientOf(lane: Lane, keyframe: Keyframe, next: Keyframe): string {
  if (keyframe.easing === 'hold') return String(keyframe.value);
  const times = [...timesOf(keyframe, next), next.step];
  const stops = times.map((time) => {
    const share = (time - keyframe.step) / (next.step - keyframe.step);
    return `${valueAt(lane, time)} ${(100 * share).toFixed(1)}%`;
  });
  return `linear-gradient(90deg, ${stops.join(', ')})`;
}
