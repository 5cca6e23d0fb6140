import type { Stage } from '../index.ts';
import { nextTask } from '../internal.ts';
import { createDebugPanel, Views, createStatistics } from './panel/debugPanel.ts';
import { CaptureButton } from './capture/button.ts';
import { createDock, surprise } from './gallery/dock.ts';
import { create, iconButton } from './ui/dom.ts';
import { acceptDrops, createOpener, SmokeFiles } from './share/files.ts';
import { DropThings } from './input/dropThings.ts';
import { DrawOpener, isPicture } from './draw/opener.ts';
import type { Editor } from './editor/editor.ts';
import { Gizmos } from './gizmos/gizmos.ts';
import type { Flag } from './ui/flag.ts';
import { Help } from './ui/help.ts';
import { icon } from './ui/icons.ts';
import type { Notices } from './ui/notices.ts';
import { isModel, Models } from './model/models.ts';
import { OwnPresets } from './gallery/ownPresets.ts';
import { OwnShape } from './gallery/ownShape.ts';
import { COLOR_TYPES, Palettes } from './palette/opener.ts';
import { DRAW_EVENT, FLOW_EVENT, TIMELINE_EVENT } from './panel/control.ts';
import { createPanel, PANEL_ID } from './panel/panel.ts';
import { PALETTE_EVENT } from './panel/rampControl.ts';
import { ROOMY } from './mediaQueries.ts';
import type { Scrubber } from './playback/scrubber.ts';
import { ShareSheet } from './share/shareSheet.ts';
import { strings } from './strings.ts';
import { TimelineOpener } from './timeline/opener.ts';

/** Actions of the page's controls that shortcut keys use. */
export interface Page {
  share(): void;
  capture(): void;
  help(): void;
  togglePanel(): void;
  nextView(): void;
  search(): void;
  toggleGallery(): void;
  surprise(): void;
  toggleGizmos(): void;
  toggleTimeline(): void;
  toggleStatistics(): void;
  drop(): void;
  blow(): void;
  /** Whether drags that grab nothing blow. */
  readonly dragsBlow: boolean;
}

/** Dependencies of the controls. */
export interface PageParts {
  readonly editor: Editor;
  readonly stage: Stage;
  /** The stage's canvas. */
  readonly canvas: HTMLCanvasElement;
  readonly notices: Notices;
  readonly scrubber: Scrubber;
  /** Whether statistics are shown initially. */
  readonly hasStatistics: boolean;
  /** Whether shortcuts of a single character are turned off. */
  readonly noShortcuts: Flag;
}

