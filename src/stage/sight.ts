import { MathUtils, Vector3, type Matrix4 } from 'three';
import type { Vector } from '../scenes/scene.ts';
import type { Picture } from './picture.ts';

/** A place of the picture, CSS pixels from the top left. */
export interface PicturePoint {
  x: number;
  y: number;
}

/**
 * The plane through what the eye looks at, across its view: a place of the picture, counted in CSS pixels from its middle,
 * lies there at middle + x right + y up. Metres.
 */
export interface ScenePlane {
  readonly middle: Vector;
  /** One CSS pixel to the right, and one upwards. */
  readonly right: Vector;
  readonly up: Vector;
}

/**
 * Ways between places of the scene, metres, and of its picture. Places may be meant in the space of a carrier: a
 * rigid by its number, or a part by 4096 and its number; -1 is the world's.
 */
export class Sight {
  private readonly picture: Picture;
  private readonly transformOf: (carrier: number) => Matrix4;

  /** @param transformOf the world transform of a carrier as it is drawn; identity for one that does not exist */
  constructor(picture: Picture, transformOf: (carrier: number) => Matrix4) {
    this.picture = picture;
    this.transformOf = transformOf;
  }

  /** What the eye looks at, in the world. */
  get centre(): Vector {
    return this.picture.eye.centre.toArray();
  }

  /** Where a place is seen; undefined behind the eye. */
  project(place: Vector, carrier = -1): PicturePoint | undefined {
    const point = this.toWorld(place, carrier);
    if (this.depthOf(point) <= 0) return undefined;
    const [width, height] = this.picture.size;
    const { x, y } = point.project(this.picture.eye.camera);
    return { x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height };
  }

  /** What things of a page are put on. */
  get plane(): ScenePlane {
    const { centre } = this;
    const from = (place: Vector): Vector => [place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]];
    return { middle: centre, right: from(this.shift(centre, [1, 0, 0])), up: from(this.shift(centre, [0, 1, 0])) };
  }

  /** A place that lies so many CSS pixels to the right, up and towards the eye, in the space that it came in. */
  shift(place: Vector, [right, up, near]: Vector, carrier = -1): Vector {
    const point = this.toWorld(place, carrier);
    const { camera } = this.picture.eye;
    const [, height] = this.picture.size;
    const angle = MathUtils.degToRad(camera.fov) / 2;
    const metres = (2 * Math.max(this.depthOf(point), camera.near) * Math.tan(angle)) / Math.max(height, 1);
    [right, up, near].forEach((pixels, axis) => point.addScaledVector(this.axis(axis), pixels * metres));
    return this.fromWorld(point, carrier);
  }

  /** A direction or velocity in the world, of so much to the right, up and towards the eye in the picture. */
  along([right, up, near]: Vector): Vector {
    const sum = new Vector3();
    [right, up, near].forEach((share, axis) => sum.addScaledVector(this.axis(axis), share));
    return sum.toArray();
  }

  /** How much of a direction or velocity of the world goes to the right, up and towards the eye. */
  across(direction: Vector): Vector {
    const given = new Vector3(...direction);
    return [given.dot(this.axis(0)), given.dot(this.axis(1)), given.dot(this.axis(2))];
  }

  /** The same place in the space of another carrier. */
  change(place: Vector, from: number, to: number): Vector {
    return this.fromWorld(this.toWorld(place, from), to);
  }

  private axis(index: number): Vector3 {
    return new Vector3().setFromMatrixColumn(this.picture.eye.camera.matrixWorld, index);
  }

  private depthOf(point: Vector3): number {
    return -point.clone().applyMatrix4(this.picture.eye.camera.matrixWorldInverse).z;
  }

  private toWorld(place: Vector, carrier: number): Vector3 {
    return new Vector3(...place).applyMatrix4(this.transformOf(carrier));
  }

  private fromWorld(point: Vector3, carrier: number): Vector {
    return point.applyMatrix4(this.transformOf(carrier).clone().invert()).toArray();
  }
}
