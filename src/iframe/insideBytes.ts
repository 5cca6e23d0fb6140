/** The WASM where nothing but scripts can be fetched, as in a sandbox without an origin: in scripts. */
import { LoadError } from '../preset/errors.ts';
import { unpackBytes } from '../preset/packing.ts';
import { takeWasmFrom } from '../sim/load.ts';

/** Written by the build: the core, deflated, in base64url; and the address of the script that brings the physics. */
declare const CORE_WASM: string | undefined;
declare const PHYSICS_SCRIPT: string;

/** What that script calls. */
type Bring = (packed: string) => void;

const MAX_BYTES = 16 * 1024 * 1024;

/** Takes the WASM from the scripts of a built page. From a development server it is fetched. */
export function useBytesInside(): void {
  if (typeof CORE_WASM === 'undefined') return;
  takeWasmFrom(async (physics) => {
    const packed = physics ? await fetchPhysics(PHYSICS_SCRIPT) : CORE_WASM;
    return (await unpackBytes(packed, MAX_BYTES)).bytes;
  });
}

function fetchPhysics(address: string): Promise<string> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    (globalThis as { bringPhysics?: Bring }).bringPhysics = resolve;
    script.onload = () => script.remove();
    script.onerror = () => reject(new LoadError(`${address} could not be fetched.`));
    script.src = address;
    document.head.append(script);
  });
}
