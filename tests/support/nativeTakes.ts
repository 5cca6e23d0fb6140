import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Takes that `sim-wasm/sim/examples/table_takes.rs` makes natively, with the hashes that they come to there. */
export interface NativeTake {
  hasRigids: boolean;
  steps: number;
  alive: number;
  hash: string;
  /** In hexadecimal digits. */
  take: string;
}

type Outcome = { status: number; output: string };
type Cargo = (parameters: string[]) => Promise<Outcome>;

// The scripts are plain JavaScript, checked apart from the tests.
const path = '../../scripts/setup/toolchain.mjs';

export async function nativeTakes(): Promise<NativeTake[]> {
  return (await runExample('table_takes')).map((line) => {
    const [rigids, steps, alive, hash, take] = line.split(' ');
    return { hasRigids: rigids === '1', steps: Number(steps), alive: Number(alive), hash, take };
  });
}

/** The native build's hash for each call of `hash` among {@link RecordedCalls}. */
export async function nativeHashes(calls: Uint8Array): Promise<string[]> {
  const folder = mkdtempSync(join(tmpdir(), 'recorded-calls-'));
  try {
    const file = join(folder, 'calls');
    writeFileSync(file, calls);
    return await runExample('native_hashes', [file]);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Builds an example, if it is not, and gives the lines that it prints. */
async function runExample(name: string, parameters: string[] = []): Promise<string[]> {
  const { cargo } = (await import(path)) as { cargo: Cargo };
  const build = ['--quiet', '--locked', '--package', 'sim', '--features', 'rigids'];
  const { status, output } = await cargo(['run', ...build, '--example', name, '--', ...parameters]);
  if (status !== 0) throw new Error(output);
  return output.split('\n');
}
