import type { WebGLRenderer } from 'three';
import type { PuffExtents } from './gpu/formTextures.ts';
import type { FrameView } from './gpu/frameView.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import type { PuffForm } from './gpu/puffTextures.ts';
import type { CasterRows, PuffRows } from './gpu/puffRows.ts';
import type { BackdropPass } from './passes/backdrop.ts';
import type { BodiesPass } from './passes/bodies.ts';
import type { MaskPass } from './passes/mask.ts';
import type { CountedVolumesPass } from './passes/countedVolumes.ts';
import type { SimplifyPass } from './passes/simplify/simplify.ts';
import type { SellePass } from './passes/selle.ts';
import type { StrokesPass } from './passes/strokes/strokes.ts';
import type { TiledVolumesPass } from './passes/tiledVolumes/tiledVolumes.ts';
import type { ResolvePass } from './passes/resolve.ts';
import type { SurfaceDepth, SurfaceDepthPass } from './passes/surfaceDepth.ts';
import type { Targets } from './passes/targets.ts';
import type { VolumesPass } from './passes/volumes.ts';
import type { CoverageGrid } from '../simulator/view.ts';
import type { FrameInput } from './frameInput.ts';
import type { SceneSurfaces } from './sceneSurfaces.ts';
import type { FindEnds } from './shadowEnds.ts';

/** Everything that a frame draws with, created once for a smoke. */
export interface SmokePasses {
  readonly renderer: WebGLRenderer;
  readonly eye: FrameView;
  readonly targets: Targets;
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
  readonly mask: MaskPass;
  readonly resolve: ResolvePass;
  /** The modules that the input of a frame needs must be loaded. */
  readonly extras: FrameExtras;
  readonly hasBackdrop: boolean;
  /** Bounds of the puffs of a form and of their shadows. */
  extentsOf(form: PuffForm): PuffExtents;
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
