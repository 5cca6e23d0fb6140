/** URLs of the files that the library fetches, for pages whose bundler does not copy them. */
import { ParameterError, requireOptions } from './errors.ts';

/** URLs by file. Relative URLs are resolved against the document. */
export interface AssetUrls {
  /** `cartoon-smoke/core.wasm`: the simulator without rigid bodies. */
  readonly core?: string | URL;
  /** `cartoon-smoke/meshes.wasm`: the simulator with meshes that move, and with flows. */
  readonly meshes?: string | URL;
  /** `cartoon-smoke/physics.wasm`: the simulator with rigid bodies. */
  readonly physics?: string | URL;
  /** `cartoon-smoke/worker.js` */
  readonly worker?: string | URL;
}

const NAMES = ['core', 'meshes', 'physics', 'worker'];
/** Shared by the builds of the package, such as those of the element and of three.js scenes, and by copies of it. */
const KEY = Symbol.for('cartoon-smoke.assetUrls');
const shared = globalThis as { [KEY]?: Map<string, string> };
const urls = (shared[KEY] ??= new Map());

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

/** @returns the URL that the page has set for a file, or undefined */
export function assetUrl(name: keyof AssetUrls): string | undefined {
  return urls.get(name);
}

/**
 * Corrects the URL of a file of the package on Vite's development server. Up to version 7, it moves the modules of packages to
 * another folder, but not the files beside them.
 */
export function servedUrl(url: string): string {
  return url.replace(/\/\.vite\/deps\/(?=wasm\/|(worker|stageModel)\.js)/, '/cartoon-smoke/dist/');
}

/** All URLs that the page has set. */
export function assetUrls(): AssetUrls {
  return Object.fromEntries(urls);
}
