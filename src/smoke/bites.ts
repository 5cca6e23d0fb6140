/** Puffs with bites, which few smokes have. */
import type { RawShaderMaterial, WebGLRenderer } from 'three';
import ofLobesFragment from '../../shaders/bites/lobesFragment.glsl';
import ofLobesVertex from '../../shaders/bites/lobesVertex.glsl';
import ofVolumesFragment from '../../shaders/bites/volumesFragment.glsl';
import ofVolumeVertex from '../../shaders/bites/volumeVertex.glsl';
import { RowGeometry } from '../device/drawnRows.ts';
import type { FormTextures } from '../device/formTextures.ts';
import type { Bites, PuffTextures } from '../device/puffTextures.ts';
import { withLobes } from '../device/unroll.ts';

/** The code in place of each `#pragma insert_N` of the shaders of whole puffs. */
const INSERTIONS = [ofLobesVertex, ofLobesFragment, ofVolumeVertex, ofVolumesFragment].flatMap((shader) =>
  shader.split('#pragma section'),
);
/** Varyings of puffs with bites besides those of the lobes. WebGL 2 guarantees 15. */
const VARYINGS_BESIDE_LOBES = 5;

/** The materials of puffs with bites by those of whole puffs. */
const bitten = new WeakMap<RawShaderMaterial, RawShaderMaterial>();

/** The bites of lobe puffs. */
export function bitesOf({ lobes: { puffs } }: PuffTextures): Bites {
  const { lobeCount } = puffs;
  return {
    formOf: withWalls,
    draw(renderer, mesh, geometry) {
      if (!fits(renderer, lobeCount)) return mesh.drawPlain(renderer, geometry);
      const { rows } = geometry;
      const { count } = rows;
      const { material } = mesh;
      // Other geometries draw some rows more than once or not at all.
      rows.count = geometry.constructor === RowGeometry ? rows.whole : 0;
      if (rows.count > 0) mesh.drawPlain(renderer, geometry);
      rows.first = rows.count;
      rows.count = count;
      mesh.material = bittenOf(material, lobeCount);
      // Also without rows, which compiles the program before the first bite.
      mesh.drawPlain(renderer, geometry);
      mesh.material = material;
      rows.first = 0;
    },
  };
}

/** The shader of puffs with bites, by that of whole puffs. */
export function withBites(shader: string, lobes: number): string {
  return shader.replaceAll(/#pragma insert_(\d+)/g, (_, index: string) => withLobes(INSERTIONS[Number(index)], lobes));
}

/** Puffs with more than ten lobes have no bites on some GPUs. */
function fits(renderer: WebGLRenderer, lobes: number): boolean {
  return lobes + VARYINGS_BESIDE_LOBES <= renderer.capabilities.maxVaryings;
}

function bittenOf(whole: RawShaderMaterial, lobes: number): RawShaderMaterial {
  const material = bitten.get(whole) ?? copied(whole, lobes);
  material.stencilRef = whole.stencilRef;
  return material;
}

function copied(whole: RawShaderMaterial, lobes: number): RawShaderMaterial {
  const { uniforms } = whole;
  // Both read the same uniforms; clone() would copy them.
  whole.uniforms = {};
  const material = whole.clone();
  whole.uniforms = material.uniforms = uniforms;
  material.vertexShader = withBites(whole.vertexShader, lobes);
  material.fragmentShader = withBites(whole.fragmentShader, lobes);
  whole.addEventListener('dispose', () => material.dispose());
  bitten.set(whole, material);
  return material;
}

/** Puffs with bites, whose walls are visible, and lit, up to the far end of the puff. */
function withWalls(whole: FormTextures): FormTextures {
  const { reach, capRange } = whole;
  const changed = { depth: { value: reach }, capRange: { value: [capRange[0], reach] } };
  return Object.create(whole, changed) as FormTextures;
}
