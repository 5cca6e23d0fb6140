import { frameCount } from '../../internal.ts';
import { create } from '../ui/dom.ts';
import { strings } from '../strings.ts';
import { hevcWithAlpha } from './clips/hevc.ts';
import {
  FASTEST_GIF,
  columnsOf,
  FORMATS,
  LONGEST,
  pixelSize,
  RATES,
  SCALES,
  type Format,
  type LightLayout,
  type CaptureSettings,
} from './settings.ts';

/** Preset sizes besides the window's, in CSS pixels. */
const SIZES = ['1920x1080', '1280x720', '640x360', '1080x1080', '1080x1920'] as const;
const WINDOW = 'window';
/** An SVG is traced from a frame at twice the resolution. */
const DRAWING_SCALE = 2;
/** Width of the atlas of a flipbook at scale 1, in pixels. */
const ATLAS_WIDTH = 1024;
const NO_LIGHTS = 'none';

/** Capture settings as native form fields. */
export class SettingsForm {
  readonly element = create('form', { class: 'capture-form' });
  private readonly fields = create('fieldset', { class: 'capture-fields' });
  private readonly summary = create('p', { class: 'capture-summary' });
  private readonly format = choice('format', Object.keys(FORMATS) as Format[], (name) => strings.capture.formats[name]);
  private readonly size = choice('size', [WINDOW, ...SIZES], (name) => name.replace('x', ' \u00d7 '));
  private readonly scale = choice('scale', SCALES, (scale) => strings.capture.times(scale));
  private readonly rate = choice('rate', RATES, (rate) => strings.capture.perSecond(rate));
  private readonly seconds = create('input', { type: 'number', name: 'seconds', min: 0.1, max: LONGEST, step: 'any' });
  private readonly background = create('input', { type: 'checkbox', name: 'background', checked: true });
  private readonly layers = create('input', { type: 'checkbox', name: 'layers' });
  private readonly lights = choice(
    'lights',
    ['unity', 'unreal', NO_LIGHTS] as const,
    (name) => strings.capture.lights[name],
  );

  /** Whether an MP4 of the selected size can be transparent. */
  private hasMp4Alpha = false;

  constructor() {
    const { labels } = strings.capture;
    this.seconds.value = '3';
    this.rate.value = '24';
    this.fields.append(
      row(labels.format, this.format),
      row(labels.size, this.size),
      row(labels.scale, this.scale),
      row(labels.seconds, this.seconds),
      row(labels.rate, this.rate),
      row(labels.background, this.background),
      row(labels.layers, this.layers),
      row(labels.lights, this.lights),
    );
    this.element.append(this.fields, this.summary);
    this.element.addEventListener('input', () => this.updateFields());
    this.measureWindow();
  }

  set isLocked(isLocked: boolean) {
    this.fields.disabled = isLocked;
  }

  /** Updates the 'window' option with the current size. */
  measureWindow(): void {
    this.size.options[0].textContent = strings.capture.window(innerWidth, innerHeight);
    this.updateFields();
  }

  settings(): CaptureSettings {
    const format = this.format.value as Format;
    const [width, height] =
      this.size.value === WINDOW ? [innerWidth, innerHeight] : this.size.value.split('x').map(Number);
    const settings: CaptureSettings = {
      format,
      width,
      height,
      scale: format === 'svg' ? DRAWING_SCALE : Number(this.scale.value),
      hasBackground: format !== 'flipbook' && (this.background.checked || !this.hasAlpha(format)),
      seconds: Number(this.seconds.value),
      rate: Number(this.rate.value),
      inLayers: this.layers.checked,
    };
    if (format !== 'flipbook') return settings;
    const lights = this.lights.value as LightLayout | typeof NO_LIGHTS;
    const layout = lights === NO_LIGHTS ? {} : { lights };
    return {
      ...settings,
      ...layout,
      scale: (ATLAS_WIDTH * settings.scale) / (columnsOf(frameCount(settings)) * width),
    };
  }

  /** Shows the fields of the selected format, and a summary of the result. */
  private updateFields(): void {
    const format = this.format.value as Format;
    const { isClip } = FORMATS[format];
    if (format === 'mp4') void this.askForAlpha();
    show(this.scale, format !== 'svg');
    show(this.seconds, isClip);
    show(this.rate, isClip);
    show(this.background, this.hasAlpha(format));
    show(this.layers, format === 'zip');
    show(this.lights, format === 'flipbook');
    for (const option of this.rate.options) option.disabled = format === 'gif' && Number(option.value) > FASTEST_GIF;
    if (this.rate.selectedOptions[0].disabled) this.rate.value = String(FASTEST_GIF);
    this.notify();
  }

  private hasAlpha(format: Format): boolean {
    return format === 'mp4' ? this.hasMp4Alpha : FORMATS[format].hasAlpha;
  }

  /** Asks the browser only for MP4, because WebKitGTK 2.50 can crash. */
  private async askForAlpha(): Promise<void> {
    const [width, height] = pixelSize(this.settings());
    const hasAlpha = (await hevcWithAlpha({ width, height, rate: Number(this.rate.value) })) !== undefined;
    if (hasAlpha === this.hasMp4Alpha) return;
    this.hasMp4Alpha = hasAlpha;
    if (this.format.value === 'mp4') show(this.background, hasAlpha);
  }

  private notify(): void {
    const settings = this.settings();
    const [width, height] = pixelSize(settings);
    const { isClip } = FORMATS[settings.format];
    const { frames, size, notes } = strings.capture;
    const sized =
      settings.format === 'svg' ? '' : isClip ? frames(frameCount(settings), width, height) : size(width, height);
    this.summary.textContent = `${sized} ${notes[settings.format]}`.trim();
  }
}

function choice<Value extends string | number>(
  name: string,
  values: readonly Value[],
  label: (value: Value) => string,
) {
  return create('select', { name }, ...values.map((value) => create('option', { value }, label(value))));
}

function row(label: string, field: HTMLElement): HTMLLabelElement {
  return create('label', { class: 'capture-row' }, create('span', {}, label), field);
}

function show(field: HTMLInputElement | HTMLSelectElement, isShown: boolean): void {
  field.closest('label')!.hidden = !isShown;
  field.disabled = !isShown;
}
