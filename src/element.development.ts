/** `cartoon-smoke/element` with warnings. */
import './page/element/warnings.ts';
export { CartoonSmokeElement } from './page/element/define.ts';
