import type { NumberParameter, Parameter } from '../parameter.ts';
import { quantity, type Quantity } from './row.ts';

/** Position and target of the camera. */
export const cameraRows: readonly Parameter[] = [
  eye('azimuth', {
    min: -180,
    max: 180,
    step: 1,
    default: 8.6,
    unit: '\u00b0',
    label: 'Camera direction',
    text: 'Azimuth of the camera: 0 is the front, 90 the right.',
  }),
  eye('elevation', {
    min: -5,
    max: 88,
    step: 1,
    default: 9.2,
    unit: '\u00b0',
    label: 'Camera elevation',
    text: 'Elevation of the camera: 0 is level.',
  }),
  eye('distance', {
    min: 0.3,
    max: 40,
    step: 0.1,
    default: 6.3,
    unit: 'm',
    slider: 'fine',
    label: 'Camera distance',
    text: 'Distance of the camera from its target.',
  }),
  eyeTarget('x', 0.15),
  eyeTarget('y', 1.5),
  eyeTarget('z', 0),
];

/** A camera parameter. Without a value it follows the scene's camera and its animation. */
function eye(name: string, rest: Quantity): NumberParameter {
  return { ...quantity(`camera.${name}`, 'camera', 'camera', rest), isOptional: true };
}

function eyeTarget(axis: 'x' | 'y' | 'z', initial: number): NumberParameter {
  const range = { min: -50, max: 50, step: 0.05, unit: 'm', slider: 'fine' } as const;
  const text = { x: "right of the scene's centre", y: 'above the ground', z: "in front of the scene's centre" }[axis];
  const label = `Camera target ${axis}`;
  return eye(`target.${axis}`, {
    ...range,
    label,
    text: `Distance of the camera's target ${text}.`,
    default: initial,
  });
}
