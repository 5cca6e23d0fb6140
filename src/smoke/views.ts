/** The views of a frame that the simulator arranges: puffs for the camera and casters for the light. */
import { Box3, Vector3 } from 'three';
import type { Bounds } from '../sim/simulator.ts';
import { LIFTERS_LIMIT } from '../sim/layout.ts';
import type { CoverageView, View } from '../sim/view.ts';
import { widestLine } from '../passes/ink.ts';
import type { FrameView } from '../device/frameView.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';
import { inkLineOf } from './style.ts';

/** Largest distance of ink from a silhouette, in puff radii; see shaders/lib/ink.glsl. */
const WIDEST_RING = 0.3;
/** Largest distance by which a surface may lift ink, for each unit beside its puff; see shaders/lib/contact.glsl. */
const STEEPEST = 8;
/** The simulator's limit of covers. */
const MAX_COVERS = 16;

export function eyeView(passes: SmokePasses, input: FrameInput): View {
  const { eye } = passes;
  // Blended sprites must be sorted back to front.
  const blends = input.style.renderer === 'sprites';
  const { pixels, swell } = inkLineOf(input.style, input.pixelRatio);
  return {
    ...common(passes, input),
    purpose: 'eye',
    pad: widestLine(pixels, swell) * eye.unitsPerPixel,
    direction: (blends ? eye.forward.clone().negate() : eye.forward).toArray(),
    receivers: { min: [0, 0, 0], max: [0, 0, 0] },
    coverage: coverageOf(passes, input, 1),
  };
}

export function lightView(passes: SmokePasses, input: FrameInput, receivers: Box3): View {
  const { eye } = passes;
  const { style } = input;
  const coverage = coverageOf(passes, input, style.shadowSteps === 2 ? style.shadowDepth : 1);
  return {
    ...common(passes, input),
    purpose: 'light',
    // Culling of casters projects them along one common direction, which a lamp does not have.
    cull: input.cull && eye.isLitBySun,
    pad: 0,
    direction: eye.travelAt(receivers.getCenter(new Vector3())).toArray(),
    receivers: { min: receivers.min.toArray(), max: receivers.max.toArray() },
    coverage: coverage && { ...coverage, startCaps: passes.extentsOf(style.form).capTable },
  };
}

function common(passes: SmokePasses, { blend, cull, style }: FrameInput) {
  const { eye } = passes;
  return {
    blend,
    cull,
    clipFromWorld: eye.clipFromWorld.elements,
    reach: passes.extentsOf(style.form).reach,
  };
}

function coverageOf(
  passes: SmokePasses,
  { style, pixelRatio, receivers }: FrameInput,
  covers: number,
): CoverageView | undefined {
  // The comparison renderers draw hidden puffs, too: they are compared without occlusion culling, and blended sprites
  // are transparent. With flat puffs and prism volumes, the solids do not match the drawn shapes.
  if (style.renderer !== 'nailboards' || passes.prismVolumes) return undefined;
  const { eye, volumes } = passes;
  const { capRange, depth, solids } = passes.extentsOf(style.form);
  const [nearest, farthest] = eye.range;
  const { pixels, swell } = inkLineOf(style, pixelRatio);
  return {
    covers: covers > MAX_COVERS ? 0 : covers,
    pixel: eye.unitsPerPixel,
    nearest,
    farthest,
    lifters: liftersOf(passes, receivers),
    lift: STEEPEST * widestLine(pixels, swell) * eye.unitsPerPixel,
    capRange: [Math.max(capRange[0], volumes.minCap), Math.max(capRange[1], volumes.minCap)],
    depth,
    solids,
  };
}

/** The boxes of the surfaces and of the host's scene. If there are too many, one box that contains all. */
function liftersOf({ surfaces }: SmokePasses, hostBounds: Box3 | undefined): number[][] {
  const boxes = [...surfaces.worldBoxes(), ...(hostBounds && !hostBounds.isEmpty() ? [hostBounds] : [])];
  const few = boxes.length > LIFTERS_LIMIT ? [boxes.reduce((all, box) => all.union(box), new Box3())] : boxes;
  return few.map(({ min, max }) => [...min.toArray(), ...max.toArray()]);
}

/**
 * The box of all smoke that can receive a shadow. The relief of a nailboard moves fragments along the view ray, and so
 * sideways. Outside the box, a volume could end in front of a fragment although it has occluded, and so culled, a
 * volume that does not.
 */
export function smokeBox({ eye }: SmokePasses, { min, max, greatestRadius }: Bounds): Box3 {
  const shear = eye.steepestSlope * (1 + WIDEST_RING) + WIDEST_RING;
  return new Box3(new Vector3(...min), new Vector3(...max)).expandByScalar(shear * greatestRadius);
}

/** Radius of the bounding sphere of the visible parts of a puff, in puff radii, with relief and ink included. */
export function shownWithin(reach: number, { steepestSlope }: FrameView): number {
  return (reach + WIDEST_RING) * (1 + steepestSlope);
}
