/** Bundles the sources into the ES modules of the package and the script for CDNs. */

import { copyFileSync, mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import browserslistToEsbuild from 'browserslist-to-esbuild';
import { rolldown } from 'rolldown';
import glsl from 'vite-plugin-glsl';
import { inRoot, root } from '../lib/paths.mjs';
import { smallThree } from '../patches/three.mjs';

const LICENSES =
  '/*! cartoon-smoke, MIT license. Contains three.js, MIT license, Copyright 2010-2026 three.js authors; third-party-licenses.txt beside it has all. */';
/** The script for CDNs, and the module that adds warnings to it. */
const SCRIPT = 'cartoon-smoke.min';
const SCRIPT_WITH_WARNINGS = 'cartoon-smoke.development';
/**
 * A single file.
 * @type {import('rolldown').OutputOptions}
 */
const ALONE = { codeSplitting: false, postBanner: LICENSES };
/**
 * Groups modules that are fetched together into one file, which also compresses better: the code that waits for the
 * viewport; the code between an element and its stage, with the table; the renderer, and the shaders that each smoke
 * needs, which compress better side by side; and the models that most scenes share.
 */
const TOGETHER = [
  // What `puff()` and the element have in common before their first smoke.
  { name: 'zoom', test: /page\/zoom\.ts$/, priority: 4 },
  { name: 'errors', test: /base\/errors\.ts$/, priority: 4 },
  {
    name: 'shaders',
    test: /\/shaders\/(backdrop|bodies\/lobes|lib|mask|meshVolumes|resolve|selfTest|surfaces|volumes)\b/,
    priority: 4,
  },
  {
    name: 'cartoonSmokeElement',
    test: /element\/(cartoonSmokeElement|attributes\/names)\.ts$/,
    priority: 3,
  },
  {
    name: 'session',
    test: /src\/(base\/assetUrls|parameters\/(table|values|notice|quality)|simulator\/clock|stage\/(listeners|remote\/(openStage|makeMethods))|page\/(size|element\/(change|playback|session|attributes\/parsedAttributes)))\.ts$/,
    priority: 2,
  },
  { name: 'stage', test: /src\/stage\/remote\/openHere\.ts$/, priority: 1 },
  {
    name: 'models',
    test: /src\/(simulator\/exact\/(sine|rotation)|scenes\/models\/(lathe|place|ball|revolve))\.ts$/,
  },
];
/** @type {import('rolldown').OutputOptions} */
const SPLIT = { codeSplitting: { groups: TOGETHER } };
/** Every build refers to it by its file, so that the classes of errors are the same in all. */
const ERRORS = { errors: 'src/base/errors.ts' };
/**
 * Models, a build of its own that imports nothing: the worker and the script for CDNs are one file each, so they load it by its
 * URL, and bundlers copy it unchanged.
 */
const MODEL = { stageModel: 'src/stage/model/stageModel.ts' };
/** The encoders of clips, a build of its own that imports nothing: `clip()` starts the file as a worker, or imports it. */
const CLIP_FILES = { clipFiles: 'src/page/clip/files.ts' };
/** Smoke in the three.js scenes of others, a build of its own. */
const HOSTED = { cartoonSmoke: 'src/three/cartoonSmoke.ts', proxies: 'src/three/proxies.ts' };
/** What modules with warnings wrap, by its file. */
const WRAPPED = {
  index: 'src/index.ts',
  clip: 'src/clip.ts',
  element: 'src/page/element/define.ts',
  cartoonSmoke: HOSTED.cartoonSmoke,
  fiber: 'src/fiber.ts',
  puff: 'src/puff.ts',
};

/**
 * Writes the modules of the package, with separate chunks for deferred code and without three.js, and the script for
 * CDNs. Copies the simulator beside them.
 *
 * `CartoonSmoke` is a build of its own, because a page has either it or, on its main thread, the element. Shared chunks would
 * make each load code of the other: bundlers keep what a module that they can reach loads on demand.
 *
 * @param {string} folder
 * @param {import('rolldown').RolldownPluginOption[]} [plugins] that reduce the size
 */
export async function bundleAll(folder, plugins = shrinking()) {
  const modules = {
    index: 'src/index.ts',
    clip: 'src/clip.ts',
    element: 'src/element.ts',
    puff: 'src/puff.ts',
    ...ERRORS,
  };
  const external = /^(three|react|@react-three\/fiber)(\/|$)/;
  const ofPage = [
    ...plugins,
    stageWorkerAt('./worker.js'),
    workerAt(/page\/clip\/encoder\.ts$/, './files.ts', './clipFiles.js'),
    ownLayout(),
    beside({ ...HOSTED, ...MODEL, ...CLIP_FILES }),
  ];
  await bundle({ input: entries(modules), external, plugins: ofPage }, folder, SPLIT);
  const hosted = entries({ ...HOSTED, fiber: 'src/fiber.ts' });
  // Its volumes are always counted.
  const checks = { ...SMALL.checks, ineffectiveDynamicImport: false };
  await bundle({ input: hosted, external, plugins: [...plugins, beside(ERRORS)], checks }, folder, {
    chunkFileNames: 'cartoonSmoke-[name].js',
    codeSplitting: { groups: [{ name: 'host', test: /src\/three\/(cartoonSmoke|hostPasses)\.ts$/ }] },
  });
  // Includes three.js: import maps do not apply to workers, and bundlers do not share a file between a page and its
  // worker.
  const ofWorker = [...plugins, modelByUrl()];
  await bundle({ input: entries({ worker: 'src/stage/remote/worker.ts' }), plugins: ofWorker }, folder, ALONE);
  // A separate build: otherwise the others would share its chunks. It shares the error classes with them.
  await bundle({ input: entries({ preset: 'src/preset.ts' }), plugins: [beside(ERRORS)] }, folder);
  await bundle({ input: entries(CLIP_FILES) }, folder, ALONE);
  await bundleWarnings(join(folder, 'development'));
  await bundleScript(folder, plugins);
  await bundleScriptWarnings(folder);
}

/**
 * Writes the modules with warnings. They import the other modules of the package, which stay the same without them.
 * @param {string} folder
 */
async function bundleWarnings(folder) {
  const names = ['index', 'clip', 'element', 'fiber', 'puff'];
  const input = entries(Object.fromEntries(names.map((name) => [name, `src/${name}.development.ts`])));
  const chunks = { minify: false, chunkFileNames: 'shared-[name].js' };
  await bundle({ input, external: 'three', plugins: [beside(WRAPPED, '../')] }, folder, chunks);
}

/**
 * Writes only the script for CDNs, with the simulator and the code of models beside it.
 *
 * @param {string} folder
 * @param {import('rolldown').RolldownPluginOption[]} [plugins] that reduce the size
 */
export async function bundleScript(folder, plugins = shrinking()) {
  const input = entries({ [SCRIPT]: 'src/script.ts' });
  await bundle({ input, plugins: [...plugins, stageWorkerAt(`./${SCRIPT}.js`), modelByUrl()] }, folder, ALONE);
  await bundle({ input: entries(MODEL) }, folder, ALONE);
  copyWasm(folder, ['core', 'meshes', 'physics']);
}

/**
 * Writes the module that imports the script for CDNs and adds warnings.
 * @param {string} folder
 */
async function bundleScriptWarnings(folder) {
  const input = entries({ [SCRIPT_WITH_WARNINGS]: 'src/script.development.ts' });
  const plugins = ['src/script.ts', 'src/page/element/define.ts'].map((source) => beside({ [SCRIPT]: source }));
  await bundle({ input, plugins }, folder, { codeSplitting: false, minify: false });
}

/**
 * Writes the page that renders films. Its simulator is beside the modules of the package, in the folder `wasm`, and three.js
 * comes from the package `three`, see `scripts/film/server.mjs`.
 *
 * @param {string} folder
 */
export async function bundleFilmPage(folder) {
  // The presets are loaded one by one elsewhere; here the link needs all of them.
  const checks = { ...SMALL.checks, ineffectiveDynamicImport: false };
  const input = entries({ page: 'src/demo/film/page.ts' });
  await bundle({ input, external: 'three', plugins: shrinking(), checks }, folder);
}

/**
 * Writes the command `cartoon-smoke` as one file for Node.
 *
 * @param {string} folder
 */
export async function bundleCommand(folder) {
  const build = await rolldown({ input: inRoot('scripts/film/command.mjs'), platform: 'node' });
  await build.write({ dir: folder, format: 'esm', entryFileNames: '[name].js', codeSplitting: false, minify: true });
  await build.close();
}

/** Plugins that load the shaders without comments and white space, and three.js without what no pass uses. */
export function shrinking() {
  return [glsl({ minify: true }), ...smallThree()];
}

/**
 * Options of all bundles for other people's pages.
 * @type {import('rolldown').InputOptions}
 */
export const SMALL = {
  cwd: root,
  platform: 'browser',
  tsconfig: false,
  // Removes fault injection, and class fields that are only type declarations.
  transform: {
    target: browserslistToEsbuild(),
    define: { 'import.meta.env.DEV': 'false' },
    typescript: { removeClassFieldsWithoutInitializer: true },
  },
  // Modules of the table have no effects: without this, it stays in files that do not use it.
  treeshake: { moduleSideEffects: (id) => !/src\/(base|parameters)\//.test(id) },
  // Shaders have no source maps. A busy machine is no reason for a warning. An entry keeps its 'use client'.
  checks: { sourcemapBroken: false, bundlerTimings: false, moduleLevelDirective: false },
};

/**
 * @param {import('rolldown').InputOptions} input
 * @param {string} folder
 * @param {import('rolldown').OutputOptions} [output]
 */
async function bundle(input, folder, output = {}) {
  const build = await rolldown({ ...SMALL, ...input });
  await build.write({
    dir: folder,
    format: 'esm',
    minify: true,
    // Only for the list of licences: the package contains no source maps.
    sourcemap: 'hidden',
    entryFileNames: '[name].js',
    chunkFileNames: chunkName,
    ...output,
  });
  await build.close();
}

/**
 * Scenes and their presets have the same file names, so presets get a suffix.
 * @type {import('rolldown').OutputOptions['chunkFileNames']}
 */
const chunkName = ({ moduleIds }) =>
  moduleIds.every((id) => id.includes('/byScene/')) ? '[name]Presets.js' : '[name].js';

/** @param {Record<string, string>} input */
function entries(input) {
  return Object.fromEntries(Object.entries(input).map(([name, path]) => [name, inRoot(path)]));
}

/** @param {string} address of the file in the package */
const stageWorkerAt = (address) => workerAt(/src\/stage\/remote\/pageWorker\.ts$/, './worker.ts', address);

/**
 * Replaces a worker's URL by its file in the package.
 * @param {RegExp} starter the module that starts it
 * @param {string} source its URL there
 * @param {string} address
 * @returns {import('rolldown').Plugin}
 */
function workerAt(starter, source, address) {
  let isReplaced = false;
  return {
    name: 'worker-at',
    transform: {
      filter: { id: starter },
      handler(code) {
        isReplaced = code.includes(`new URL('${source}'`);
        // Imports of the same file are resolved as usual.
        return code.replaceAll(`'${source}'`, (text, at) =>
          code.slice(0, at).endsWith('import(') ? text : `'${address}'`,
        );
      },
    },
    buildEnd() {
      if (!isReplaced) throw new Error(`No module in the bundle has the URL ${source} of a worker.`);
    },
  };
}

/**
 * Loads the code of models by its URL, which no bundler follows.
 * @returns {import('rolldown').Plugin}
 */
function modelByUrl() {
  const address = "assetUrl('stageModel') ?? servedUrl(new URL('./stageModel.js', import.meta.url).href)";
  const imported = `import(/* @vite-ignore */ /* webpackIgnore: true */ /* turbopackIgnore: true */ ${address})`;
  return modelBy(imported, "import { assetUrl, servedUrl } from '../base/assetUrls.ts';\n");
}

/**
 * Gets the code of models in another way than by an import.
 * @param {string} expression a promise of the module
 * @param {string} [head] imports of the expression
 * @returns {import('rolldown').Plugin}
 */
export function modelBy(expression, head = '') {
  const found = "import('./model/stageModel.ts')";
  return {
    name: 'model-by',
    transform: {
      filter: { id: /src\/stage\/modelLoading\.ts$/ },
      handler(code) {
        if (!code.includes(found)) throw new Error(`modelLoading.ts lacks ${found}.`);
        return head + code.replace(found, expression);
      },
    },
  };
}

/**
 * Imports modules from their files in the package.
 * @param {Record<string, string>} modules their sources by the names of their files
 * @param {string} place of these files
 * @returns {import('rolldown').Plugin}
 */
function beside(modules, place = './') {
  const files = new Map(Object.entries(modules).map(([name, source]) => [inRoot(source), `${place}${name}.js`]));
  return {
    name: 'beside',
    resolveId(source, importer) {
      const id = importer && files.get(join(dirname(importer), source));
      return id ? { id, external: true } : undefined;
    },
  };
}

/**
 * A copy of the layout of rows for clips. If they shared it with the core, the core would contain all of it, instead of the few
 * numbers that it uses.
 * @returns {import('rolldown').Plugin}
 */
function ownLayout() {
  const file = inRoot('src/simulator/layout.ts');
  const copy = `${file}?clip`;
  return {
    name: 'own-layout',
    resolveId(source, importer) {
      return importer?.includes('/page/clip/') && source.endsWith('/simulator/layout.ts') ? copy : undefined;
    },
    load(id) {
      return id === copy ? { code: readFileSync(file, 'utf8'), moduleType: 'ts' } : undefined;
    },
  };
}

/**
 * The simulator loads from the folder of the module that imports it.
 * @param {string} folder
 * @param {string[]} variants
 */
function copyWasm(folder, variants) {
  for (const file of variants.map((variant) => `wasm/${variant}/bindings_bg.wasm`)) {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    copyFileSync(inRoot(`src/simulator/${file}`), join(folder, file));
  }
}
