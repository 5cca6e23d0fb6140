/** Texts of the panel of the timeline, which loads with it. */
import { findParameter, groups, itemGroups, type Parameter, type Value } from '../../preset.ts';
import { emitterOf, STEPS_PER_SECOND, unitOf, type Grid } from './model.ts';

export const words = {
  title: 'Timeline',
  close: 'Close the timeline',
  toolbar: 'Timeline tools',
  record: 'Record',
  recordTitle: 'Record: changes of parameters and of the camera become keyframes',
  recording: 'Recording. Changes of parameters become keyframes.',
  recorded: 'Recording is off.',
  previous: 'Previous keyframe',
  next: 'Next keyframe',
  addBurst: 'Add a burst',
  copy: 'Copy',
  paste: 'Paste at the playhead',
  duplicate: 'Duplicate',
  remove: 'Delete',
  select: 'Select with a box',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  fit: 'Show all',
  snap: 'Snap',
  grids: { 60: '60 fps', 30: '30 fps', 25: '25 fps', 24: '24 fps', 12: '12 fps', beats: 'Beats' } as const,
  beats: 'Beats per minute',
  length: 'Length',
  seconds: 's',
  loop: 'Loop',
  playhead: 'Playhead',
  end: 'End of the timeline',
  lanes: 'Lanes',
  how: 'Left and Right move the selected keyframes by a frame, with Shift by a second. Page Up and Page Down go to the previous and the next keyframe, Home and End to the first and the last one, Up and Down to other lanes; with Shift they select. Enter edits the value. Delete removes. K sets a keyframe at the playhead. Ctrl with C, X, V, D and A copies, cuts, pastes, duplicates and selects all.',
  empty: {
    title: 'Nothing is animated yet.',
    steps: [
      'Press \u25c6 beside a parameter: it gets a keyframe at the playhead.',
      'Move the playhead and change the parameter with another \u25c6.',
      'Or press Record, and change anything while the smoke plays.',
    ],
    parameters: 'Show the parameters',
    record: 'Record',
    burst: 'Add a burst',
  },
  rowAdd: (label: string) => `Set a keyframe of ${label}`,
  rowRemove: (label: string) => `Remove the keyframe of ${label}`,
  rowWhy: (label: string, why: string) => `${label} has no keyframes. ${why}`,
  laneKeyframe: (label: string, has: boolean) =>
    has ? `Remove the keyframe of ${label} at the playhead` : `Set a keyframe of ${label} at the playhead`,
  laneBurst: (label: string) => `Add a burst at the playhead, ${label}`,
  laneAll: (label: string) => `Select all of ${label}`,
  laneRemove: (label: string) => `Remove all of ${label}`,
  lane: (label: string, number: number, isBursts: boolean) =>
    `${label}, ${number} ${isBursts ? 'burst' : 'keyframe'}${number === 1 ? '' : 's'}`,
  keyframe: 'keyframe',
  burst: 'burst',
  selected: 'selected',
  bursts: (emitter: number) => (emitter === 0 ? 'Bursts' : `Bursts ${emitter + 1}`),
  emitterOf: (emitter: number) => `Emitter ${emitter + 1}`,
  puffs: (number: number) => `${number} puffs`,
  // Of the selection.
  selection: 'Selection',
  time: 'Time',
  value: 'Value',
  burstTitle: 'Burst',
  count: 'Puffs',
  emitter: 'Emitter',
  easing: 'Easing to the next keyframe',
  easings: { hold: 'Hold', linear: 'Linear', ease: 'Ease', easeIn: 'Ease in', easeOut: 'Ease out' } as const,
  curve: 'Curve of the easing',
  handle: (number: number, x: number, y: number) =>
    `Handle ${number}: ${Math.round(100 * x)} % of the time, ${Math.round(100 * y)} % of the way`,
  noSelection: 'Select a keyframe to change its time, value and easing.',
  several: (keyframes: number, bursts: number) =>
    [count(keyframes, 'keyframe'), count(bursts, 'burst')].filter(Boolean).join(', '),
  // Announcements.
  added: (label: string, time: string) => `Keyframe of ${label} at ${time}.`,
  burstAdded: (time: string) => `Burst at ${time}.`,
  removed: (number: number) => `${number} removed.`,
  moved: (time: string) => `Moved to ${time}.`,
  copied: (number: number) => `${number} copied.`,
  pasted: (number: number) => `${number} pasted.`,
  chosen: (number: number) => (number === 0 ? 'Nothing is selected.' : `${number} selected.`),
  full: (number: number) =>
    `${number} could not be added. A timeline has at most 64 parameters, 512 keyframes and 256 bursts, within ten minutes.`,
  cannot: (label: string, why: string) => `${label} cannot be animated. ${why}`,
} as const;

function count(number: number, what: string): string {
  return number === 0 ? '' : `${number} ${what}${number === 1 ? '' : 's'}`;
}

/** The name of a lane, and of the group of its parameter. */
export function laneLabel(lane: string): { readonly label: string; readonly group: string } {
  const emitter = emitterOf(lane);
  if (emitter !== undefined) return { label: words.bursts(emitter), group: words.emitterOf(emitter) };
  const { label, group } = findParameter(lane)!;
  const found = groups.find(({ key }) => key === group) ?? itemGroups.find(({ key }) => key === group);
  return { label, group: found?.label ?? '' };
}

/** A value as text. */
export function valueText(parameter: Parameter, value: Value, hasUnit = true): string {
  switch (parameter.kind) {
    case 'toggle':
      return value === 1 ? 'on' : 'off';
    case 'choice':
      return parameter.options.find((option) => option.value === value)?.label ?? String(value);
    case 'number':
    case 'integer':
      return `${Number(Number(value).toPrecision(4))} ${hasUnit ? parameter.unit : ''}`.trim();
    case 'color':
      return String(value);
    default:
      return value === '' ? 'none' : 'own';
  }
}

/** A time with the units of a grid, such as `2.50 s`, `2 s 12 f` or `beat 5`. */
export function timeText(step: number, grid: Grid): string {
  if (grid.name === 'beats') return `beat ${Number((step / unitOf(grid)).toFixed(2)) + 1}`;
  const seconds = step / STEPS_PER_SECOND;
  if (grid.rate === STEPS_PER_SECOND) return `${seconds.toFixed(2)} s`;
  const frames = Math.round(step / unitOf(grid));
  return `${Math.floor(frames / grid.rate)} s ${frames % grid.rate} f`;
}
