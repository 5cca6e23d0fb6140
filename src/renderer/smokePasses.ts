import type { WebGLRenderer } from 'three';
import type { AdditionalLights } from './additionalLights.ts';
import type { LampLight } from './falloff.ts';
import type { PuffExtents } from './gpu/formTextures.ts';
import type { FrameView } from './gpu/frameView.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import type { PuffForm, PuffTextures } from './gpu/puffTextures.ts';
import type { Device } from './gpu/device.ts';
import { ONE_QUAD, TWO_QUADS, type RowGeometry } from './gpu/drawnRows.ts';
import { CasterRows, PuffRows } from './gpu/puffRows.ts';
import { BackdropPass } from './passes/backdrop.ts';
import { BodiesPass } from './passes/bodies.ts';
import { MaskPass } from './passes/mask.ts';
import type { CountedVolumesPass } from './passes/countedVolumes.ts';
import type { SimplifyPass } from './passes/simplify/simplify.ts';
import type { PatternPass } from './patterns.ts';
import type { SellePass } from './passes/selle.ts';
import type { StrokesPass } from './passes/strokes/strokes.ts';
import type { TiledVolumesPass } from './passes/tiledVolumes/tiledVolumes.ts';
import { ResolvePass } from './passes/resolve.ts';
import { SurfaceDepthPass, type SurfaceDepth } from './passes/surfaceDepth.ts';
import { Targets } from './passes/targets.ts';
import { VolumesPass } from './passes/volumes.ts';
import type { CoverageGrid } from '../simulator/view.ts';
import type { FrameInput, PassSources } from './frameInput.ts';
import type { SceneSurfaces } from './sceneSurfaces.ts';
import { createShadowEnds, type FindEnds } from './shadowEnds.ts';
import { leastThresholdOf, type Style } from './style.ts';

interface Sources extends PassSources {
  readonly device: Device;
  /** Maximum number of particles. */
  readonly capacity: number;
  /** Undefined without surfaces. */
  readonly scene: SceneSurfaces | undefined;
  readonly hasSurfaces: boolean;
  readonly hasBackdrop: boolean;
  readonly extras: FrameExtras;
}

/** Everything that a frame draws with, created once for a smoke. */
export class SmokePasses {
  readonly renderer: WebGLRenderer;
  readonly eye: FrameView;
  readonly targets = new Targets();
  readonly bodies: PuffRows;
  readonly casters: CasterRows;
  readonly findShadowEnds: FindEnds;
  readonly backdrop: BackdropPass;
  /** Undefined without surfaces. */
  readonly scene: SceneSurfaces | undefined;
  readonly surfaceDepth: SurfaceDepthPass;
  readonly body: BodiesPass;
  readonly volumes: VolumesPass;
  /** Whether puffs are drawn as discs, for GPUs that do not keep the depth that fragments write. */
  readonly isFlat: boolean;
  readonly mask = new MaskPass();
  readonly resolve: ResolvePass;
  /** The modules that the input of a frame needs must be loaded. */
  readonly extras: FrameExtras;
  readonly hasBackdrop: boolean;
  /** The light of a lamp that weakens with distance; undefined for other light. */
  lampLight: LampLight | undefined;
  /** Lights besides the key light; undefined for a style without them. */
  additionalLights: AdditionalLights | undefined;
  private readonly puffs: PuffTextures;

  constructor({ device, eye, puffs, ramps, capacity, scene, hasSurfaces, hasBackdrop, extras }: Sources) {
    const isFlat = !device.writesDepth;
    this.renderer = device.renderer;
    this.eye = eye;
    this.puffs = puffs;
    this.isFlat = isFlat;
    this.bodies = new PuffRows(capacity, isFlat ? TWO_QUADS : ONE_QUAD);
    this.casters = new CasterRows(capacity, ONE_QUAD);
    this.findShadowEnds = createShadowEnds(capacity);
    this.backdrop = new BackdropPass(eye);
    this.scene = scene;
    this.surfaceDepth = new SurfaceDepthPass(hasSurfaces);
    this.body = new BodiesPass(eye, puffs, ramps, isFlat);
    this.volumes = new VolumesPass(eye, puffs, isFlat);
    this.resolve = new ResolvePass(eye);
    this.extras = extras;
    this.hasBackdrop = hasBackdrop;
  }

