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

/** Builds the example, if it is not, and runs it. */
export async function nativeTakes(): Promise<NativeTake[]> {
  const { cargo } = (await import(path)) as { cargo: Cargo };
  const build = ['--quiet', '--locked', '--package', 'sim', '--features', 'rigids'];
  const { status, output } = await cargo(['run', ...build, '--example', 'table_takes']);
  if (status !== 0) throw new Error(output);
  return output.split('\n').map((line) => {
    const [rigids, steps, alive, hash, take] = line.split(' ');
    return { hasRigids: rigids === '1', steps: Number(steps), alive: Number(alive), hash, take };
  });
}
