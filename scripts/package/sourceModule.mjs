import { rolldown } from 'rolldown';
import { inRoot } from '../lib/paths.mjs';

/**
 * Imports a TypeScript module of src/ into a script.
 *
 * @template Module
 * @param {string} path
 * @returns {Promise<Module>}
 */
export async function sourceModule(path) {
  const build = await rolldown({ input: inRoot(path), platform: 'node' });
  const { output } = await build.generate({ format: 'esm', codeSplitting: false });
  await build.close();
  return import(`data:text/javascript;base64,${Buffer.from(output[0].code).toString('base64')}`);
}
