/** A frame in the format of the renderer in sim-wasm/reference. Runs inside a page. The names are those of scene.rs. */
import { Matrix4 } from 'three';
import { glowing, isChanged, type Color, type Ramp, type Tone } from '../../src/renderer/gpu/ramps.ts';
import type { SurfaceDescription } from '../../src/renderer/passes/surface.ts';
import type { TriangleMesh } from '../../src/renderer/passes/extrusion.ts';
import { fromHalf } from '../../src/renderer/puffs/billboards/layers.ts';
import type { Rows } from '../../src/simulator/rows.ts';
import type { View } from '../../src/simulator/view.ts';
import { ATTRIBUTE_BITS, ATTRIBUTE_WORDS } from '../../src/simulator/layout.ts';
import { spreadOf, type BakedPuffs } from '../../src/renderer/gpu/puffTextures.ts';
import type { PuffShape } from '../../src/renderer/puffs/shapes.ts';
import { bakedPuffs } from '../../src/renderer/bakedPuffs.ts';
import { DRAWINGS_PER_SECOND } from '../../src/renderer/frame.ts';
import type { FrameInput } from '../../src/renderer/frameInput.ts';
import { OUT_OF_SIGHT } from '../../src/renderer/sceneSurfaces.ts';
import type { Light } from '../../src/renderer/light.ts';
import { hasPattern } from '../../src/renderer/extraPasses.ts';
import {
  bandsOf,
  fullFromOf,
  plainColorOf,
  rampOf,
  smokeColorOf,
  surfaceToning,
  litThresholdOf,
  washed,
} from '../../src/renderer/palette.ts';
import { inkPixelsOf, leastThresholdOf, type Style } from '../../src/renderer/style.ts';
import { minCapOf } from '../../src/renderer/passes/volumes.ts';

type Triple = readonly [number, number, number];

/** The exact solid that a mesh approximates. */
export type Solid = { type: 'ball'; center: Triple; radius: number } | { type: 'box'; center: Triple; half: Triple };

/** A drawn surface and its solid in the reference; the surface's own triangles where absent. */
export type Shaped = SurfaceDescription & { solid?: Solid };

/** All visible content of a frame: the arguments of `SmokeRenderer` and its input. */
export interface Shown {
  input: FrameInput;
  surfaces: readonly Shaped[];
  backdrop?: { top: Color; bottom: Color };
  /** Shapes by variation; the default ones where absent. */
  shapes?: readonly PuffShape[];
}

/** JSON for the reference. */
export function describe(shown: Shown): string {
  const { input, surfaces, backdrop } = shown;
  const { simulator, camera, style, width, height } = input;
  const seen = surfaces.filter((surface) => placeOf(surface, shown).elements[13] > OUT_OF_SIGHT);
  const rows = (purpose: View['purpose']) =>
    rowsAsObjects(simulator.arrange(viewOf(input, purpose)).rows, purpose === 'eye' && style.looks !== undefined);
  return JSON.stringify({
    width,
    height,
    viewFromWorld: camera.matrixWorldInverse.toArray(),
    clipFromView: camera.projectionMatrix.toArray(),
    light: lightAsObject(input.light),
    backdrop: backdrop && backdropOf(style, backdrop),
    bodies: rows('eye'),
    casters: rows('light'),
    style: styleAsObject(style, input, bakedPuffs(shown.shapes)),
    puffs: puffsAsObject(style, bakedPuffs(shown.shapes)),
    surfaces: seen.map((surface, index) => surfaceAsObject(surface, index, { ...shown, surfaces: seen })),
    shadows: style.shadows,
  });
}

/** A view without culling. */
function viewOf({ blend, style: { upright } }: FrameInput, purpose: View['purpose']): View {
  const receivers = { min: [-1e3, -1e3, -1e3], max: [1e3, 1e3, 1e3] };
  const clipFromWorld = new Float32Array(16);
  return { purpose, blend, upright, cull: false, pad: 0, clipFromWorld, direction: [0, -1, 0], reach: 1, receivers };
}

function backdropOf({ backdropColors = [] }: Style, { top, bottom }: { top: Color; bottom: Color }): readonly Tone[] {
  return backdropColors.length > 0 ? backdropColors : [bottom, top].map((color, from) => ({ from, color }));
}

/** @param areTints whether looks become tints, which are all that the reference has: the first three, with one colour each */
function rowsAsObjects({ count, place, attributes }: Rows, areTints: boolean): object[] {
  return Array.from({ length: count }, (_, row) => {
    const words = [...attributes.subarray(ATTRIBUTE_WORDS * row, ATTRIBUTE_WORDS * (row + 1))];
    const { word, shift, max } = ATTRIBUTE_BITS.look;
    const look = (words[word] >>> shift) & max;
    if (areTints) words[word] = (words[word] & ~(max << shift)) | (look << ATTRIBUTE_BITS.tint.shift);
    return {
      place: [...place.subarray(4 * row, 4 * row + 3)],
      radius: place[4 * row + 3],
      attributes: words.map((each) => each >>> 0),
    };
  });
}

function lightAsObject(light: Light): object {
  return light.kind === 'sun'
    ? { type: 'sun', towards: light.towards.toArray() }
    : { type: 'lamp', place: light.place.toArray(), decay: 0, scale: 1, ...light.falloff };
}

