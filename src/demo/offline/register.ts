/** Installs the service worker of the built site, and reports new versions of the site. */

type Offer = (takeOver: () => void) => void;

/**
 * Call this after the first frame: it fetches files, and nothing visible depends on it.
 * @param offer reports a new version; its argument activates it
 */
export function workOffline(offer: Offer): void {
  // Files of the development server change constantly, and service workers require a secure context.
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  // The page also works without a service worker, when online.
  install(offer).catch(() => undefined);
}

async function install(offer: Offer): Promise<void> {
  const { serviceWorker } = navigator;
  const wasControlled = serviceWorker.controller !== null;
  const registration = await serviceWorker.register('./sw.js');
  watchForVersions(registration, offer);
  const { active } = await serviceWorker.ready;
  // The service worker did not see requests from before its activation.
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
  // The browser may have found an update before this listener was added.
  watch();
  registration.addEventListener('updatefound', watch);
}

/** Reloads as soon as the new worker controls this page. An earlier reload would be served by the old worker. */
function takeOver(waiting: ServiceWorker): void {
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have none
  waiting.postMessage('take over');
}
