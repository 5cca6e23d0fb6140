import type { Values } from '../../preset/parameter.ts';
import { findParameter } from '../../preset/table.ts';
import { clampTo } from './clampTo.ts';
import type { Changes } from '../editor/editor.ts';
import type { Direction } from '../input/directions.ts';
import type { Gizmo } from './gizmo.ts';
import { strings } from '../strings.ts';

/** The sky over the picture, as shares of its size: half its width, the horizon, its height, and how its arcs sag. */
const SKY = { half: 0.42, horizon: 0.5, height: 0.36, sag: 0.1 };

/** Size of the overlay, and where the eye stands about the vertical, radians. */
export interface Sky {
  readonly width: number;
  readonly height: number;
  readonly azimuth: number;
}

/**
 * The sun on an arc: to the sides it goes about the scene, in the middle it stands behind the viewer, at both ends behind
 * the scene; higher is higher.
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

  /** The arc on which the sun stands at its height, as the path of a drawing. */
  arc(values: Values): string {
    const azimuths = Array.from({ length: 25 }, (_, index) => -180 + 15 * index);
    const points = azimuths.map((angle) => this.at(angle, Number(values['light.elevation'])));
    return `M${points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`;
  }

  /** Degrees to the right of where the viewer stands. */
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

/** From -180 up to 180. */
function wrapped(degrees: number): number {
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}
