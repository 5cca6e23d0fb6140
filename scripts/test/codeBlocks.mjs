/** Compiles the code blocks of README.md and docs/ against the sources of the package. */

import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';

const FOLDER = '.cache/code-blocks';
const BLOCK = /^```(tsx?|js|html)\b.*\n([^]*?)^```/gm;
const MODULE = /<script type="module">([^]*?)<\/script>/g;

/** The objects that blocks mention without making them. Another one needs a type here, or a declaration in its block. */
const GIVEN = `
import type * as smoke from 'cartoon-smoke';
import type * as three from 'three';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'cartoon-smoke': Record<string, unknown>;
    }
  }
}

declare global {
  const smoke: smoke.CartoonSmoke;
  const fire: smoke.CartoonSmoke;
  const stage: smoke.Stage;
  const cartoonSmoke: smoke.Stage;
  const renderer: three.WebGLRenderer;
  const scene: three.Scene;
  const camera: three.PerspectiveCamera;
  const keyLight: three.DirectionalLight;
  const sun: three.DirectionalLight;
  const canvas: HTMLCanvasElement;
  const container: HTMLElement;
  const card: HTMLElement;
  const button: HTMLButtonElement;
  const seconds: number;
  const size: three.Vector2;
  const save: (frame: number, picture: Blob) => void;
  const hit: { point: three.Vector3; normal: three.Vector3 };
  const [shoulder, hand]: three.Vector3[];
  const [positions, indices]: [Float32Array, Uint32Array];
  const [normalDepth, colorCoverage]: [ImageData, ImageData];
  const [firstCanvas, secondCanvas]: HTMLCanvasElement[];
  const arm: three.Object3D;
  const car: three.Object3D;
  const cauldron: three.Object3D;
  const chimney: three.Object3D;
  const door: three.Object3D;
  const knight: three.Object3D;
  const lantern: three.Object3D;
  const locomotive: three.Object3D;
  const propeller: three.Object3D;
  const robot: three.Object3D;
  const ship: three.Object3D;
}
`;

/** Names that blocks use without importing them again. */
const IMPORTED = {
  three: ['WebGLRenderer', 'WebGLCubeRenderTarget', 'CubeCamera', 'PlaneGeometry', 'HalfFloatType'],
  'three/examples/jsm/objects/Reflector.js': ['Reflector'],
  'three/examples/jsm/postprocessing/EffectComposer.js': ['EffectComposer'],
  'three/examples/jsm/postprocessing/OutputPass.js': ['OutputPass'],
  'three/examples/jsm/postprocessing/RenderPass.js': ['RenderPass'],
  'three/examples/jsm/postprocessing/UnrealBloomPass.js': ['UnrealBloomPass'],
  'cartoon-smoke': [
    'CartoonSmoke',
    'CartoonSmokeElement',
    'capsule',
    'drawPuff',
    'fitPuff',
    'presetValues',
    'readPuffSheet',
    'type Point',
    'writePuffSheet',
  ],
};

/** Packages of other projects, and entries whose types only the package has: tests of the package compile with those. */
const OTHERS = ['remotion', '@vitejs/plugin-vue', 'cartoon-smoke/react', 'cartoon-smoke/preact', 'cartoon-smoke/solid'];

const CONFIG = {
  extends: '../../examples/tsconfig.json',
  compilerOptions: {
    noUnusedLocals: false,
    noUnusedParameters: false,
    paths: { 'cartoon-smoke': ['../../src/index.ts'], 'cartoon-smoke/*': ['../../src/*.ts'] },
  },
  include: ['.', '../../src/page/clip/gifenc.d.ts'],
};

/**
 * @param {(line: string) => void} say
 * @returns {Promise<import('../lib/command.mjs').Outcome>} with the place of each error in its document
 */
export async function compileCodeBlocks(say) {
  const folder = inRoot(FOLDER);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const documents = [
    'README.md',
    ...readdirSync(inRoot('docs'))
      .filter((name) => name.endsWith('.md'))
      .map((name) => `docs/${name}`),
  ];
  const blocks = documents.flatMap(blocksOf);
  for (const { name, code } of blocks) writeFileSync(`${folder}/${name}`, code);
  const others = OTHERS.map((name) => `declare module '${name}';`).join('\n');
  writeFileSync(`${folder}/given.d.ts`, GIVEN);
  writeFileSync(`${folder}/others.d.ts`, others);
  writeFileSync(`${folder}/tsconfig.json`, JSON.stringify(CONFIG));
  const { output } = await runScript('node_modules/typescript/bin/tsc', ['--noEmit', '-p', FOLDER], { onLine: say });
  const errors = output.split('\n').filter((line) => /error TS/.test(line) && !isOfPlainCode(line));
  const places = errors.map((line) => placed(line, blocks));
  if (blocks.length === 0) places.push('No code block was found.');
  return { status: places.length > 0 ? 1 : 0, output: places.join('\n') };
}

/**
 * @typedef {object} Block
 * @property {string} name of its file
 * @property {string} code
 * @property {string} document
 * @property {number} line of its first line in the document, minus its line in the file
 */

/** @returns {Block[]} */
function blocksOf(/** @type {string} */ document) {
  const text = readFileSync(inRoot(document), 'utf8');
  return [...text.matchAll(BLOCK)].flatMap((match) => {
    const [, language, code] = match;
    const start = text.slice(0, match.index).split('\n').length + 1;
    const plain = language === 'js' || language === 'html' ? '.plain' : '';
    const name = `${document.replace(/\W/g, '-')}-${start}${plain}.${language === 'tsx' ? 'tsx' : 'ts'}`;
    if (language !== 'html') return [block(name, code, document, start)];
    return [...code.matchAll(MODULE)].map((script, at) =>
      block(`${at}-${name}`, script[1], document, start + code.slice(0, script.index).split('\n').length - 1),
    );
  });
}

/** @param {string} name @param {string} code @param {string} document @param {number} start @returns {Block} */
function block(name, code, document, start) {
  const lines = Object.entries(IMPORTED).flatMap(([module, names]) => {
    const missing = names.filter((each) => !new RegExp(`\\bimport\\b[^;]*\\b${each}\\b`).test(code));
    return missing.length > 0 ? [`import { ${missing.join(', ')} } from '${module}';`] : [];
  });
  return { name, code: `${[...lines, code].join('\n')}\nexport {};\n`, document, line: start - lines.length - 1 };
}

/** In JavaScript, readers expect that what a selector finds exists. */
function isOfPlainCode(/** @type {string} */ line) {
  return /\.plain\.ts\(/.test(line) && /\bnull\b/.test(line);
}

/** @param {string} error @param {Block[]} blocks */
function placed(error, blocks) {
  const [, name, line, message] = /([^/]+\.tsx?)\((\d+),\d+\): error (.+)$/.exec(error) ?? [];
  const found = blocks.find((each) => each.name === name);
  return found ? `${found.document}:${Number(line) + found.line}: ${message}` : error;
}
