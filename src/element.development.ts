/** `cartoon-smoke/element` with warnings. */
import './element/warnings.ts';
export { CartoonSmokeElement } from './element/define.ts';
