/** Exports of `cartoon-smoke/element`, which defines `<cartoon-smoke>`. No module of the library imports this file. */
export { CartoonSmokeElement } from './page/element/define.ts';
