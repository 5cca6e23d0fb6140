/** Native builds of sim-wasm programs, for comparison in tests. */
import { script } from '../server.ts';

interface Toolchain {
  NATIVE: string[];
  cargo(parameters: string[]): Promise<{ status: number; output: string }>;
}

/**
 * Builds a program if it is not up to date.
 *
 * @returns its path
 */
export async function buildNative(kind: 'bin' | 'example', name: string): Promise<string> {
  const { cargo, NATIVE } = await script<Toolchain>('setup/toolchain.mjs');
  const { status, output } = await cargo([
    'build',
    ...NATIVE,
    `--${kind}`,
    name,
    '--message-format',
    'json-render-diagnostics',
  ]);
  if (status !== 0) throw new Error(output.replaceAll(/^{.*$\n?/gm, ''));
  return /"executable":"([^"]+)"/.exec(output)![1];
}
