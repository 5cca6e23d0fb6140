/** Media queries of windows in which parts of the page start open or closed. */

/** On a phone the panel covers half of the smoke, so it starts closed. */
export const ROOMY = '(min-width: 701px) and (min-height: 501px)';

/** In lower windows, such as phones in landscape, the gallery starts closed, and closes on rotation. */
export const LOW = '(max-height: 599px)';
