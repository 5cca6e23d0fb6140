/** Where the site will stand, for what must be told in whole addresses. The site itself works from any folder. */

import { UserError } from '../lib/userError.mjs';

/**
 * @param {string} [text] what CARTOON_SMOKE_BASE says
 * @returns {string | undefined} address of the site's folder, ending with a slash; undefined when nobody told
 */
export function publishedAt(text = process.env.CARTOON_SMOKE_BASE) {
  if (!text) return undefined;
  const address = URL.canParse(text) ? new URL(text) : undefined;
  if (!address || !/^https?:$/.test(address.protocol) || /[?#]/.test(text)) {
    throw new UserError(
      `CARTOON_SMOKE_BASE is ${text}: give the whole address of the site's folder, such as https://example.org/smoke/.`,
    );
  }
  return address.href.endsWith('/') ? address.href : `${address.href}/`;
}
