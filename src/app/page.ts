import type { Stage } from '../stage/stage.ts';
import { create, iconButton } from './dom.ts';
import { acceptDrops } from './drops.ts';
import type { Editor } from './editor.ts';
import { SmokeFiles } from './files.ts';
import { createHelp, toggleHelp } from './help.ts';
import { icon } from './icons.ts';
import type { Notices } from './notices.ts';
import { OwnPresets } from './ownPresets.ts';
import { OwnShape } from './ownShape.ts';
import { createPanel, PANEL_ID } from './panel.ts';
import { ShareSheet } from './shareSheet.ts';
import { createStatistics } from './statistics.ts';
import { strings } from './strings.ts';
import { createTransport } from './transport.ts';
import { Views } from './views.ts';

/** What the keys need of the page's controls. */
export interface Page {
  share(): void;
  help(): void;
  togglePanel(): void;
  nextView(): void;
}

/** On a phone the panel covers half of the smoke, so it starts closed there. */
const ROOMY = '(min-width: 701px) and (min-height: 501px)';

/** Puts the controls over the canvas. @param host the element that holds them */
export function buildPage(
  host: HTMLElement,
  editor: Editor,
  stage: Stage,
  notices: Notices,
  hasStatistics: boolean,
): Page {
  const help = createHelp();
  const views = new Views(stage);
  const toggle = iconButton('icon-button', strings.panel.open, icon('sliders'), () => page.togglePanel());
  toggle.setAttribute('aria-controls', PANEL_ID);
  const ownShape = new OwnShape(stage, notices, host);
  const files = new SmokeFiles(editor, stage, notices, host);
  const sheet = new ShareSheet(editor, stage, files);
  acceptDrops(document.body, (file) => void (isJson(file) ? files : ownShape).open(file));
  const own = new OwnPresets(editor, stage, notices, files);
  const panel = createPanel(editor, stage, { presets: own.element, puff: ownShape.element }, () => {
    page.togglePanel();
    toggle.focus();
  });
  const showPanel = (isOpen: boolean) => {
    panel.hidden = !isOpen;
    toggle.setAttribute('aria-expanded', String(isOpen));
    document.body.classList.toggle('has-panel', isOpen);
  };
  const page: Page = {
    share: () => void sheet.open(ownShape.name),
    help: () => toggleHelp(help),
    nextView: () => views.next(),
    togglePanel: () => showPanel(panel.hidden !== false),
  };
  host.append(createHeader(page, toggle), createTransport(stage), panel, help, sheet.element, views.element);
  if (hasStatistics) host.append(createStatistics(stage));
  showPanel(matchMedia(ROOMY).matches);
  return page;
}

function isJson({ name }: File): boolean {
  return name.toLowerCase().endsWith('.json');
}

function createHeader(page: Page, toggle: HTMLElement): HTMLElement {
  const shareButton = create('button', { type: 'button', class: 'loud' }, icon('share'), strings.share.button);
  shareButton.addEventListener('click', () => page.share());
  const helpButton = iconButton('icon-button', strings.help.button, icon('help'), () => page.help());
  const actions = create('div', { class: 'actions card' }, shareButton, helpButton, toggle);
  return create('header', { class: 'top' }, createWordmark(), actions);
}

function createWordmark(): HTMLElement {
  const words = strings.title.split(' ').map((word) => create('span', {}, word));
  return create('h1', { class: 'wordmark', 'aria-label': strings.title }, ...words);
}
