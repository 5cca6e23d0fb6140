/** Windows in which parts of the page are open at first, as media queries. */

/** On a phone the panel covers half of the smoke, so it starts closed. */
export const ROOMY = '(min-width: 701px) and (min-height: 501px)';

/** In lower windows, such as phones in landscape, the gallery starts closed, and closes on rotation. */
export const LOW = '(max-height: 599px)';
