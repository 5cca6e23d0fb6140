/**
 * Generates the element's type declarations from the parameter table: its properties, and its attributes for frameworks
 * that check markup. Attributes are spelled as in HTML, because server rendering writes them unchanged.
 */

import { mkdirSync, appendFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { typeOf } from './customElements.mjs';
import { names, OF_LATER_ITEMS, table } from './parameters.mjs';
import { sourceModule } from './sourceModule.mjs';

/** @typedef {import('../../src/parameters/words/words.ts').Parameter} Parameter */

/** @type {typeof import('../../src/page/element/documentation.ts')} */
const { attributes } = await sourceModule('src/page/element/documentation.ts');

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
/** Frameworks with templates of their own. */
const TEMPLATES = {
  svelte: `import type { HTMLAttributes } from 'svelte/elements';
import type { SmokeAttributes, SmokeListeners } from '../page/element/attributes.js';
import type { CartoonSmokeElement } from '../page/element/cartoonSmokeElement.js';
declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'cartoon-smoke': Omit<HTMLAttributes<CartoonSmokeElement>, keyof (SmokeAttributes & SmokeListeners)> & SmokeAttributes & SmokeListeners;
  }
}
export * from '../element.js';
`,
  vue: `import type { DefineComponent } from 'vue';
import type { SmokeAttributes } from '../page/element/attributes.js';
import type { SmokeEvents } from '../page/element/events.js';
type CamelCase<Name> = Name extends \`\${infer Head}-\${infer Tail}\` ? \`\${Head}\${Capitalize<CamelCase<Tail>>}\` : Name;
/** Attributes as templates compare them, in camel case, and events. */
export type SmokeProps = { [Name in keyof SmokeAttributes as CamelCase<Name>]: SmokeAttributes[Name] } & {
  [Name in keyof SmokeEvents as \`on\${Capitalize<Name>}\`]?: (event: CustomEvent<SmokeEvents[Name]>) => unknown;
};
declare module 'vue' {
  interface GlobalComponents {
    'cartoon-smoke': DefineComponent<SmokeProps>;
  }
}
export * from '../element.js';
`,
};
const EVENTS = ['ready', 'error', 'statechange'];

/** @param {string} folder of the declarations written by the compiler */
export function writeElementTypes(folder) {
  const element = join(folder, 'page/element');
  writeFileSync(join(element, 'parameterProperties.d.ts'), properties());
  appendFileSync(join(element, 'cartoonSmokeElement.d.ts'), MERGED);
  appendFileSync(join(folder, 'index.d.ts'), EXPORTED);
  writeFileSync(join(element, 'attributes.d.ts'), markup());
  mkdirSync(join(folder, 'jsx'), { recursive: true });
  for (const [name, one] of Object.entries(FRAMEWORKS)) {
    writeFileSync(join(folder, `jsx/${name}.d.ts`), framework(one));
  }
  for (const [name, text] of Object.entries(TEMPLATES)) writeFileSync(join(folder, `jsx/${name}.d.ts`), text);
}

const MERGED = `import type { ParameterProperties } from './parameterProperties.js';
export interface CartoonSmokeElement extends ParameterProperties {}
`;

const EXPORTED = `export type { ParameterProperties } from './page/element/parameterProperties.js';\n`;

function properties() {
  const lines = rows().map(({ row, property, isListed }) =>
    isListed
      ? `${comment(row)}  [property: \`${property}\`]: ${settable(row)} | null | undefined;`
      : `${comment(row)}  get ${property}(): ${typeOf(row)} | undefined;\n  set ${property}(value: ${settable(row)} | null | undefined);`,
  );
  return `/** Every parameter as a property; undefined where the preset decides. */\nexport interface ParameterProperties {\n${lines.join('\n')}\n}\n`;
}

function markup() {
  const own = attributes.map(
    ({ name, type, description }) =>
      `  /** ${description} */\n  '${name}'?: ${name === 'preset' ? 'PresetName' : type.text === 'number' ? 'number | string' : type.text} | undefined;`,
  );
  const parameters = rows().map(({ row, attribute, isListed }) => {
    const name = isListed ? `[attribute: \`${attribute}\`]` : `'${attribute}'?`;
    return `${comment(row)}  ${name}: ${settable(row)} | undefined;`;
  });
  const events = EVENTS.map(
    (name) => `  on${name}?: ((event: CustomEvent<SmokeEvents['${name}']>) => unknown) | undefined;`,
  );
  return `import type { PresetName } from '../../parameters/valueTypes.js';
import type { SmokeEvents } from './events.js';
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
import type { SmokeAttributes, SmokeListeners } from '../page/element/attributes.js';
import type { CartoonSmokeElement } from '../page/element/cartoonSmokeElement.js';
declare module '${module}' {
  namespace JSX {
    interface IntrinsicElements {
      'cartoon-smoke': Omit<${own}, keyof (SmokeAttributes & SmokeListeners)> & SmokeAttributes & SmokeListeners;
    }
  }
}
export * from '../element.js';
`;
}

/**
 * The rows of the table with their attribute and property names. The names of list items are patterns, which type
 * checkers accept but editors do not suggest: there are thousands of them.
 */
function rows() {
  return names.flatMap(({ key, attribute, property }) => {
    const row = table.find((each) => each.key === key);
    if (!row || OF_LATER_ITEMS.test(key)) return [];
    const isListed = /^\w+\.0\./.test(key);
    const any = (/** @type {string} */ name) => (isListed ? name.replace('0', '${number}') : name);
    return [{ row, isListed, attribute: any(attribute), property: any(property) }];
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

/** @param {Parameter} row */
function comment({ label, text }) {
  return `  /** ${label}: ${text} */\n`;
}
