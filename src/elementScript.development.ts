/** The single file of the element for CDNs, with warnings. */
import './page/element/warnings.ts';
export { CartoonSmokeElement } from './elementScript.ts';
