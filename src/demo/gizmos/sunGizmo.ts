import { findParameter, type Values } from '../../preset.ts';
import { clampTo, type Gizmo } from './gizmo.ts';
import type { Changes } from '../editor/editor.ts';
import type { Direction } from '../input/keyboard.ts';
import { strings } from '../strings.ts';

/** The sky over the overlay, as fractions of its size: half width, horizon, height and the sag of its arcs. */
const SKY = { half: 0.42, horizon: 0.5, height: 0.36, sag: 0.1 };

/** Size of the overlay in CSS pixels, and the camera's azimuth in radians. */
export interface Sky {
  readonly width: number;
  readonly height: number;
  readonly azimuth: number;
}

/**
 * Handle of the sun on an arc. Horizontal moves change the azimuth: in the middle the sun is behind the viewer, at both
 * ends behind the scene. Vertical moves change the elevation.
 */
export class SunGizmo implements Gizmo {
  readonly key = 'light';
  readonly icon = 'sun';
  private readonly sky: () => Sky;

  constructor(sky: () => Sky) {
    this.sky = sky;
  }

  describe(values: Values): string {
    return strings.gizmos.light(Number(values['light.azimuth']), Number(values['light.elevation']));
  }

  place(values: Values): { x: number; y: number } {
    return this.at(this.azimuthOf(values), Number(values['light.elevation']));
  }

  move(from: Values, [right, up, near]: Direction): Changes {
    const { width, height } = this.sky();
    const [low, high] = elevations();
    const azimuth = Number(from['light.azimuth']) + (right / (width * SKY.half)) * 180;
    const elevation = Number(from['light.elevation']) + ((up - near) / (height * SKY.height)) * (high - low);
    return {
      'light.azimuth': Math.round(wrapped(azimuth)),
      'light.elevation': clampTo('light.elevation', elevation, 0),
    };
  }

  /** SVG path of the arc at the sun's elevation. */
  arc(values: Values): string {
    const azimuths = Array.from({ length: 25 }, (_, index) => -180 + 15 * index);
    const points = azimuths.map((angle) => this.at(angle, Number(values['light.elevation'])));
    return `M${points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`;
  }

  /** Azimuth relative to the viewer, in degrees to the right. */
  private azimuthOf(values: Values): number {
    return wrapped(Number(values['light.azimuth']) - (this.sky().azimuth * 180) / Math.PI);
  }

  private at(angle: number, elevation: number): { x: number; y: number } {
    const { width, height } = this.sky();
    const [low, high] = elevations();
    const [aside, raised] = [angle / 180, (elevation - low) / (high - low)];
    return {
      x: width * (0.5 + SKY.half * aside),
      y: height * (SKY.horizon - SKY.height * raised + SKY.sag * aside * aside),
    };
  }
}

function elevations(): [low: number, high: number] {
  const row = findParameter('light.elevation')!;
  return row.kind === 'number' ? [row.min, row.max] : [0, 90];
}

/** Wraps degrees to the range from -180 (inclusive) to 180 (exclusive). */
function wrapped(degrees: number): number {
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}
