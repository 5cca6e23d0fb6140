/** URLs of the files that the library fetches, for pages whose bundler does not copy them. */

/** URLs by file. Relative URLs are resolved against the document. */
export interface AssetUrls {
  /** `cartoon-smoke/core.wasm`: the simulator without rigid bodies. */
  readonly core?: string | URL;
  /** `cartoon-smoke/meshes.wasm`: the simulator with meshes that move, and with flows. */
  readonly meshes?: string | URL;
  /** `cartoon-smoke/physics.wasm`: the simulator with rigid bodies. */
  readonly physics?: string | URL;
  /** `cartoon-smoke/stageModel.js`: the code of models for stages in the worker and for the script for CDNs. */
  readonly stageModel?: string | URL;
  /** `cartoon-smoke/worker.js` */
  readonly worker?: string | URL;
}

/** Shared by the builds of the package, such as those of the element and of three.js scenes, and by copies of it. */
const KEY = Symbol.for('cartoon-smoke.assetUrls');
const shared = globalThis as { [KEY]?: Map<string, string> };
/** The URLs that the page has set, by file. */
export const urls: Map<string, string> = (shared[KEY] ??= new Map());

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
