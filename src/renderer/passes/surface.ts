import type { Color } from '../gpu/ramps.ts';
import type { TriangleMesh } from './extrusion.ts';

/** A triangle mesh of the scene. */
export interface SurfaceDescription {
  name: string;
  mesh: TriangleMesh;
  /** Colour in full light. */
  color: Color;
  /** Whether it casts shadows. The mesh must be closed then. */
  casts: boolean;
  /** Whether it has outlines. */
  inked: boolean;
  /** Whether it is a source of light, which has the hue of the light where `light.color` sets one. */
  glows?: boolean;
  /**
   * Surfaces of the same group have no line between them. A surface without a group has outlines against all others.
   */
  group?: string;
  /** Index of the rigid that it is attached to; static if absent. */
  rigid?: number;
  /** Index of the scene part whose transform it has, instead of a rigid. */
  part?: number;
  /** Index of the transform of each vertex among the rows of the skin. It has no creases then. */
  skin?: Uint16Array;
  /** Whether it only casts shadow. */
  hidden?: boolean;
}

/** Transforms of vertices that move by themselves, from their places in the meshes. */
export interface Skin {
  /** Number of rows. */
  readonly count: number;
  /** @returns column-major matrices of all rows at a simulated time, valid until the next call */
  at(seconds: number): Float32Array;
}

/** Whether a surface can move relative to the others. */
export function isMoving({ rigid, part, skin }: SurfaceDescription): boolean {
  return (rigid ?? part ?? skin) !== undefined;
}

/** Surfaces with equal keys have no line between them. */
export function groupOf({ group, name }: SurfaceDescription, surface: number): string {
  return group ?? `${name} ${surface}`;
}
