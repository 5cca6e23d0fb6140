/**
 * A copy of this project's scripts in a temporary folder, on a PATH with only the programs that a test adds. The
 * scripts run as separate processes; tests check their output and exit status.
 */
import { spawnSync } from 'node:child_process';
import { chmodSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

export interface Ending {
  status: number | null;
  /** Standard output. */
  output: string;
  /** The lines of standard error. */
  errors: string[];
}

export class Project {
  readonly folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-'));

  constructor() {
    for (const path of ['scripts', 'package.json', 'sim-wasm/rust-toolchain.toml']) {
      cpSync(join(ROOT, path), this.path(path), { recursive: true });
    }
    mkdirSync(this.path('programs'));
    symlinkSync(process.execPath, this.path('programs/node'));
  }

  path(name: string): string {
    return join(this.folder, name);
  }

  write(name: string, content: string): void {
    mkdirSync(dirname(this.path(name)), { recursive: true });
    writeFileSync(this.path(name), content);
  }

  read(name: string): string {
    return readFileSync(this.path(name), 'utf8');
  }

  /** Adds a program to PATH, given as the body of a shell script. */
  program(name: string, body: string): void {
    this.write(`programs/${name}`, `#!/bin/sh\n${body}\n`);
    chmodSync(this.path(`programs/${name}`), 0o755);
  }

  /** Runs one of the scripts with these arguments. */
  run(script: string, parameters: string[] = [], environment: Record<string, string> = {}): Ending {
    return this.node([`scripts/${script}`, ...parameters], environment);
  }

  /** Sets up single components by file name. */
  setUp(components: string[], environment: Record<string, string> = {}): Ending {
    const code = [
      `import { conclude } from './scripts/lib/userError.mjs';`,
      `import { setUp } from './scripts/setup/setup.mjs';`,
      ...components.map((name) => `import * as ${name} from './scripts/setup/${name}.mjs';`),
      `await conclude(() => setUp([${components.join(', ')}]));`,
    ];
    return this.node(['--input-type=module', '--eval', code.join('\n')], environment);
  }

  node(parameters: string[], environment: Record<string, string> = {}): Ending {
    const { status, stdout, stderr } = spawnSync(process.execPath, parameters, {
      cwd: this.folder,
      encoding: 'utf8',
      // Inherit no environment of this machine: neither the npm that started the tests nor a home folder with a cargo.
      env: { PATH: this.path('programs'), HOME: this.folder, ...environment },
    });
    return { status, output: stdout, errors: stderr.split('\n').filter(Boolean) };
  }

  dispose(): void {
    rmSync(this.folder, { recursive: true, force: true });
  }
}
