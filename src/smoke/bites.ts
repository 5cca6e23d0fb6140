import placing from '../../shaders/lib/bites.glsl';
import ofBodies from '../../shaders/bodies/bites.glsl';
import ofVolumes from '../../shaders/volumes/bites.glsl';
import type { BiteShaders } from '../device/unroll.ts';

/** The code of puffs with bites, which few smokes have. */
export const BITES: BiteShaders = { placing, ofBodies, ofVolumes };
