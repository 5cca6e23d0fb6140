/** The parameter table of the sources, for scripts. */

import { sourceModule } from './sourceModule.mjs';

/** @typedef {import('../../src/parameters/words/words.ts').Parameter} Parameter */

/** @type {{ table: Parameter[] }} */
export const { table } = await sourceModule('src/parameters/words/table.ts');
/** @type {typeof import('../../src/page/element/attributes/names.ts')} */
export const { names } = await sourceModule('src/page/element/attributes/names.ts');

/** Keys of the second to the last item of a list. The first item represents all of them. */
export const OF_LATER_ITEMS = /^\w+\.[1-7]\./;
