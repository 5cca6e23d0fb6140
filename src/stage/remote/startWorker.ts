import { assetUrl, servedUrl } from '../../base/assetUrls.ts';

/** The policy name that the page's `trusted-types` directive must allow. */
const POLICY = 'cartoon-smoke';

/** Missing from TypeScript's DOM library. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): {
    createScriptURL(address: string): string;
  };
}

/** Bundlers detect workers only in this literal form. */
function start(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'cartoon-smoke' });
}

/** Its URL where no bundler has moved it. Not `new URL` with two arguments, whose file bundlers would copy once more. */
function addressBeside(): string {
  return new URL(import.meta.url.replace(/[^/]*$/, './worker.ts')).href;
}

/**
 * Starts the module of `worker.ts`.
 * @throws when the page's security policy blocks it at once. If it is blocked later or cannot be fetched, the worker
 * emits an error event
 */
export function startWorker(): Worker {
  const own = assetUrl('worker');
  if (own) return startFrom(own);
  const address = addressBeside();
  const served = servedUrl(address);
  if (served !== address) return startFrom(served);
  try {
    return start();
  } catch {
    return startFrom(address);
  }
}

function startFrom(address: string): Worker {
  return new Worker(trusted(sameOrigin(address)), { type: 'module', name: 'cartoon-smoke' });
}

/**
 * Browsers require a same-origin worker script. A same-origin blob can import a cross-origin module, for example from a
 * CDN.
 */
function sameOrigin(address: string): string {
  if (new URL(address, location.href).origin === location.origin) return address;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' }));
}

/**
 * Converts a URL for pages that require Trusted Types.
 * @throws TypeError when the page does not allow the policy name
 */
function trusted(address: string): string {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  const policy = trustedTypes?.createPolicy(POLICY, { createScriptURL: (given) => given });
  return policy?.createScriptURL(address) ?? address;
}
