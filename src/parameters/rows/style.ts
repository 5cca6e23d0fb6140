import type {
  ColorParameter,
  Keyed,
  NumberParameter,
  Parameter,
  RampParameter,
  ToggleParameter,
} from '../parameter.ts';
import { choice, fixed, ofScene, quantity, simulated } from './row.ts';

/** Shadows, tones, colours and ink. The types keep the keys: the fields of `Style` follow from them. */
export const styleRows = [
  toggle('shading', 1),
  toggle('outlines', 1),
  toggle('creases', 1),
  toggle('shadows', 1),
  choice('style.shadowSteps', 'style', 1, [1, 2]),
  fixed('shaders', choice('style.volumes', 'style', 'receiver', ['receiver', 'counted'])),
  quantity('style.shadowDepth', 'style', { kind: 'integer', min: 2, max: 100, default: 6 }),
  ofScene(color('surfaceShadowColor', '#968cc4')),
  color('deepShadow', '#a79bc9'),
  choice('style.tones', 'style', 2, [1, 2, 3]),
  ramp('ramp'),
  toggle('rampBlend', 0),
  share('fill', 0),
  quantity('style.simplify', 'style', { min: 0, max: 8, default: 0, unit: 'px' }),
  share('form', 0),
  share('strokes', 0),
  share('rim', 0),
  color('rimColor', '#fff6d8'),
  color('smokeColor', '#f6efe2'),
  color('tint1', '#f08a5d'),
  color('tint2', '#7fb2e5'),
  color('tint3', '#8fcf7a'),
  ramp('ageRamp'),
  ramp('heatRamp'),
  toggle('softColors', 0),
  color('inkColor', '#1d1720'),
  share('inkLight', 0),
  ramp('backdrop'),
  share('wash', 0),
  color('washColor', '#f2ead8'),
  quantity('style.outlineWidth', 'style', { min: 0, max: 8, default: 2.2, unit: 'px' }),
  share('inkSwell', 0.35),
  share('boil', 0),
  ofScene(simulated('style.hold')),
  quantity('style.innerLine', 'style', { min: 0, max: 1, default: 0.18, unit: 'radii' }),
  quantity('style.innerTaper', 'style', { min: 0, max: 4, default: 1 }),
  choice('style.gradient', 'style', 'none', ['none', 'puff', 'height', 'screen', 'age']),
  color('gradientColor', '#b9a6d8'),
  quantity('style.gradientBottom', 'style', { min: -100, max: 100, default: 0.9, unit: 'm' }),
  quantity('style.gradientTop', 'style', { min: -100, max: 100, default: 3, unit: 'm' }),
  fixed('shaders', choice('style.pattern', 'style', 'none', ['none', 'dots', 'lines', 'crosshatch', 'grain'])),
  choice('style.patternOn', 'style', 'shadow', ['shadow', 'tones', 'both']),
  quantity('style.patternCoverage', 'style', { min: 0, max: 0.75, default: 0.35 }),
  share('patternBackdrop', 0),
  color('patternColor', '#1d1720'),
  quantity('style.patternSize', 'style', { min: 2, max: 40, default: 6, unit: 'px' }),
  quantity('style.patternAngle', 'style', { min: -180, max: 180, default: 45, unit: '°' }),
  quantity('style.patternSoftness', 'style', { min: 0, max: 8, default: 0, unit: 'px' }),
  quantity('style.patternShiftX', 'style', { min: -40, max: 40, default: 0, unit: 'px' }),
  quantity('style.patternShiftY', 'style', { min: -40, max: 40, default: 0, unit: 'px' }),
  fixed('shaders', choice('style.renderer', 'style', 'nailboards', ['nailboards', 'selle'])),
] as const satisfies readonly Parameter[];

type OfStyle<Row, Name extends string> = Keyed<Row, `style.${Name}`, 'style'>;

function toggle<const Name extends string>(name: Name, initial: 0 | 1): OfStyle<ToggleParameter, Name> {
  return { kind: 'toggle', key: `style.${name}`, reader: 'style', default: initial };
}

function ramp<const Name extends string>(name: Name): OfStyle<RampParameter, Name> {
  return { kind: 'ramp', key: `style.${name}`, reader: 'style', default: '' };
}

function color<const Name extends string>(name: Name, initial: string): OfStyle<ColorParameter, Name> {
  return { kind: 'color', key: `style.${name}`, reader: 'style', default: initial };
}

/** A number from 0 to 1. */
function share<const Name extends string>(name: Name, initial: number): OfStyle<NumberParameter, Name> {
  return quantity(`style.${name}`, 'style', { min: 0, max: 1, default: initial });
}
