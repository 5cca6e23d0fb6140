/** The single file of the element for CDNs, with warnings. */
import './element/warnings.ts';
export { CartoonSmokeElement } from './elementScript.ts';
