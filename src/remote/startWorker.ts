/** The name that a page's `trusted-types` has to allow. */
const POLICY = 'cartoon-smoke';

/** What TypeScript's library of the page lacks. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): {
    createScriptURL(address: string): string;
  };
}

/** Written out, because bundlers only find workers that are written so. */
function start(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'cartoon-smoke' });
}

/**
 * Starts the module of `worker.ts`.
 * @throws where the page's rules forbid it at once; where they forbid it later, or the module cannot be had, the worker has an
 * error event
 */
export function startWorker(): Worker {
  try {
    return start();
  } catch {
    const address = addressOf(start);
    return new Worker(trusted(sameOrigin(address)), { type: 'module', name: 'cartoon-smoke' });
  }
}

/** Which address the bundler has written into a call of Worker. */
function addressOf(call: () => Worker): string {
  const { Worker: original } = globalThis;
  let address = '';
  try {
    globalThis.Worker = function (given: string | URL) {
      address = String(given);
    } as unknown as typeof Worker;
    call();
  } finally {
    globalThis.Worker = original;
  }
  return address;
}

/** Browsers start workers of the page's own origin only; one of its own may import from elsewhere, as from a CDN. */
function sameOrigin(address: string): string {
  if (new URL(address, location.href).origin === location.origin) return address;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' }));
}

/** As a page wants it that requires Trusted Types. @throws TypeError where the page allows no policy of our name */
function trusted(address: string): string {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  const policy = trustedTypes?.createPolicy(POLICY, { createScriptURL: (given) => given });
  return policy?.createScriptURL(address) ?? address;
}
