/** The simulator as a native process, and the endpoint through which the page sends it commands. */

import { spawn } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { inRoot } from '../../../scripts/lib/paths.mjs';
import { UserError } from '../../../scripts/lib/userError.mjs';
import { cargo, rustc } from '../../../scripts/setup/toolchain.mjs';

const FOLDER = 'sim-wasm/target/bench';
const PROGRAM = `${FOLDER}/release/examples/contest${process.platform === 'win32' ? '.exe' : ''}`;

/**
 * SIMD features of WASM that baseline x86-64 lacks, such as rounding four numbers down: without them the native side
 * would be slower. Neither side uses fused multiply-add.
 */
const FEATURES = process.arch === 'x64' ? '-C target-feature=+sse4.1' : '';

/** @param {(line: string) => void} say */
export async function buildContestants(say) {
  mkdirSync(inRoot(FOLDER), { recursive: true });
  const native = ['build', '--release', '--locked', '--package', 'sim-tests', '--example', 'contest'];
  requireBuilt('contest', await cargo([...native, '--target-dir', inRoot(FOLDER)], say, { RUSTFLAGS: FEATURES }));
  const wasm = ['--edition', '2024', '--crate-type', 'cdylib', '--target', 'wasm32-unknown-unknown'];
  const tuned = ['-C', 'opt-level=3', '-C', 'target-feature=+simd128', '-C', 'strip=symbols'];
  const source = inRoot('sim-wasm/sim/examples/memory/wasm.rs');
  requireBuilt('memory', await rustc([...wasm, ...tuned, source, '-o', inRoot(`${FOLDER}/memory.wasm`)], say));
}

function requireBuilt(
  /** @type {string} */ example,
  /** @type {import('../../../scripts/lib/command.mjs').Outcome} */ { status, output },
) {
  if (status !== 0) throw new UserError(`The example ${example} does not compile: see the lines above.`, output);
}

/** The running program. It exits when its standard input closes, and therefore with this process. */
export class Native {
  /** @type {((line: string) => void)[]} */
  #waiting = [];
  #child;

  constructor() {
    if (!existsSync(inRoot(PROGRAM))) throw new UserError(`${PROGRAM} was not built.`);
    this.#child = spawn(inRoot(PROGRAM), { stdio: ['pipe', 'pipe', 'inherit'] });
    createInterface({ input: this.#child.stdout }).on('line', (line) => this.#waiting.shift()?.(line));
    this.#child.on('exit', () => this.#waiting.splice(0).forEach((answer) => answer('')));
  }

  /**
   * The vite plugin that forwards commands: POST /native?LINE, with the bytes after the line as the body. The response
   * is the program's line.
   *
   * @returns {import('vite').Plugin}
   */
  plugin() {
    return {
      name: 'native-contestant',
      configureServer: (server) => {
        server.middlewares.use('/native', (request, response, next) => {
          this.#answer(request, response).catch(next);
        });
      },
    };
  }

  stop() {
    this.#child.stdin.end();
  }

  /** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
  async #answer(request, response) {
    const line = decodeURIComponent(new URL(request.url ?? '', 'http://localhost').search.slice(1));
    const answer = await this.#ask(line, await readAll(request));
    response.statusCode = answer === '' ? 500 : 200;
    response.end(answer);
  }

  /** @param {string} line @param {Buffer} bytes @returns {Promise<string>} */
  #ask(line, bytes) {
    if (this.#child.exitCode !== null) return Promise.resolve('');
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      this.#child.stdin.write(`${line}\n`);
      if (bytes.length > 0) this.#child.stdin.write(bytes);
    });
  }
}

/** @param {import('node:http').IncomingMessage} request */
async function readAll(request) {
  const pieces = [];
  for await (const piece of request) pieces.push(/** @type {Buffer} */ (piece));
  return Buffer.concat(pieces);
}
