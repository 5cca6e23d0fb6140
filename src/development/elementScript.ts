/** The single file of the element for CDNs, with warnings. */
export { CartoonSmokeElement } from './element.ts';
import '../element/script.ts';
