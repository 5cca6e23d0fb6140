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
}

/** Whether a surface can move relative to the others. */
export function isMoving({ rigid, part }: SurfaceDescription): boolean {
  return rigid !== undefined || part !== undefined;
}

/** Surfaces with equal keys have no line between them. */
export function groupOf({ group, name }: SurfaceDescription, surface: number): string {
  return group ?? `${name} ${surface}`;
}
