import { ParameterError, requireOptions } from '../../base/errors.ts';
import { drive, OPTIONS, type DrivenSmoke, type Driver, type DriverOptions } from './driver.ts';
import { requireRanges, type DrivenRanges } from './ranges.ts';

export interface AudioDriverOptions extends DriverOptions {
  /**
   * An `<audio>` or `<video>`, or a node of Web Audio that the page made, such as that of a microphone. An element plays
   * through an `AudioContext` of the library from the first time that the browser lets it run, after a gesture.
   */
  audio: HTMLMediaElement | AudioNode;
  /** Ranges by the level below 250 Hz. At least one of the three bands is required. */
  low?: DrivenRanges;
  /** Ranges by the level from 250 to 2,000 Hz. */
  mid?: DrivenRanges;
  /** Ranges by the level from 2,000 to 16,000 Hz. */
  high?: DrivenRanges;
  /** Levels that count as 0 and as 1, -100 to 0 dB, rising. A sine of full scale has -11. Default: [-60, -12]. */
  decibels?: readonly [min: number, max: number];
}

/** Their limits in Hz. */
export const BANDS = { low: [20, 250], mid: [250, 2000], high: [2000, 16_000] } as const;
const NAMES = Object.keys(BANDS) as (keyof typeof BANDS)[];
/** 43 a second at 44.1 kHz: 12 bins of the low band. */
const FFT_SIZE = 2048;
const SMOOTHING = 0.08;
/** What makes browsers let an AudioContext run. */
const GESTURES = ['pointerup', 'touchend', 'click', 'keydown'];

/** Of all elements: browsers allow few. */
let context: AudioContext | undefined;
/** An element can have only one in its life. */
const nodes = new WeakMap<HTMLMediaElement, AudioNode>();

/**
 * Changes parameters of smoke by the level of sound in three bands. Silence, a paused element and an `AudioContext` that
 * waits for a gesture are 0.
 * @throws ParameterError for an invalid option, a parameter that cannot be driven, an invalid value, and an element that
 * another `AudioContext` plays
 */
export function driveByAudio(smoke: DrivenSmoke, options: AudioDriverOptions): Driver {
  requireOptions('driveByAudio', options, ['audio', ...NAMES, 'decibels', ...OPTIONS]);
  const { audio, decibels = [-60, -12], smoothing = SMOOTHING } = options;
  const isElement = audio instanceof HTMLMediaElement;
  if (!isElement && !(audio instanceof AudioNode))
    throw new ParameterError('audio', audio, 'an <audio> or <video> element, or an AudioNode');
  requireDecibels(decibels);
  const bands = NAMES.filter((name) => options[name] !== undefined);
  if (bands.length === 0) throw new ParameterError('driveByAudio', 'no band', `ranges for ${NAMES.join(', ')}`);
  const tracks = bands.map((name) => requireRanges(name, options[name]));
  const meter = new Meter(decibels);
  return drive(
    smoke,
    {
      tracks,
      isLive: () => meter.isConnected && !(isElement && audio.paused),
      start(wake, signal, fail) {
        const own = isElement ? (context ??= new AudioContext()) : audio.context;
        const connect = () => {
          if (own.state === 'running') meter.connect(isElement ? nodeOf(audio, own as AudioContext) : audio);
          else meter.disconnect();
        };
        const listen = () => {
          try {
            connect();
            wake();
          } catch (error) {
            fail(error);
          }
        };
        if (isElement) {
          const resume = () => {
            // It rejects where the browser waits for another gesture.
            if (own.state !== 'running') (own as AudioContext).resume().catch(() => {});
          };
          for (const gesture of GESTURES) addEventListener(gesture, resume, { signal, passive: true, capture: true });
          audio.addEventListener('play', resume, { signal });
          audio.addEventListener('playing', listen, { signal });
          resume();
        }
        own.addEventListener('statechange', listen, { signal });
        signal.addEventListener('abort', () => meter.disconnect(), { once: true });
        connect();
      },
      measure() {
        meter.read();
        return bands.map((name) => meter.levelOf(BANDS[name]));
      },
    },
    { ...options, smoothing },
  );
}

/** Measures the level of a node. */
class Meter {
  private readonly decibels: readonly [min: number, max: number];
  private node: AudioNode | undefined;
  private analyser: AnalyserNode | undefined;
  private bins = new Float32Array(0);

  constructor(decibels: readonly [min: number, max: number]) {
    this.decibels = decibels;
  }

  get isConnected(): boolean {
    return this.node !== undefined;
  }

  connect(node: AudioNode): void {
    if (this.node === node) return;
    this.analyser ??= new AnalyserNode(node.context, { fftSize: FFT_SIZE, smoothingTimeConstant: 0 });
    this.bins = new Float32Array(this.analyser.frequencyBinCount);
    node.connect(this.analyser);
    this.node = node;
  }

  disconnect(): void {
    if (this.analyser) this.node?.disconnect(this.analyser);
    this.node = undefined;
  }

  /** Reads all bands at once. */
  read(): void {
    if (this.node) this.analyser!.getFloatFrequencyData(this.bins);
    else this.bins.fill(-Infinity);
  }

  /** The sum of the energy between two frequencies, on a scale of decibels. */
  levelOf([from, to]: readonly [from: number, to: number]): number {
    const [min, max] = this.decibels;
    const width = this.analyser ? this.analyser.context.sampleRate / FFT_SIZE : Infinity;
    let energy = 0;
    for (let bin = Math.ceil(from / width); bin < Math.min(to / width, this.bins.length); ++bin)
      energy += 10 ** (this.bins[bin] / 10);
    return (10 * Math.log10(energy) - min) / (max - min);
  }
}

/** From now on, the element plays through the context. */
function nodeOf(element: HTMLMediaElement, own: AudioContext): AudioNode {
  const known = nodes.get(element);
  if (known) return known;
  try {
    const node = own.createMediaElementSource(element);
    node.connect(own.destination);
    nodes.set(element, node);
    return node;
  } catch {
    throw new ParameterError(
      'audio',
      'an element that another AudioContext plays',
      'its MediaElementAudioSourceNode in place of the element',
    );
  }
}

function requireDecibels(decibels: unknown): void {
  const [min, max] = Array.isArray(decibels) && decibels.length === 2 ? (decibels as unknown[]) : [];
  const isRight = typeof min === 'number' && typeof max === 'number' && min >= -100 && max <= 0 && min < max;
  if (!isRight) throw new ParameterError('decibels', decibels, 'two rising numbers from -100 to 0, such as [-60, -12]');
}
