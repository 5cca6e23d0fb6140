/** The rows of the table for its list of vortices, `vortices.0.circulation` and so on. */
import type { NumberParameter } from './parameter.ts';

type Row = Pick<NumberParameter, 'label' | 'text' | 'min' | 'max' | 'step' | 'default' | 'unit' | 'slider'>;

const position = { min: -20, max: 20, step: 0.05, default: 0, unit: 'm', slider: 'fine' } as const;
const axis = { min: -1, max: 1, step: 0.05, default: 0, unit: '', slider: 'even' } as const;

/** Names behind `vortices.#.` with their ranges. The axis is a direction; its length does not matter. */
const fields: Readonly<Record<string, Row>> = {
  circulation: {
    min: -20,
    max: 20,
    step: 0.05,
    default: 0,
    unit: 'm\u00b2/s',
    slider: 'fine',
    label: 'Circulation',
    text: 'Strength and sense of the swirl; 0 takes this vortex away.',
  },
  coreRadius: {
    min: 0.01,
    max: 5,
    step: 0.01,
    default: 0.25,
    unit: 'm',
    slider: 'fine',
    label: 'Core',
    text: 'Radius of the calm middle, where the swirl is fastest.',
  },
  reach: {
    min: 0.05,
    max: 20,
    step: 0.05,
    default: 2,
    unit: 'm',
    slider: 'fine',
    label: 'Reach',
    text: 'Distance from the axis at which the swirl has faded to nothing.',
  },
  'position.x': { ...position, label: 'Place x', text: 'A point on the axis, to the right.' },
  'position.y': { ...position, default: 1, label: 'Place y', text: 'A point on the axis, upwards.' },
  'position.z': { ...position, label: 'Place z', text: 'A point on the axis, towards the viewer.' },
  'axis.x': { ...axis, label: 'Axis x', text: 'Part of the axis that points to the right.' },
  'axis.y': { ...axis, label: 'Axis y', text: 'Part of the axis that points upwards.' },
  'axis.z': { ...axis, default: 1, label: 'Axis z', text: 'Part of the axis that points towards the viewer.' },
};

/** Rows for `count` vortices, all without circulation until a preset gives them some. */
export function vortexParameters(count: number): NumberParameter[] {
  return Array.from({ length: count }, (_, index) => vortex(index)).flat();
}

function vortex(index: number): NumberParameter[] {
  const group = `vortices.${index}`;
  return Object.entries(fields).map(([name, row]) => ({
    kind: 'number',
    key: `${group}.${name}`,
    group,
    reader: 'simulator',
    ...row,
  }));
}
