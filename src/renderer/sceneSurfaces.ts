import type { Matrix4 } from 'three';
import type { FrameView } from './gpu/frameView.ts';
import type { RampTexture } from './gpu/ramps.ts';
import { CreasesPass } from './passes/creases.ts';
import { MeshVolumesPass } from './passes/meshVolumes.ts';
import type { Skin, SurfaceDescription } from './passes/surface.ts';
import { SurfacesPass } from './passes/surfaces.ts';
import { SurfaceTransforms } from './passes/surfaceTransforms.ts';
import { memoize } from './passes/memoize.ts';
import type { TriangleMesh } from './passes/extrusion.ts';

/** World height below which surfaces are hidden, metres. */
export const OUT_OF_SIGHT = -60;

/** Surfaces for a smoke to draw. Smoke without any, as in the scenes of others, does not need their passes. */
export interface DrawnSurfaces {
  readonly descriptions: readonly SurfaceDescription[];
  /** @param firstRamp ramp index of the first surface; the other surfaces follow in order */
  make(eye: FrameView, ramps: RampTexture, firstRamp: number): SceneSurfaces;
}

/** The surfaces of a scene, for the options of a smoke. */
export function drawnSurfaces(descriptions: readonly SurfaceDescription[], skin?: Skin): DrawnSurfaces {
  return { descriptions, make: (eye, ramps, first) => new SceneSurfaces(eye, ramps, first, descriptions, skin) };
}

/** The surfaces of a scene with the passes that draw them, their lines and their shadows. */
export class SceneSurfaces {
  /** World transforms, which all passes of a frame read. */
  readonly transforms: SurfaceTransforms;
  readonly surfaces: SurfacesPass;
  readonly creases: CreasesPass;
  readonly volumes: MeshVolumesPass;
  private readonly descriptions: readonly SurfaceDescription[];
  private readonly skin: Skin | undefined;
  private deviation: number | undefined;

  constructor(
    eye: FrameView,
    ramps: RampTexture,
    firstRamp: number,
    descriptions: readonly SurfaceDescription[],
    skin?: Skin,
  ) {
    const transforms = new SurfaceTransforms(descriptions.length + (skin?.count ?? 0));
    this.transforms = transforms;
    this.surfaces = new SurfacesPass(eye, ramps, firstRamp, descriptions, transforms);
    this.creases = new CreasesPass(eye, transforms);
    this.volumes = new MeshVolumesPass(eye, transforms);
    this.descriptions = descriptions;
    this.skin = skin;
  }

  /** Sets the world transforms of surfaces on rigids and parts, and of the skin at a simulated time. */
  place(rigids: readonly Matrix4[], parts: readonly Matrix4[], seconds: number): void {
    if (this.skin) this.transforms.placeRows(this.descriptions.length, this.skin.at(seconds));
    this.descriptions.forEach(({ rigid, part }, surface) => {
      if (rigid === undefined && part === undefined) return;
      const transform = part === undefined ? rigids[rigid!] : parts[part];
      this.transforms.place(surface, transform, transform.elements[13] > OUT_OF_SIGHT);
    });
  }

  /**
   * Chooses the triangles of the models.
   * @param deviation from the finest ones, metres; see `deviationFor`
   */
  refine(deviation: number): void {
    if (deviation === this.deviation) return;
    this.deviation = deviation;
    const surfaces = coarserSurfaces(this.descriptions, deviation);
    for (const pass of [this.surfaces, this.creases, this.volumes]) pass.show(surfaces);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    for (const part of [this.surfaces, this.creases, this.transforms, this.volumes]) part.dispose();
  }
}

/** Levels of detail of the scene's models, by the size of a pixel. */

/** Pixels by which triangles may deviate from the finest ones, at the distance of the camera's target. */
const PIXELS = 0.25;
/** Metres. Models are drawn with their finest triangles if only a smaller deviation is allowed. */
const FINEST = 0.005;

/**
 * How far triangles may deviate from the finest ones, in metres, in steps of a factor of sqrt(2); 0 for the finest.
 * @param metresPerPixel at the distance of the camera's target
 */
export function deviationFor(metresPerPixel: number): number {
  const deviation = 2 ** (Math.floor(2 * Math.log2(PIXELS * metresPerPixel)) / 2);
  return deviation < FINEST ? 0 : deviation;
}

/** Memoizes coarser versions of the same type, by their deviation in metres. A deviation of 0 is the source itself. */
function memoizeLevels<Source extends object>(coarsen: (source: Source, deviation: number) => Source) {
  const levelsOf = memoize<Source, Map<number, Source>>((source) => new Map([[0, source]]));
  return (source: Source, deviation: number): Source => {
    const levels = levelsOf(source);
    if (!levels.has(deviation)) levels.set(deviation, coarsen(source, deviation));
    return levels.get(deviation)!;
  };
}

const coarserMesh = memoizeLevels((mesh: TriangleMesh, deviation) =>
  mesh.coarser ? { ...mesh, indices: mesh.coarser(deviation) } : mesh,
);

/** Surfaces with fewer triangles on the same vertices. Surfaces that share a mesh still do. */
export const coarserSurfaces = memoizeLevels((surfaces: readonly SurfaceDescription[], deviation) =>
  surfaces.map((surface) => ({ ...surface, mesh: coarserMesh(surface.mesh, deviation) })),
);
