/** Puffs as the paper's billboards: pictures of their fronts, which turn to the viewer. Few smokes ask for them. */
import fragmentShader from '../../shaders/bodies/billboards.frag';
import vertexShader from '../../shaders/bodies/billboards.vert';
import { BillboardTextures } from '../device/billboardTextures.ts';
import type { BillboardPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import type { Shaders } from '../device/programsAhead.ts';
import { castersOf } from '../puffs/casters.ts';
import { frontsOf } from '../puffs/fronts.ts';
import { Kept } from '../puffs/kept.ts';
import { bakePuffs } from '../puffs/layers.ts';
import { PUFF_SHAPES, type PuffShape } from '../puffs/shapes.ts';
import { solidsOf } from '../puffs/solids.ts';
import { bakeStartCaps, latestCap } from '../puffs/startCaps.ts';

/** What bodies draw them with. */
export const billboardShaders: Shaders = { vertexShader, fragmentShader };

/** Radii by which facets, texels and their filter move outline and relief, and pixels by which smaller levels do. */
const LAYER_TOLERANCE = 0.06;
const LAYER_BLUR = 3;

const kept = new Kept<BillboardPuffs>(4);

/** @param fronts a variation each, seen from +z; those that were drawn by hand where absent */
export function bakeBillboards(fronts: readonly PuffShape[] = PUFF_SHAPES): BillboardPuffs {
  const key = JSON.stringify(fronts.map(({ lobes }) => lobes));
  const billboards = kept.get(key) ?? bake(fronts);
  kept.add(key, billboards);
  return billboards;
}

function bake(fronts: readonly PuffShape[]): BillboardPuffs {
  const layers = bakePuffs(fronts);
  const surfaces = frontsOf(layers);
  const data = {
    layers,
    startCaps: bakeStartCaps(surfaces, FIRST_BORDER),
    latestCap: latestCap(surfaces.flat()),
    casters: castersOf(fronts),
    solids: solidsOf(
      fronts.map(({ lobes }) => lobes),
      { facesEye: true, tolerance: LAYER_TOLERANCE, blur: LAYER_BLUR },
    ),
  };
  return { ...data, texturesFor: (context) => new BillboardTextures(context, data) };
}
