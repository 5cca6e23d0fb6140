/**
 * Lets the service worker of the demo keep the text of all pages, so that they and the search work offline. Call it
 * after the page is shown, since nothing visible depends on it.
 *
 * @param root path of the documentation, with a trailing slash
 */
export async function workOffline(root: string): Promise<void> {
  if (import.meta.env.DEV || !('serviceWorker' in navigator)) return;
  try {
    const { serviceWorker } = navigator;
    await serviceWorker.register(`${root}../sw.js`);
    const { active } = await serviceWorker.ready;
    const answer = await fetch(`${root}files.json`);
    const files = (await answer.json()) as string[];
    // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have none
    active?.postMessage(files.map((file) => new URL(root + file, location.href).href));
  } catch {
    // Without a service worker the pages work online.
  }
}
