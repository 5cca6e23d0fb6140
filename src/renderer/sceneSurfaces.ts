import type { Matrix4 } from 'three';
import type { FrameView } from './gpu/frameView.ts';
import type { RampTexture } from './gpu/ramps.ts';
import { CreasesPass } from './passes/creases.ts';
import { MeshVolumesPass } from './passes/meshVolumes.ts';
import type { SurfaceDescription } from './passes/surface.ts';
import { SurfacesPass } from './passes/surfaces.ts';
import { coarserSurfaces } from './detail.ts';
import { SurfaceTransforms } from './passes/surfaceTransforms.ts';

/** World height below which surfaces are hidden, metres. */
export const OUT_OF_SIGHT = -60;

/** Surfaces for a smoke to draw. Smoke without any, as in the scenes of others, does not need their passes. */
export interface DrawnSurfaces {
  readonly descriptions: readonly SurfaceDescription[];
  /** @param firstRamp ramp index of the first surface; the other surfaces follow in order */
  make(eye: FrameView, ramps: RampTexture, firstRamp: number): SceneSurfaces;
}

/** The surfaces of a scene, for the options of a smoke. */
export function drawnSurfaces(descriptions: readonly SurfaceDescription[]): DrawnSurfaces {
  return { descriptions, make: (eye, ramps, first) => new SceneSurfaces(eye, ramps, first, descriptions) };
}

/** The surfaces of a scene with the passes that draw them, their lines and their shadows. */
export class SceneSurfaces {
  /** World transforms, which all passes of a frame read. */
  readonly transforms: SurfaceTransforms;
  readonly surfaces: SurfacesPass;
  readonly creases: CreasesPass;
  readonly volumes: MeshVolumesPass;
  private readonly descriptions: readonly SurfaceDescription[];
  private deviation: number | undefined;

  constructor(eye: FrameView, ramps: RampTexture, firstRamp: number, descriptions: readonly SurfaceDescription[]) {
    const transforms = new SurfaceTransforms(descriptions.length);
    this.transforms = transforms;
    this.surfaces = new SurfacesPass(eye, ramps, firstRamp, descriptions, transforms);
    this.creases = new CreasesPass(eye, transforms);
    this.volumes = new MeshVolumesPass(eye, transforms);
    this.descriptions = descriptions;
  }

  /** Sets the world transforms of surfaces on rigids and parts. */
  place(rigids: readonly Matrix4[], parts: readonly Matrix4[]): void {
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
