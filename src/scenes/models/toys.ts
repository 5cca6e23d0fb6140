/** Objects to drop: a ball and a wooden crate, both with a face. Metres, about their centres. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { ballMesh } from './ball.ts';
import { friendlyFace } from './face.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const DARK: Color = [66, 46, 62];
const CHEEK: Color = [240, 138, 122];
const WOOD: Color = [214, 152, 92];
const PLANK: Color = [240, 190, 124];

/** Meshes of a toy by role. Any number of toys can share a model. */
export type ToyModel = Readonly<Record<'body' | 'trim' | 'eyes' | 'cheeks', TriangleMesh>>;

export function ballModel(radius: number): ToyModel {
  return { body: ballMesh(radius), trim: bandMesh(radius), ...face(1.05 * radius, radius, radius * 1.01) };
}

/** @param half of a side */
export function crateModel(half: number): ToyModel {
  const inner = 0.88 * half;
  const [beam, edge] = [0.15 * half, half - 0.15 * half];
  const along = (axis: 0 | 1 | 2, u: number, v: number) => {
    const extents = [beam, beam, beam] as [number, number, number];
    const at = [u * edge, u * edge, u * edge] as [number, number, number];
    extents[axis] = half;
    [at[axis], at[(axis + 2) % 3]] = [0, v * edge];
    return placed(roundedBox(extents, 0.3 * beam, 3), { at });
  };
  const corners = [[-1, -1], [-1, 1], [1, -1], [1, 1]] as const; // prettier-ignore
  const frame = merged(...([0, 1, 2] as const).flatMap((axis) => corners.map(([u, v]) => along(axis, u, v))));
  return {
    body: roundedBox([inner, inner, inner], 0.04 * half, 3),
    trim: frame,
    ...face(1.1 * half, 4 * half, inner),
  };
}

/** @param rigid index of the rigid that carries it */
export function jollyBall(
  rigid: number,
  { body, trim, ...features }: ToyModel,
  color: Color,
  band: Color,
): SurfaceDescription[] {
  return [
    { name: `ball ${rigid}`, mesh: body, color, casts: true, inked: true, rigid },
    { name: `band ${rigid}`, mesh: trim, color: band, casts: false, inked: false, rigid },
    ...faceSurfaces(rigid, features),
  ];
}

/** @param rigid index of the rigid that carries it */
export function jollyCrate(rigid: number, { body, trim, ...features }: ToyModel): SurfaceDescription[] {
  const [crate, frame] = [`crate ${rigid}`, `frame ${rigid}`];
  return [
    { name: crate, mesh: body, color: PLANK, casts: true, inked: true, rigid, group: crate },
    { name: frame, mesh: trim, color: WOOD, casts: false, inked: true, rigid, group: frame },
    ...faceSurfaces(rigid, features),
  ];
}

function faceSurfaces(rigid: number, { eyes, cheeks }: Pick<ToyModel, 'eyes' | 'cheeks'>): SurfaceDescription[] {
  const flat = { casts: false, inked: false, rigid };
  return [
    { name: `eyes ${rigid}`, mesh: eyes, color: DARK, ...flat },
    { name: `cheeks ${rigid}`, mesh: cheeks, color: CHEEK, ...flat },
  ];
}

/** @param front distance of the face from the centre */
function face(size: number, radius: number, front: number): Pick<ToyModel, 'eyes' | 'cheeks'> {
  const { features, cheeks } = friendlyFace(size, radius);
  const stand = { at: [0, 0, front] } as const;
  return { eyes: placed(features, stand), cheeks: placed(cheeks, stand) };
}

/** A stripe around a ball, above its face. */
function bandMesh(radius: number) {
  const at = (share: number, out: number) => [Math.sqrt(1 - share * share) * radius + out, share * radius] as const;
  const [low, middle, high] = [at(0.52, 0.006), at(0.66, 0.008), at(0.8, 0.006)];
  return lathe(40, [[0, low[1]], low], [low, middle, high], [high, [0, high[1]]]);
}
