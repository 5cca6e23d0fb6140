/** Entry of `embed.html`, the page for iframes. It reads the same hash and query as the demo page but has no panel. */
import { CartoonSmokeElement } from '../element/define.ts';
import { answerPage, elementStage, originOf } from './answerPage.ts';
import { LoadError } from '../../base/errors.ts';
import { unpackBytes } from '../../parameters/packing.ts';
import { setWasmSource, type Variant } from '../../simulator/load.ts';

type Larger = Exclude<Variant['name'], 'core'>;

/**
 * Defined by the build: the core WASM, deflated and base64url-encoded, and the URLs of the scripts that contain the larger
 * variants.
 */
declare const CORE_WASM: string | undefined;
declare const WASM_SCRIPTS: Readonly<Record<Larger, string>>;

/** Callbacks that the scripts call. */
type Brings = { [Name in Larger as `bring_${Name}`]?: (packed: string) => void };

const MAX_BYTES = 16 * 1024 * 1024;

function begin(smoke: CartoonSmokeElement): void {
  // A worker needs an origin, which a sandboxed frame may lack. Most browsers run cross-site frames on a separate thread.
  smoke.thread = 'main';
  const query = new URLSearchParams(location.search);
  smoke.interactive = query.get('interactive') !== '0';
  smoke.transparent = query.get('transparent') === '1';
  const follow = () => (smoke.src = location.href);
  addEventListener('hashchange', follow);
  follow();
  const stand = () => {
    // An earlier connection may have disposed the stage, which removes the element.
    if (!smoke.isConnected) document.body.prepend(smoke);
    return smoke.stage;
  };
  answerPage(elementStage(smoke), originOf(location.search), stand);
}

/**
 * Reads the WASM from the scripts of a built page, because a sandbox without an origin can fetch nothing else. The
 * development server serves it over fetch.
 */
function useBytesInside(): void {
  if (typeof CORE_WASM === 'undefined') return;
  setWasmSource(async ({ name }) => {
    const packed = name === 'core' ? CORE_WASM : await fetchLarger(name);
    return (await unpackBytes(packed, MAX_BYTES)).bytes;
  });
}

function fetchLarger(name: Larger): Promise<string> {
  const address = WASM_SCRIPTS[name];
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    (globalThis as Brings)[`bring_${name}`] = resolve;
    script.onload = () => script.remove();
    script.onerror = () => reject(new LoadError(`${address} could not be fetched.`));
    script.src = address;
    document.head.append(script);
  });
}

useBytesInside();
const found = document.querySelector('cartoon-smoke');
if (found instanceof CartoonSmokeElement) begin(found);
