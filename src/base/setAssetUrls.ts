/** Sets the URLs of assetUrls.ts. In a module of its own, because few pages call it. */
import { urls, type AssetUrls } from './assetUrls.ts';
import { ParameterError, requireOptions } from './errors.ts';

const NAMES = ['core', 'meshes', 'physics', 'stageModel', 'worker'];

/**
 * Sets where the library fetches its files. Applies to downloads that start after the call; files that are not named
 * keep their URLs.
 * @throws ParameterError if a name is unknown or a value is no URL. Nothing is changed then
 */
export function setAssetUrls(given: AssetUrls): void {
  requireOptions('setAssetUrls', given, NAMES);
  const resolved = Object.entries(given).map(([name, url]) => [name, resolve(name, url)] as const);
  for (const [name, url] of resolved) urls.set(name, url);
}

function resolve(name: string, url: unknown): string {
  try {
    if (typeof url === 'string' ? url : (url as URL).href)
      return new URL(String(url), globalThis.document?.baseURI).href;
  } catch {
    // The same error as for values that are no strings.
  }
  throw new ParameterError(`setAssetUrls.${name}`, url, 'a URL');
}
