/** Native builds of sim-wasm programs, for comparison in tests. */
import { script } from '../server.ts';

interface Toolchain {
  cargoNative(command: string, parameters: string[]): Promise<{ status: number; output: string }>;
}

/**
 * Builds a program if it is not up to date.
 *
 * @returns its path
 */
export async function buildNative(kind: 'bin' | 'example', name: string): Promise<string> {
  const { cargoNative } = await script<Toolchain>('setup/toolchain.mjs');
  const choice = [`--${kind}`, name, '--message-format', 'json-render-diagnostics'];
  const { status, output } = await cargoNative('build', choice);
  if (status !== 0) throw new Error(output.replaceAll(/^{.*$\n?/gm, ''));
  return /"executable":"([^"]+)"/.exec(output)![1];
}
