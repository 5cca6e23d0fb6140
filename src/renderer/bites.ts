/** Puffs with bites, which few smokes have. */
import type { RawShaderMaterial, WebGLRenderer } from 'three';
import lobesFragment from '../../shaders/bites/lobesFragment.glsl';
import lobesVertex from '../../shaders/bites/lobesVertex.glsl';
import volumesFragment from '../../shaders/bites/volumesFragment.glsl';
import volumeVertex from '../../shaders/bites/volumeVertex.glsl';
import { RowGeometry, type BiteDrawing } from './gpu/drawnRows.ts';
import type { FormTextures } from './gpu/formTextures.ts';
import { withCodeBeforeMain, withLobes, type Shaders } from './gpu/programsAhead.ts';
import type { Bites, PuffTextures } from './gpu/puffTextures.ts';

/** Functions that the shaders of bodies and of volumes declare for CUT. */
const OF_BODIES: Shaders = { vertexShader: lobesVertex, fragmentShader: lobesFragment };
const OF_VOLUMES: Shaders = { vertexShader: volumeVertex, fragmentShader: volumesFragment };
/** Varyings of puffs with bites besides those of the lobes. WebGL 2 guarantees 15. */
const VARYINGS_BESIDE_LOBES = 5;

/** The materials of puffs with bites by those of whole puffs. */
const bitten = new WeakMap<RawShaderMaterial, RawShaderMaterial>();

/** The bites of lobe puffs. */
export function bitesOf({ lobes: { puffs } }: PuffTextures): Bites {
  const { lobeCount } = puffs;
  return {
    formOf: withWalls,
    bodies: drawing(OF_BODIES, lobeCount),
    volumes: drawing(OF_VOLUMES, lobeCount),
  };
}

function drawing(code: Shaders, lobes: number): BiteDrawing {
  return {
    draw(renderer, mesh, geometry) {
      if (!fits(renderer, lobes)) return mesh.drawPlain(renderer, geometry);
      const { rows } = geometry;
      const { count } = rows;
      const { material } = mesh;
      // Other geometries draw some rows more than once or not at all.
      rows.count = geometry.constructor === RowGeometry ? rows.whole : 0;
      if (rows.count > 0) mesh.drawPlain(renderer, geometry);
      rows.first = rows.count;
      rows.count = count;
      mesh.material = bittenOf(material, code, lobes);
      // Also without rows, which compiles the program before the first bite.
      mesh.drawPlain(renderer, geometry);
      mesh.material = material;
      rows.first = 0;
    },
  };
}

/** Puffs with more than ten lobes have no bites on some GPUs. */
function fits(renderer: WebGLRenderer, lobes: number): boolean {
  return lobes + VARYINGS_BESIDE_LOBES <= renderer.capabilities.maxVaryings;
}

function bittenOf(whole: RawShaderMaterial, code: Shaders, lobes: number): RawShaderMaterial {
  const material = bitten.get(whole) ?? copied(whole, code, lobes);
  material.stencilRef = whole.stencilRef;
  return material;
}

function copied(whole: RawShaderMaterial, code: Shaders, lobes: number): RawShaderMaterial {
  const { uniforms } = whole;
  // Both read the same uniforms; clone() would copy them.
  whole.uniforms = {};
  const material = whole.clone();
  whole.uniforms = material.uniforms = uniforms;
  material.defines.CUT = '';
  material.vertexShader = added(whole.vertexShader, code.vertexShader, lobes);
  material.fragmentShader = added(whole.fragmentShader, code.fragmentShader, lobes);
  whole.addEventListener('dispose', () => material.dispose());
  bitten.set(whole, material);
  return material;
}

/** Counted volumes have a fragment shader without bites. */
function added(shader: string, code: string, lobes: number): string {
  return shader.includes('CUT') ? withCodeBeforeMain(shader, withLobes(code, lobes)) : shader;
}

/** Puffs with bites, whose walls are visible, and lit, up to the far end of the puff. */
function withWalls(whole: FormTextures): FormTextures {
  const { reach, capRange } = whole;
  const changed = { depth: { value: reach }, capRange: { value: [capRange[0], reach] } };
  return Object.create(whole, changed) as FormTextures;
}
