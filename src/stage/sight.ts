import { MathUtils, Vector3, type Matrix4 } from 'three';
import { runOnSelf } from '../base/onSelf.ts';
import type { Vector } from '../scenes/scene.ts';
import type { Picture } from './picture.ts';

/** A position in the picture, in CSS pixels from the top left. */
export interface PicturePoint {
  x: number;
  y: number;
}

/**
 * The plane through the camera target, parallel to the picture. A position at (x, y) CSS pixels from the picture's
 * centre corresponds to middle + x * right + y * up, in metres.
 */
export interface ScenePlane {
  readonly middle: Vector;
  /** Displacement per CSS pixel to the right, and upwards. */
  readonly right: Vector;
  readonly up: Vector;
}

/**
 * Converts between scene positions, in metres, and picture positions. A position can be in the local space of a
 * carrier: a rigid by its index, or part n as 4096 + n; -1 is world space.
 */
export class Sight {
  private readonly picture: Picture;
  private readonly transformOf: (carrier: number) => Matrix4;

  /**
   * @internal
   * @param transformOf the world transform of a carrier as drawn; identity for an unknown carrier
   */
  constructor(picture: Picture, transformOf: (carrier: number) => Matrix4) {
    this.picture = picture;
    this.transformOf = transformOf;
    runOnSelf(this);
  }

  /** The camera target, in world space. */
  get centre(): Vector {
    return this.picture.eye.centre.toArray();
  }

  /** Projects a position into the picture; undefined behind the camera. */
  project(place: Vector, carrier = -1): PicturePoint | undefined {
    const point = this.toWorld(place, carrier);
    if (this.depthOf(point) <= 0) return undefined;
    const [width, height] = this.picture.size;
    const { x, y } = point.project(this.picture.eye.camera);
    return { x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height };
  }

  /** The plane on which page elements are placed. */
  get plane(): ScenePlane {
    const { centre } = this;
    const from = (place: Vector): Vector => [place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]];
    return { middle: centre, right: from(this.shift(centre, [1, 0, 0])), up: from(this.shift(centre, [0, 1, 0])) };
  }

  /** Moves a position by CSS pixels to the right, up and towards the camera, in its own space. */
  shift(place: Vector, [right, up, near]: Vector, carrier = -1): Vector {
    const point = this.toWorld(place, carrier);
    const { camera } = this.picture.eye;
    const [, height] = this.picture.size;
    const angle = MathUtils.degToRad(camera.fov) / 2;
    const metres = (2 * Math.max(this.depthOf(point), camera.near) * Math.tan(angle)) / Math.max(height, 1);
    [right, up, near].forEach((pixels, axis) => point.addScaledVector(this.axis(axis), pixels * metres));
    return this.fromWorld(point, carrier);
  }

  /** Converts a direction or velocity with components to the right, up and towards the camera to world space. */
  along([right, up, near]: Vector): Vector {
    const sum = new Vector3();
    [right, up, near].forEach((share, axis) => sum.addScaledVector(this.axis(axis), share));
    return sum.toArray();
  }

  /** Components of a world-space direction or velocity to the right, up and towards the camera. */
  across(direction: Vector): Vector {
    const given = new Vector3(...direction);
    return [given.dot(this.axis(0)), given.dot(this.axis(1)), given.dot(this.axis(2))];
  }

  /** Converts a position to the space of another carrier. */
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
