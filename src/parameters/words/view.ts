import type { cameraRows, lightRows } from '../rows/view.ts';
import type { WordsOf } from './words.ts';

/** What the panel says of light and camera. */
export const viewWords: WordsOf<[...typeof lightRows, ...typeof cameraRows]> = {
  'light.kind': {
    label: 'Light',
    text: 'The sun is a directional light; a lamp is a point light, and shadows spread away from it.',
    options: { sun: 'Sun', lamp: 'Lamp' },
  },
  'light.azimuth': { label: 'Direction', text: 'Azimuth of the light: 0 is the front, 90 the right.', step: 1 },
  'light.elevation': { label: 'Height', text: 'Elevation of the light: 90 is straight above.', step: 1 },
  'light.distance': {
    label: 'Distance',
    text: 'Distance of a lamp from the centre of the scene; the sun ignores it.',
    step: 0.1,
    slider: 'fine',
  },
  'camera.azimuth': {
    label: 'Camera direction',
    text: 'Azimuth of the camera: 0 is the front, 90 the right.',
    step: 1,
  },
  'camera.elevation': { label: 'Camera elevation', text: 'Elevation of the camera: 0 is level.', step: 1 },
  'camera.distance': {
    label: 'Camera distance',
    text: 'Distance of the camera from its target.',
    step: 0.1,
    slider: 'fine',
  },
  'camera.target.x': {
    label: 'Camera target x',
    text: "Distance of the camera's target right of the scene's centre.",
    step: 0.05,
    slider: 'fine',
  },
  'camera.target.y': {
    label: 'Camera target y',
    text: "Distance of the camera's target above the ground.",
    step: 0.05,
    slider: 'fine',
  },
  'camera.target.z': {
    label: 'Camera target z',
    text: "Distance of the camera's target in front of the scene's centre.",
    step: 0.05,
    slider: 'fine',
  },
};
