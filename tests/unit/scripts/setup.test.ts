/** Output if the machine lacks something: one sentence, a non-zero status, no stack trace. */
import { existsSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { Project, type Ending } from '../../support/project.ts';
import { findFreePort } from '../../support/server.ts';

let project: Project;
beforeEach(() => {
  project = new Project();
});
afterEach(() => project.dispose());

const LOCK = { packages: { '': {}, 'node_modules/three': { version: '1.2.3', integrity: 'sha512-abc' } } };

function installPackages(): void {
  project.write('package-lock.json', JSON.stringify(LOCK));
  project.write('node_modules/.package-lock.json', JSON.stringify({ packages: { ...LOCK.packages, '': undefined } }));
  project.write('node_modules/three/package.json', '{}');
}

const PARTS = ['cargo', 'clippy', 'rustfmt', 'rust-std-wasm32-unknown-unknown'];

/** A rustup with a complete toolchain; `cargo` is the shell code of its cargo. */
function installRust(cargo = 'exit 0', parts = PARTS): void {
  project.program('rustup', parts.map((part) => `echo ${part}`).join('; '));
  project.program('cargo', cargo);
}

function expectSentence(ending: Ending, sentence: RegExp): void {
  expect(ending.errors.at(-1)).toMatch(sentence);
  expect(ending.errors.join('\n')).not.toMatch(/^\s+at /m);
  expect(ending.status).toBe(1);
}

function expectOnlySentence(ending: Ending, sentence: RegExp): void {
  expect(ending.errors).toHaveLength(1);
  expectSentence(ending, sentence);
}

describe('Node', () => {
  test.each(['18.20.4', '20.18.9'])('%s is rejected by name, with the required version', (version) => {
    project.write(
      'old.cjs',
      `Object.defineProperty(process, 'versions', { value: { ...process.versions, node: '${version}' } });`,
    );
    const ending = project.node(['--require', './old.cjs', 'scripts/start.mjs']);
    expectOnlySentence(ending, new RegExp(`Node ${version} is too old: install Node 20\\.19\\.0 or newer`));
  });
});

describe('packages', () => {
  beforeEach(() => project.write('package-lock.json', JSON.stringify(LOCK)));

  test('without npm', () => {
    expectOnlySentence(project.setUp(['packages']), /^npm was not found: install it/);
  });

  test('when the download is rejected', () => {
    project.program(
      'npm',
      'echo "npm error code ECONNREFUSED" >&2; echo "npm error request to the registry failed" >&2; exit 1',
    );
    expectOnlySentence(
      project.setUp(['packages']),
      /^npm ci could not install the packages \(request to the registry failed\): check/,
    );
  });

  test('when the lock file does not match', () => {
    project.program('npm', 'echo "npm error code EUSAGE" >&2; exit 1');
    expectOnlySentence(
      project.setUp(['packages']),
      /^package-lock\.json does not match package\.json: run npm install/,
    );
  });

  test('are installed with npm ci and then fresh', () => {
    const found = JSON.stringify({ packages: { ...LOCK.packages, '': undefined } });
    project.program('npm', `[ "$1" = ci ] || exit 9; echo '${found}' > node_modules/.package-lock.json`);
    project.write('node_modules/three/package.json', '{}');
    const first = project.setUp(['packages']);
    expect(first).toMatchObject({ status: 0, errors: [] });
    expect(first.output).toMatch(/Node packages: done/);
    expect(project.setUp(['packages']).output).toBe('Already up to date: Node packages.\n');
  });

  test.each([
    ['another version', { 'node_modules/three': { version: '1.2.4', integrity: 'sha512-abc' } }],
    ['another content', { 'node_modules/three': { version: '1.2.3', integrity: 'sha512-xyz' } }],
    ['one too many', { ...LOCK.packages, 'node_modules/left-pad': { version: '1.0.0' } }],
    ['one too few', {}],
  ])('are stale with %s', (_, packages) => {
    installPackages();
    project.program('npm', 'exit 7');
    expect(project.setUp(['packages']).status).toBe(0);
    project.write('node_modules/.package-lock.json', JSON.stringify({ packages }));
    expect(project.setUp(['packages']).status).toBe(1);
  });

  test('are fresh without optional packages of other systems', () => {
    installPackages();
    const other = { version: '1.0.0', optional: true, os: ['plan9'] };
    project.write(
      'package-lock.json',
      JSON.stringify({ packages: { ...LOCK.packages, 'node_modules/esbuild-plan9': other } }),
    );
    expect(project.setUp(['packages']).status).toBe(0);
  });
});

describe('toolchain', () => {
  test.each(['start.mjs', 'test.mjs', 'build.mjs', 'preview.mjs'])(
    'without rustup, %s reports what to install',
    async (script) => {
      installPackages();
      // Not the default ports, because the demo may be running.
      const port = /start|preview/.test(script) ? ['--port', String(await findFreePort())] : [];
      expectOnlySentence(project.run(script, port), /^rustup was not found: install it from https:\/\/rustup\.rs/);
    },
  );

  test('when rustup cannot download', () => {
    project.program('rustup', 'exit 1');
    project.program('cargo', 'echo "error: could not download file" >&2; exit 1');
    expectOnlySentence(
      project.setUp(['toolchain']),
      /^rustup could not install the toolchain of sim-wasm\/rust-toolchain\.toml \(could not download file\): check the network/,
    );
  });

  test.each(PARTS)('is fresh, but not without %s', (missing) => {
    installRust('[ "$RUSTUP_AUTO_INSTALL" = 1 ] && exit 7');
    expect(project.setUp(['toolchain']).output).toBe('Already up to date: Rust toolchain.\n');
    installRust(
      '[ "$RUSTUP_AUTO_INSTALL" = 1 ] && exit 7',
      PARTS.filter((part) => part !== missing),
    );
    expect(project.setUp(['toolchain']).status).toBe(1);
  });

  test('is that of rustup when PATH does not name its folder, or names another cargo first', () => {
    project.program('rustup', 'exit 1');
    const environment = { PATH: project.path('programs'), CARGO_HOME: project.folder };
    expect(project.setUp(['toolchain'], environment).status).toBe(1);
    project.program('../bin/rustup', PARTS.map((part) => `echo ${part}`).join('; '));
    for (const PATH of [project.path('programs'), '/nowhere']) {
      expect(project.setUp(['toolchain'], { ...environment, PATH }).output).toMatch(/^Already up to date/);
    }
  });
});

describe('WASM', () => {
  test('that does not compile shows the compiler output, then the message', () => {
    installRust('echo "error[E0308]: mismatched types" >&2; exit 101');
    const ending = project.setUp(['wasm']);
    expectSentence(ending, /^The WASM build failed: see the compiler output above/);
    expect(ending.errors[0]).toBe('error[E0308]: mismatched types');
  });

  test('without a linker', () => {
    installRust('echo "error: linker \\`cc\\` not found" >&2; exit 101');
    expectOnlySentence(project.setUp(['wasm']), /^Rust found no linker \(cc\): install a C compiler/);
  });

  test('when the crates cannot be downloaded', () => {
    installRust(
      `printf 'error: failed to download from registry\\n\\nCaused by:\\n  [7] Could not connect to server\\n' >&2; exit 101`,
    );
    expectOnlySentence(
      project.setUp(['wasm']),
      /^cargo could not download the Rust crates \(\[7\] Could not connect to server\): check the network/,
    );
  });
});

describe('browser', () => {
  function installPlaywright(executable: string): void {
    project.write(
      'node_modules/playwright-core/index.mjs',
      `export const chromium = { executablePath: () => '${executable}' };`,
    );
    project.write(
      'node_modules/playwright/cli.js',
      `console.error('Error: getaddrinfo ENOTFOUND cdn.playwright.dev'); process.exit(1);`,
    );
  }

  test('that is missing at CHROMIUM_PATH', () => {
    expectOnlySentence(
      project.setUp(['browser'], { CHROMIUM_PATH: '/nowhere/chromium' }),
      /^CHROMIUM_PATH is \/nowhere\/chromium, which does not start as a browser/,
    );
  });

  test('that is missing and cannot be installed', () => {
    installPlaywright('/nowhere/chromium');
    expectOnlySentence(
      project.setUp(['browser']),
      /^No Chromium was found and none could be installed \(.+\): install Chromium/,
    );
  });

  test('is CHROMIUM_PATH, else Playwright’s, else one of the system', () => {
    const log = (name: string) => `echo ${name} >> ${project.path('log')}; echo Chromium 156`;
    for (const name of ['chosen', 'own', 'chromium']) project.program(name, log(name));
    const ask = (environment: Record<string, string> = {}) => {
      project.write('log', '');
      const ending = project.setUp(['browser'], environment);
      expect(ending.output).toBe('Already up to date: Browser for the tests.\n');
      return project.read('log').trim();
    };
    installPlaywright('/nowhere/chromium');
    expect(ask()).toBe('chromium');
    installPlaywright(project.path('programs/own'));
    expect(ask()).toBe('own');
    expect(ask({ CHROMIUM_PATH: project.path('programs/chosen') })).toBe('chosen');
  });

  test('of the system is skipped if it does not start', () => {
    installPlaywright('/nowhere/chromium');
    project.program('chromium', 'echo "install the snap"; exit 1');
    project.program('google-chrome', 'echo Google Chrome 156');
    expect(project.setUp(['browser']).status).toBe(0);
  });

  test('is installed by playwright install if there is none', () => {
    installPlaywright(project.path('programs/own'));
    project.write(
      'node_modules/playwright/cli.js',
      `require('node:fs').writeFileSync('${project.path('programs/own')}', '#!/bin/sh\\necho Chromium 159', { mode: 0o755 });`,
    );
    const ending = project.setUp(['browser']);
    expect(ending).toMatchObject({ status: 0, errors: [] });
    expect(ending.output).toMatch(/Browser for the tests: done/);
  });
});

describe('engines', () => {
  const bring = (environment: Record<string, string> = {}) =>
    project.node(
      [
        '--input-type=module',
        '--eval',
        `import { conclude } from './scripts/lib/userError.mjs';
         import { setUp } from './scripts/setup/setup.mjs';
         import { ENGINES } from './scripts/setup/engines.mjs';
         await conclude(async () => {
           await setUp(ENGINES);
           for (const { find } of ENGINES) console.log(JSON.stringify(await find()));
         });`,
      ],
      environment,
    );
  const installPlaywright = (path: string, launch: string) => {
    const type = `{ executablePath: () => '${path}', launch: async () => { ${launch} } }`;
    project.write('node_modules/playwright-core/index.mjs', `export const firefox = ${type}, webkit = ${type};`);
    project.write('node_modules/playwright/cli.js', `console.error('Error: no network'); process.exit(1);`);
  };

  test('are Playwright’s if they start', () => {
    installPlaywright(process.execPath, 'return { close: async () => {} };');
    expect(bring().output.split('\n')).toContain(
      JSON.stringify({ name: 'firefox', isPlaywrights: true, path: process.execPath }),
    );
  });

  test('are named if they cannot be installed', () => {
    installPlaywright(process.execPath, 'throw new Error();');
    expectOnlySentence(bring(), /^Firefox could not be installed \(.*Error: no network\)\.$/);
  });

  const isDebianRoot = process.getuid?.() === 0 && existsSync('/etc/debian_version');
  test.runIf(isDebianRoot)('are packages of Debian for root', () => {
    installPlaywright('/nowhere/firefox', '');
    project.program('apt-get', `echo "$@" >> ${project.path('log')}`);
    bring();
    expect(project.read('log')).toMatch(
      /^update\ninstall --yes --no-install-recommends firefox-esr xvfb libgl1-mesa-dri/,
    );
  });
});
