/**
 * Generates the element's type declarations from the parameter table: its properties, and its attributes for frameworks
 * that check markup. Attributes are spelled as in HTML, because server rendering writes them unchanged.
 */

import { mkdirSync, appendFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { typeOf } from './customElements.mjs';
import { names, OF_LATER_ITEMS, table } from './parameters.mjs';
import { sourceModule } from './sourceModule.mjs';

/** @typedef {import('../../src/preset/parameter.ts').Parameter} Parameter */

/** @type {typeof import('../../src/element/documentation.ts')} */
const { attributes } = await sourceModule('src/element/documentation.ts');

/**
 * For each framework, the module that declares its elements and the base type of an element's markup.
 *
 * @type {Record<string, { module: string, own: string }>}
 */
const FRAMEWORKS = {
  react: { module: 'react', own: 'DetailedHTMLProps<HTMLAttributes<CartoonSmokeElement>, CartoonSmokeElement>' },
  preact: { module: 'preact', own: "import('preact').HTMLAttributes<CartoonSmokeElement>" },
  solid: { module: 'solid-js/jsx-runtime', own: 'HTMLAttributes<CartoonSmokeElement>' },
};
const EVENTS = ['ready', 'error', 'statechange'];

/** @param {string} folder of the declarations written by the compiler */
export function writeElementTypes(folder) {
  const element = join(folder, 'element');
  writeFileSync(join(element, 'parameterProperties.d.ts'), properties());
  appendFileSync(join(element, 'cartoonSmokeElement.d.ts'), MERGED);
  appendFileSync(join(folder, 'index.d.ts'), EXPORTED);
  writeFileSync(join(element, 'attributes.d.ts'), markup());
  mkdirSync(join(folder, 'jsx'), { recursive: true });
  for (const [name, one] of Object.entries(FRAMEWORKS)) {
    writeFileSync(join(folder, `jsx/${name}.d.ts`), framework(one));
  }
}

const MERGED = `import type { ParameterProperties } from './parameterProperties.js';
export interface CartoonSmokeElement extends ParameterProperties {}
`;

const EXPORTED = `export type { ParameterProperties } from './element/parameterProperties.js';\n`;

function properties() {
  const lines = rows().map(
    ({ row, property }) =>
      `${comment(row)}  get ${property}(): ${typeOf(row)} | undefined;\n  set ${property}(value: ${settable(row)} | null | undefined);`,
  );
  return `/** Every parameter as a property; undefined where the preset decides. */\nexport interface ParameterProperties {\n${lines.join('\n')}\n}\n`;
}

function markup() {
  const own = attributes.map(
    ({ name, type, description }) =>
      `  /** ${description} */\n  '${name}'?: ${type.text === 'number' ? 'number | string' : type.text} | undefined;`,
  );
  const parameters = rows().map(
    ({ row, attribute }) => `${comment(row)}  '${attribute}'?: ${settable(row)} | undefined;`,
  );
  const events = EVENTS.map(
    (name) => `  on${name}?: ((event: CustomEvent<SmokeEvents['${name}']>) => unknown) | undefined;`,
  );
  return `import type { SmokeEvents } from './events.js';
/** What the element takes in markup. */
export interface SmokeAttributes {
${[...own, ...parameters].join('\n')}
}
/** Its events, where a framework listens to what follows \`on\`. */
export interface SmokeListeners {
${events.join('\n')}
}
`;
}

/** @param {{ module: string, own: string }} of */
function framework({ module, own }) {
  return `import type {} from '${module}';
import type { SmokeAttributes, SmokeListeners } from '../element/attributes.js';
import type { CartoonSmokeElement } from '../element/cartoonSmokeElement.js';
declare module '${module}' {
  namespace JSX {
    interface IntrinsicElements {
      'cartoon-smoke': Omit<${own}, keyof (SmokeAttributes & SmokeListeners)> & SmokeAttributes & SmokeListeners;
    }
  }
}
export * from '../element/define.js';
`;
}

/** The rows of the table with their attribute and property names. */
function rows() {
  return names.flatMap(({ key, ...name }) => {
    const row = table.find((each) => each.key === key);
    return row ? [{ row, ...name }] : [];
  });
}

/**
 * Numbers can be strings, as in all attributes.
 * @param {Parameter} row
 */
function settable(row) {
  const type = typeOf(row);
  return /\b(number|\d)\b/.test(type) ? 'number | string' : type;
}

/**
 * Only the first item of a list has a comment; it applies to the others.
 * @param {Parameter} row
 */
function comment({ key, label, text }) {
  return OF_LATER_ITEMS.test(key) ? '' : `  /** ${label}: ${text} */\n`;
}