  /** Bounds of the puffs of a form and of their shadows. */
  extentsOf(form: PuffForm): PuffExtents {
    return this.puffs.of(form);
  }

  /** Frees all buffers, textures and programs. They are created again when they are next drawn. */
  release(): void {
    const { targets, bodies, casters, backdrop, scene, body, volumes, mask, resolve, extras } = this;
    for (const part of [targets, bodies, casters, backdrop, scene, body, volumes, mask, resolve, extras])
      part?.dispose();
  }
}

/** A frame before its first draw call: the rows that it draws. */
export interface ArrangedFrame {
  /** Puffs that the camera can see. */
  readonly bodies: PuffRows;
  /** Puffs whose shadows the camera can see; undefined if the style has no shadows. */
  readonly casters: CasterRows | undefined;
  /** Grid of the occlusion culling, for the view `coverage` only. */
  readonly grid: CoverageGrid | undefined;
  /** Time spent in the simulator's arrange, milliseconds. */
  readonly arrangeMs: number;
}

/** Optional passes, whose modules are loaded on demand; undefined until then. */
export interface FrameExtras {
  /** Draws in place of all other passes of the smoke; `style.renderer` decides. */
  readonly selle: SellePass | undefined;
  /** Counts entries and exits; `style.volumes` decides. */
  readonly countedVolumes: CountedVolumesPass | undefined;
  /** Draws in place of the default passes what `view` of the input says. */
  readonly debugViews: { readonly draw: DrawSmoke; dispose(): void } | undefined;
  /** Smooths the light; `style.simplify` decides. */
  readonly simplify: SimplifyPass | undefined;
  /** Draws lines inside the silhouette; `style.strokes` decides. */
  readonly strokes: StrokesPass | undefined;
  /** Draws the marks of a print; `style.pattern` decides. */
  readonly patterns: PatternPass | undefined;
  /** Draws volumes close to the camera in tiles. */
  readonly tiledVolumes: TiledVolumesPass | undefined;
  /** The shaders of a puff form; undefined for lobes. */
  billboardsOf(form: PuffForm): Shaders | undefined;
  releaseTargets(): void;
  dispose(): void;
}

/** Draws the rest of a frame after the surfaces. */
export type DrawSmoke = (
  passes: SmokePasses,
  input: FrameInput,
  arranged: ArrangedFrame,
  surfaceDepth: SurfaceDepth | undefined,
) => void;

/** Largest count of the stencil buffer. */
export const MAX_COUNT = 255;
/** Distance of the nearest puff, in radii, below which volumes are drawn in tiles. */
const CLOSE = 10;

/** Count from which on more volumes make no difference. */
export function limitOf({ shadowSteps, shadowDepth }: Style): number {
  return shadowSteps === 2 ? Math.min(shadowDepth, MAX_COUNT) : 1;
}

/**
 * Counts the shadow volumes that contain the place at each pixel, in the stencil buffer.
 * @param limit see {@link limitOf}
 */
export function countVolumes(passes: SmokePasses, style: Style, casters: RowGeometry, limit: number): void {
  const { renderer, targets, extras, isFlat } = passes;
  passes.scene?.volumes.draw(renderer);
  passes.mask.countOnce(renderer);
  // Counting needs the depth that fragments write.
  if (style.volumes === 'counted' && !isFlat) {
    extras.countedVolumes!.draw(renderer, casters);
    return;
  }
  const tiled = !isFlat && isCameraClose(passes.eye, passes.bodies.places) ? extras.tiledVolumes : undefined;
  tiled?.setForm(style.form, leastThresholdOf(style));
  if (tiled) tiled.drawTiles(renderer, casters, targets, limit);
  else passes.volumes.draw(renderer, casters, targets.copyDepth(renderer), limit);
}

/** Whether the nearest puff is close. @param places x, y, z and radius of the visible puffs, near to far */
function isCameraClose({ uniforms }: FrameView, [x, y, z, radius]: Float32Array): boolean {
  const e = uniforms.viewFromWorld.value.elements;
  return e[2] * x + e[6] * y + e[10] * z + e[14] > -CLOSE * radius;
}
