/** Installs the service worker of the built site, and tells when a new version of the site has come. */

type Offer = (takeOver: () => void) => void;

/**
 * Call this when the smoke stands: it fetches, and nothing that shows waits for it.
 * @param offer shows that a new version is there; its argument goes over to it
 */
export function workOffline(offer: Offer): void {
  // The development server changes its files all the time, and browsers keep nothing for an insecure address.
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  // Where a browser is told to keep nothing, the page works as well, with a network.
  install(offer).catch(() => undefined);
}

async function install(offer: Offer): Promise<void> {
  const { serviceWorker } = navigator;
  const wasControlled = serviceWorker.controller !== null;
  const registration = await serviceWorker.register('./sw.js');
  watchForVersions(registration, offer);
  const { active } = await serviceWorker.ready;
  // What came before the worker did was not seen by it.
  // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have none
  if (!wasControlled) active?.postMessage(performance.getEntriesByType('resource').map(({ name }) => name));
}

function watchForVersions(registration: ServiceWorkerRegistration, offer: Offer): void {
  const offerNew = (waiting: ServiceWorker) => offer(() => takeOver(waiting));
  let watched: ServiceWorker | null = null;
  const watch = () => {
    const coming = registration.installing;
    if (!coming || coming === watched) return;
    watched = coming;
    coming.addEventListener('statechange', () => {
      if (coming.state === 'installed' && registration.active) offerNew(coming);
    });
  };
  if (registration.waiting && registration.active) offerNew(registration.waiting);
  // The browser looks for a new version by itself, and may have found it before anybody could listen.
  watch();
  registration.addEventListener('updatefound', watch);
}

/** Reloads as soon as the new worker answers for this page: before, the old one would answer again. */
function takeOver(waiting: ServiceWorker): void {
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have none
  waiting.postMessage('take over');
}
