/** `npm run bench -- gpu`: time of each pass on the GPU, by timer queries. */

import { graphicsFlags } from '../../scripts/lib/chromium.mjs';
import { measureInPage } from './support/page.mjs';

/**
 * Uses the graphics that $CHROMIUM_ANGLE names: a backend of ANGLE such as vulkan, gl, metal or d3d11. The default is
 * SwiftShader, which measures a small picture only.
 *
 * @param {import('./support/page.mjs').Choice} choice
 */
export function run(choice) {
  return measureInPage('/tests/bench/render/gpu.ts', choice, [], graphicsFlags(process.env.CHROMIUM_ANGLE));
}
