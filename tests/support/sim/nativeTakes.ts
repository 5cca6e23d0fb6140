import { execFile } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { buildNative } from './nativeProgram.ts';

/** Takes that `sim-wasm/sim/examples/table_takes.rs` records natively, with their hashes. */
export interface NativeTake {
  hasRigids: boolean;
  steps: number;
  alive: number;
  hash: string;
  /** Bytes in hexadecimal digits. */
  take: string;
}

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

/** @returns the lines that an example prints */
async function runExample(name: string, parameters: string[] = []): Promise<string[]> {
  const program = await buildNative('example', name);
  const { stdout } = await promisify(execFile)(program, parameters, { maxBuffer: 1 << 28 });
  return stdout.trimEnd().split('\n');
}
