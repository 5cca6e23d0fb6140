/**
 * The URL at which the site will be published, for files that need absolute URLs. The site itself works in any folder.
 */

import { UserError } from '../lib/userError.mjs';

/**
 * @param {string} [text] the value of CARTOON_SMOKE_BASE
 * @returns {string | undefined} URL of the site's folder, with a trailing slash; undefined when not set
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
