import { iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** Toggles full screen. Does nothing where the browser does not allow it. */
export async function toggleFullScreen(): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else if (document.fullscreenEnabled) await document.documentElement.requestFullscreen();
}

/** Full-screen button, hidden where full screen is unavailable, for example on some phones and in some iframes. */
export function createFullScreenButton(): HTMLButtonElement {
  const { fullScreen } = strings.transport;
  const button = iconButton('icon-button', fullScreen, icon('fullScreen'), () => void toggleFullScreen());
  button.hidden = !document.fullscreenEnabled;
  document.addEventListener('fullscreenchange', () => {
    button.setAttribute('aria-pressed', String(document.fullscreenElement !== null));
  });
  button.setAttribute('aria-pressed', 'false');
  return button;
}