/** Adds the controls over the canvas, in several short tasks. @param container parent of the controls */
export async function buildPage(container: HTMLElement, parts: PageParts): Promise<Page> {
  const { editor, stage, notices, scrubber } = parts;
  const help = new Help(stage, parts.noShortcuts);
  const captureButton = new CaptureButton(stage, container, notices);
  const views = new Views(stage);
  const toggle = iconButton('icon-button', strings.panel.open, icon('sliders'), () => page.togglePanel());
  toggle.setAttribute('aria-controls', PANEL_ID);
  const ownShape = new OwnShape(editor, stage, notices, container);
  const models = new Models(parts);
  const files = new SmokeFiles(parts, container);
  const sheet = new ShareSheet(editor, stage, files);
  let hadPanel = false;
  const drawing = new DrawOpener(editor, notices, container, (isOpen) => {
    if (isOpen === document.body.classList.contains('is-drawing')) return;
    document.body.classList.toggle('is-drawing', isOpen);
    if (isOpen) hadPanel = !panel.hidden;
    // It would be in place of the drawing.
    if (isOpen && ownShape.name !== undefined) ownShape.remove();
    showPanel(!isOpen && (hadPanel || !panel.hidden));
    if (!isOpen) (hadPanel ? panel.querySelector<HTMLElement>('.drawing-buttons button')! : toggle).focus();
  });
  const palettes = new Palettes(parts, container);
  const openFiles = async (opened: readonly File[]): Promise<void> => {
    const [file] = opened;
    const openShape = (): void => void ownShape.open(opened);
    const openColors = (): void => void palettes.open(file);
    if (await palettes.takes(file)) openColors();
    else if (isJson(file)) void files.open(file);
    else if (isModel(file)) void models.open(file);
    else if (opened.every(isPicture)) drawing.ask(opened, openShape, openColors);
    else openShape();
  };
  acceptDrops(document.body, (dropped) => void openFiles(dropped));
  await nextTask();
  const opener = createOpener(`${COLOR_TYPES},.glb`, (chosen) => void openFiles(chosen));
  const own = new OwnPresets(editor, stage, notices, opener);
  const statistics = createStatistics(stage);
  const feet = {
    presets: own.element,
    puff: ownShape.element,
    model: models.element,
    end: createDebugPanel(stage, statistics),
  };
  const panel = await createPanel(editor, stage, feet, () => {
    page.togglePanel();
    toggle.focus();
  });
  panel.addEventListener(DRAW_EVENT, () => void drawing.open());
  panel.addEventListener(PALETTE_EVENT, () => palettes.choose());
  const things = new DropThings(stage, parts.canvas);
  const blowing = new Blowing(stage, parts.canvas);
  const timeline = new TimelineOpener((isOpen) => {
    document.body.classList.toggle('has-timeline', isOpen);
    // On a phone there is room for one of them.
    if (isOpen && !matchMedia(ROOMY).matches) {
      dock.closeGallery();
      showPanel(false);
    }
  });
  const dock = createDock(editor, stage, scrubber, timeline.button, [blowing.element, things.element], () => {
    if (!matchMedia(ROOMY).matches) void timeline.close();
  });
  await nextTask();
  const gizmos = new Gizmos(editor, stage, () => page.toggleGizmos());
  const gizmoToggle = iconButton('icon-button', strings.gizmos.title, icon('handles'), () => page.toggleGizmos());
  gizmoToggle.setAttribute('aria-pressed', 'false');
  statistics.toggle(parts.hasStatistics);
  const showPanel = (isOpen: boolean) => {
    if (isOpen) void drawing.close();
    panel.hidden = !isOpen;
    toggle.setAttribute('aria-expanded', String(isOpen));
    document.body.classList.toggle('has-panel', isOpen);
  };
  const page: Page = {
    share: () => void sheet.open(ownShape.name, models.name),
    capture: () => captureButton.press(),
    help: () => help.toggle(),
    nextView: () => views.next(),
    togglePanel: () => showPanel(panel.hidden !== false),
    search: () => {
      showPanel(true);
      panel.querySelector<HTMLElement>('.search-field')!.focus();
    },
    toggleGallery: () => dock.toggleGallery(),
    surprise: () => surprise(editor),
    toggleGizmos: () => {
      const isShown = gizmos.toggle();
      gizmoToggle.setAttribute('aria-pressed', String(isShown));
      // On a phone the gallery would cover some of them.
      if (isShown && !matchMedia(ROOMY).matches) dock.closeGallery();
    },
    toggleTimeline: () => void timeline.toggle(),
    toggleStatistics: () => statistics.toggle(),
    drop: () => things.dropAtPointer(),
    blow: () => blowing.blowAtPointer(),
    get dragsBlow() {
      return blowing.isBlowing;
    },
  };
  const header = createHeader(page, captureButton.element, gizmoToggle, toggle);
  showPanel(matchMedia(ROOMY).matches);
  panel.addEventListener(TIMELINE_EVENT, () => void timeline.open());
  panel.addEventListener(FLOW_EVENT, (event) => {
    const isRoomy = matchMedia(ROOMY).matches;
    // On a phone the panel would cover the picture.
    if (!isRoomy) showPanel(false);
    gizmos.drawFlow((event as CustomEvent<number>).detail, isRoomy ? (event.target as HTMLElement) : toggle);
  });
  await nextTask();
  container.querySelector('.skeleton')?.remove();
  container.append(gizmos.element, header, dock.element, gizmos.brush);
  await nextTask();
  container.append(panel, palettes.element, help.element, sheet.element, views.element, statistics.element);
  const showParameters = (): void => showPanel(true);
  const close = (): void => void timeline.close();
  timeline.connect({ editor, stage, scrubber, notices, container, panel, showParameters, close });
  return page;
}

function isJson({ name }: File): boolean {
  return name.toLowerCase().endsWith('.json');
}

function createHeader(page: Page, ...toggles: HTMLElement[]): HTMLElement {
  const shareButton = create('button', { type: 'button', class: 'loud' }, icon('share'));
  shareButton.append(create('span', { class: 'label' }, strings.share.button));
  shareButton.addEventListener('click', () => page.share());
  const helpButton = iconButton('icon-button', strings.help.button, icon('help'), () => page.help());
  const actions = create('div', { class: 'actions card' }, shareButton, helpButton, ...toggles);
  return create('header', { class: 'top' }, createWordmark(), actions);
}

function createWordmark(): HTMLElement {
  const words = strings.title.split(' ').map((word) => create('span', {}, word));
  return create('h1', { class: 'wordmark', 'aria-label': strings.title }, ...words);
}

/** Blowing without an Alt key: a button that makes drags blow, and a gust by the keyboard. */
class Blowing {
  readonly element: HTMLButtonElement;
  private readonly stage: Stage;
  private readonly canvas: HTMLCanvasElement;
  private pointer: { x: number; y: number } | undefined;
  private isOn = false;

  constructor(stage: Stage, canvas: HTMLCanvasElement) {
    this.stage = stage;
    this.canvas = canvas;
    this.element = iconButton('icon-button', strings.blow, icon('wind'), () => this.toggle());
    this.element.setAttribute('aria-pressed', 'false');
    canvas.addEventListener('pointermove', ({ offsetX: x, offsetY: y }) => (this.pointer = { x, y }));
    canvas.addEventListener('pointerleave', () => (this.pointer = undefined));
  }

  /** Whether a drag that grabs nothing blows instead of orbiting the camera. */
  get isBlowing(): boolean {
    return this.isOn;
  }

  /** Blows away from the viewer, at the pointer or in the middle. */
  blowAtPointer(): void {
    const { clientWidth, clientHeight } = this.canvas;
    this.stage.blow(this.pointer ?? { x: clientWidth / 2, y: clientHeight / 2 });
  }

  private toggle(): void {
    this.isOn = !this.isOn;
    this.element.setAttribute('aria-pressed', String(this.isOn));
  }
}
