import type { Matrix4, WebGLRenderer } from 'three';
import type { PuffExtents } from '../device/formTextures.ts';
import type { FrameView } from '../device/frameView.ts';
import type { Shaders } from '../device/programsAhead.ts';
import type { PuffForm } from '../device/puffTextures.ts';
import type { CasterInstances, Instances } from '../instances/instances.ts';
import type { BackdropPass } from '../passes/backdrop.ts';
import type { BodiesPass } from '../passes/bodies.ts';
import type { CreasesPass } from '../passes/creases.ts';
import type { MaskPass } from '../passes/mask.ts';
import type { MeshVolumesPass } from '../passes/meshVolumes.ts';
import type { PrismVolumesPass } from '../passes/prismVolumes.ts';
import type { ResolvePass } from '../passes/resolve.ts';
import type { SurfaceDepthPass } from '../passes/surfaceDepth.ts';
import type { SurfacesPass } from '../passes/surfaces.ts';
import type { Targets } from '../passes/targets.ts';
import type { VolumesPass } from '../passes/volumes.ts';
import type { DebugView } from '../preset/quality.ts';
import type { CoverageGrid } from '../sim/view.ts';
import type { FrameInput } from './frameInput.ts';
import type { ShadowEnds } from './shadowEnds.ts';
import type { ComparisonRenderer } from './style.ts';

/** Everything that a frame draws with; made once for a smoke. */
export interface SmokePasses {
  readonly renderer: WebGLRenderer;
  readonly eye: FrameView;
  readonly targets: Targets;
  readonly bodies: Instances;
  readonly casters: CasterInstances;
  readonly shadowEnds: ShadowEnds;
  readonly backdrop: BackdropPass;
  readonly surfaces: SurfacesPass;
  readonly creases: CreasesPass;
  readonly surfaceDepth: SurfaceDepthPass;
  readonly body: BodiesPass;
  readonly meshVolumes: MeshVolumesPass;
  readonly volumes: VolumesPass;
  /** Instead of the volumes, where the depth that fragments write is not kept. */
  readonly prismVolumes: PrismVolumesPass | undefined;
  readonly mask: MaskPass;
  readonly resolve: ResolvePass;
  /** There is what the input of a frame asks for. */
  readonly extras: FrameExtras;
  readonly hasBackdrop: boolean;
  /** How far puffs of a form and their shadows reach. */
  extentsOf(form: PuffForm): PuffExtents;
  /** @param drawing the passes that draw surfaces; those of every frame where absent */
  placeSurfaces(rigids: readonly Matrix4[], parts: readonly Matrix4[], drawing?: readonly DrawsSurfaces[]): void;
}

type DrawsSurfaces = Pick<SurfacesPass, 'place'>;

/** What few frames draw with. Its code is fetched, so each is undefined until it has come. */
export interface FrameExtras {
  readonly comparisons: DrawsInstead<ComparisonRenderer> | undefined;
  readonly debugViews: (DrawsInstead<DebugView> & { setGrid(grid: CoverageGrid | undefined): void }) | undefined;
  /** By what puffs of a form are drawn, unless they are lobes. */
  billboardsOf(form: PuffForm): Shaders | undefined;
  dispose(): void;
}

/** Goes on from where the surfaces stand in the targets. */
interface DrawsInstead<Kind> {
  draw(kind: Kind, passes: SmokePasses, input: FrameInput): void;
}
