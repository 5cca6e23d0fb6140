/** The views of a frame that the simulator arranges: puffs for the camera and casters for the light. */
import { Box3, Vector3 } from 'three';
import type { Bounds } from '../simulator/arranged.ts';
import { LIFTERS_LIMIT } from '../simulator/layout.ts';
import type { CoverageView, View } from '../simulator/view.ts';
import type { PuffExtents } from './gpu/formTextures.ts';
import type { FrameView } from './gpu/frameView.ts';
import { startRange } from './passes/shadowVolume.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';
import { widestLineOf } from './style.ts';
import { COVERS_LIMIT, STEEPEST } from '../base/constants.ts';

/** Largest distance of ink from a silhouette, in puff radii; see shaders/lib/ink.glsl. */
const WIDEST_RING = 0.3;
/** Up to this number of particles, finding those that are hidden takes longer than drawing them. */
const FEW = 100;

/** What a view is computed from, besides the input of the frame. */
export interface ViewSources {
  readonly eye: FrameView;
  /** Bounds of the puffs in the form that is drawn. */
  readonly extents: PuffExtents;
  /** World-space boxes of everything but smoke that is drawn and receives shadow. */
  readonly boxes: readonly Box3[];
  /** Least distance behind a puff's centre at which volumes start, in radii. */
  readonly minCap: number;
  /** Whether puffs are drawn as discs. */
  readonly isFlat: boolean;
}

/** @param passes with the surfaces of this frame in place */
export function viewSources(passes: SmokePasses, { style, others }: FrameInput): ViewSources {
  return {
    eye: passes.eye,
    extents: passes.extentsOf(style.form),
    boxes: others?.boxes ?? passes.scene?.surfaces.worldBoxes() ?? [],
    minCap: passes.volumes.minCap,
    isFlat: passes.isFlat,
  };
}

export function eyeView(sources: ViewSources, input: FrameInput): View {
  const { eye } = sources;
  return {
    ...common(sources, input),
    purpose: 'eye',
    pad: widestLineOf(input.style, input.pixelRatio) * eye.unitsPerPixel,
    direction: eye.forward.toArray(),
    receivers: { min: [0, 0, 0], max: [0, 0, 0] },
    coverage: coverageOf(sources, input, 1),
  };
}

/**
 * @param receivers world-space box of everything that can receive a shadow
 * @param travel unit vector along which the light travels, in the middle of the smoke
 */
export function lightView(sources: ViewSources, input: FrameInput, receivers: Box3, travel: Vector3): View {
  const { eye, extents } = sources;
  const { style } = input;
  const { capTable: startCaps, casterSolids } = extents;
  const coverage = coverageOf(sources, input, style.shadowSteps === 2 ? style.shadowDepth : 1);
  return {
    ...common(sources, input),
    purpose: 'light',
    lamp: eye.lamp?.toArray(),
    pad: 0,
    direction: travel.toArray(),
    receivers: { min: receivers.min.toArray(), max: receivers.max.toArray() },
    coverage: coverage && { ...coverage, startCaps, solids: casterSolids ?? coverage.solids },
  };
}

function common({ eye, extents: { reach, sides } }: ViewSources, { blend, cull, style: { upright } }: FrameInput) {
  return { blend, cull, clipFromWorld: eye.clipFromWorld.elements, reach, sides, upright };
}

function coverageOf(
  { eye, extents, boxes, minCap, isFlat }: ViewSources,
  { style, pixelRatio, simulator }: FrameInput,
  covers: number,
): CoverageView | undefined {
  // The renderer `selle` is compared without occlusion culling. The solids do not match flat puffs.
  if (style.renderer !== 'nailboards' || isFlat || (simulator.alive ?? Infinity) <= FEW) return undefined;
  const { depth, solids } = extents;
  const [nearest, farthest] = eye.range;
  return {
    covers: covers > COVERS_LIMIT ? 0 : covers,
    pixel: eye.unitsPerPixel,
    nearest,
    farthest,
    lifters: liftersOf(boxes),
    lift: STEEPEST * widestLineOf(style, pixelRatio) * eye.unitsPerPixel,
    capRange: startRange(extents, minCap),
    depth,
    solids,
  };
}

/** The boxes as numbers. If there are too many, one box that contains all. */
function liftersOf(boxes: readonly Box3[]): number[][] {
  const few = boxes.length > LIFTERS_LIMIT ? [boxes.reduce((all, box) => all.union(box), new Box3())] : boxes;
  return few.map(({ min, max }) => [...min.toArray(), ...max.toArray()]);
}

/**
 * The box of all smoke that can receive a shadow. The relief of a nailboard moves fragments along the view ray, and so
 * sideways. Outside the box, a volume could end in front of a fragment although it has occluded, and so culled, a
 * volume that does not.
 * @param spread see {@link PuffExtents}
 */
export function smokeBox({ steepestSlope }: FrameView, spread: number, { min, max, greatestRadius }: Bounds): Box3 {
  const shear = steepestSlope * (spread + WIDEST_RING) + WIDEST_RING + spread - 1;
  return new Box3(new Vector3(...min), new Vector3(...max)).expandByScalar(shear * greatestRadius);
}

/** Radius of the bounding sphere of the visible parts of a puff, in puff radii, with relief and ink included. */
export function shownWithin(reach: number, { steepestSlope }: FrameView): number {
  return (reach + WIDEST_RING) * (1 + steepestSlope);
}
