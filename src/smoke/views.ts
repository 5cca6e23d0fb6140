/** What a frame asks the simulator to arrange: the bodies for the eye, the casters for the light. */
import { Box3, Vector3 } from 'three';
import type { Bounds } from '../sim/simulator.ts';
import { LIFTERS_LIMIT, type CoverageView, type View } from '../sim/view.ts';
import { widestLine } from '../passes/ink.ts';
import type { FrameView } from '../device/frameView.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';
import { inkLineOf } from './style.ts';

/** Ink stands at most this far beside a puff, in its radii; see shaders/lib/ink.glsl. */
const WIDEST_RING = 0.3;
/** So much nearer, for each unit beside its puff, a surface may lift it; see shaders/lib/contact.glsl. */
const STEEPEST = 8;
/** The simulator counts no farther. */
const MAX_COVERS = 16;

export function eyeView(passes: SmokePasses, input: FrameInput): View {
  const { eye } = passes;
  // What is blended has to come far to near.
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
    // Casters are culled by where one common direction carries their shadow; a lamp has none.
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
  // The comparison renderers draw what is hidden, too: they are compared as they are, and blended sprites shine through.
  // Where bodies are as deep as their quads and shadows are prisms, the solids are not what is drawn.
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

/** The boxes of the surfaces, the host's as one; of too many, one that holds all. */
function liftersOf({ surfaces }: SmokePasses, hostBounds: Box3 | undefined): number[][] {
  const boxes = [...surfaces.worldBoxes(), ...(hostBounds && !hostBounds.isEmpty() ? [hostBounds] : [])];
  const few = boxes.length > LIFTERS_LIMIT ? [boxes.reduce((all, box) => all.union(box), new Box3())] : boxes;
  return few.map(({ min, max }) => [...min.toArray(), ...max.toArray()]);
}

/**
 * The box of all smoke that can receive a shadow. A nailboard's relief moves its fragments along the view ray and so
 * sideways too; were they outside of the box, a volume could end before them that hides another one which does not.
 */
export function smokeBox({ eye }: SmokePasses, { min, max, greatestRadius }: Bounds): Box3 {
  const shear = eye.steepestSlope * (1 + WIDEST_RING) + WIDEST_RING;
  return new Box3(new Vector3(...min), new Vector3(...max)).expandByScalar(shear * greatestRadius);
}

/** Radii from its centre within which everything is that is seen of a puff with a reach, moved by its relief and ink included. */
export function shownWithin(reach: number, { steepestSlope }: FrameView): number {
  return (reach + WIDEST_RING) * (1 + steepestSlope);
}
