import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Part } from '../scenes/scene.ts';

const UNSCALED = new Vector3(1, 1, 1);

/** The parts of a scene that no smoke bumps into, where they are at a time. */
export class PlacedParts {
  private readonly parts: readonly Part[];
  private readonly matrices: Matrix4[];

  constructor(parts: readonly Part[] = []) {
    this.parts = parts;
    this.matrices = parts.map(() => new Matrix4());
  }

  /**
   * World transforms by number.
   * @param seconds simulated
   * @param rigids world transforms of the rigids at that time
   */
  at(seconds: number, rigids: readonly Matrix4[]): readonly Matrix4[] {
    this.parts.forEach(({ rigid, pose }, part) => {
      const { position, rotation } = pose(seconds);
      const matrix = this.matrices[part].compose(new Vector3(...position), new Quaternion(...rotation), UNSCALED);
      if (rigid !== undefined) matrix.premultiply(rigids[rigid]);
    });
    return this.matrices;
  }
}