function styleAsObject(style: Style, { pixelRatio, time = 0 }: FrameInput, puffs: BakedPuffs): object {
  const { colors, glows, bands } = bandsOf(style, 1 + style.tints.length);
  const tinted = style.looks
    ? style.looks.styles.slice(1, 4).map((look): Ramp => rampOf(plainColorOf(look!), look!))
    : style.tints.map((own): Ramp => rampOf(own, style));
  const ramps = [rampOf(plainColorOf(style), style), ...tinted];
  const inBands = colors.map((own, band): Ramp => ({ ...rampOf(own, style), glow: glows[band] }));
  return {
    ...style,
    looks: undefined,
    inkPixels: inkPixelsOf(style, pixelRatio),
    drawing: Math.floor(DRAWINGS_PER_SECOND * time),
    smokeColor: smokeColorOf(style),
    smokeRamps: [...ramps, ...inBands],
    bands,
    litFrom: litThresholdOf(style),
    rim: style.shading ? style.rim : 0,
    volumes: style.volumes,
    pattern: hasPattern(style) ? patternAsObject(style, pixelRatio) : undefined,
    shadowDepth: style.shadowSteps === 2 ? style.shadowDepth : undefined,
    minCap: style.isDeformed
      ? spreadOf(style.stretch) * minCapOf(leastThresholdOf(style), 0)
      : minCapOf(leastThresholdOf(style), latestCapOf(style, puffs)),
  };
}

function patternAsObject(style: Style, pixelRatio: number): object {
  return {
    marks: style.pattern,
    onShadow: style.patternOn !== 'tones',
    onTones: style.patternOn !== 'shadow',
    amount: style.patternCoverage,
    backdrop: style.patternBackdrop,
    color: style.patternColor,
    pitch: style.patternSize * pixelRatio,
    softness: style.patternSoftness * pixelRatio,
    angle: (style.patternAngle * Math.PI) / 180,
    shift: [style.patternShiftX, style.patternShiftY].map((shift) => Math.round(shift * pixelRatio)),
    fullFrom: fullFromOf(style),
  };
}

function latestCapOf({ form }: Style, puffs: BakedPuffs): number {
  return form === 'lobes' ? puffs.lobes.caps.latestCap : puffs.billboards.latestCap;
}

function puffsAsObject({ form, isDeformed, isEroded, isTorn, billow, stretch }: Style, baked: BakedPuffs): object {
  const { startCaps, ...puffs } = form === 'lobes' ? lobePuffs(baked) : billboardPuffs(baked);
  const { width, height, values } = startCaps;
  const depth = (isDeformed ? spreadOf(stretch) : 1) * (isEroded ? baked.lobes.reach : puffs.depth);
  const tallest = isDeformed ? spreadOf(stretch) * baked.lobes.reach : 1;
  return {
    ...puffs,
    depth,
    tallest,
    isDeformed,
    isEroded,
    isTorn,
    billow,
    startCaps: { width, height, values: [...values] },
  };
}

function lobePuffs({ lobes }: BakedPuffs) {
  const { lobeCount, count, table, fillet, blend, caps, depth } = lobes;
  const { startCaps } = caps;
  // A row holds the lobes and their centre.
  return { fillet, blend, startCaps, depth, lobes: lobesOf(table, count, lobeCount, lobeCount + 1) };
}

/** Billboards are baked layers, passed unchanged. Their shadows consist of lobes, or of their silhouettes within these. */
function billboardPuffs({ billboards }: BakedPuffs) {
  const { layers, casters, startCaps, depth } = billboards;
  const { size, pad, distanceRange, normalDepth, colorCoverage } = layers;
  const lobes = lobesOf(casters.table, casters.count, casters.lobeCount, casters.lobeCount);
  const relief = Array.from(normalDepth, fromHalf);
  return {
    fillet: 0,
    blend: 0,
    depth,
    lobes,
    areSilhouettes: casters.silhouetteReach > 0,
    startCaps,
    layers: { size, pad, distanceRange, normalDepth: relief, colorCoverage: [...colorCoverage] },
  };
}

/** The lobes of each variation, from rows of `columns` times four numbers. */
function lobesOf(table: Float32Array, variations: number, lobes: number, columns: number): number[][][] {
  const numbers = (length: number) => [...Array(length).keys()];
  return numbers(variations).map((variation) =>
    numbers(lobes).map((lobe) => {
      const first = 4 * (variation * columns + lobe);
      return [...table.subarray(first, first + 4)];
    }),
  );
}

function surfaceAsObject(surface: Shaped, index: number, shown: Shown): object {
  const { mesh, solid, color, casts, inked, rigid, part, group, glows = false } = surface;
  const { style } = shown.input;
  const shape = solid ?? { type: 'triangles', ...arraysOf(mesh), worldFromModel: placeOf(surface, shown).toArray() };
  const ramp = rampOf(washed(color, style.wash), surfaceToning(style));
  const first = shown.surfaces.findIndex((other) => group !== undefined && other.group === group);
  return {
    shape,
    ramp: glows && isChanged(style.illumination) ? glowing(ramp, style.illumination) : ramp,
    glows,
    casts,
    inked,
    group: first < 0 ? index : first,
    carrier: part !== undefined ? `part ${part}` : rigid !== undefined ? `rigid ${rigid}` : undefined,
  };
}

function arraysOf({ positions, normals, indices }: TriangleMesh): object {
  return { positions: [...positions], normals: [...normals], indices: [...indices] };
}

function placeOf({ rigid, part }: Shaped, { input: { rigids, parts = [] } }: Shown): Matrix4 {
  if (part !== undefined) return parts[part];
  return rigid === undefined ? new Matrix4() : rigids[rigid];
}
