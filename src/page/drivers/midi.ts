import { ParameterError, requireOptions, UnsupportedError } from '../../base/errors.ts';
import { requireWhole } from '../../parameters/values.ts';
import { drive, OPTIONS, requireDriver, type DrivenSmoke, type Driver, type DriverOptions } from './driver.ts';
import { requireRanges, type DrivenRanges } from './ranges.ts';

export interface MidiDriverOptions extends DriverOptions {
  /** Ranges by the number of a knob, which is its MIDI controller, 0 to 127. */
  knobs: Readonly<Record<number, DrivenRanges>>;
  /** Only this MIDI channel counts, 1 to 16. Default: all. */
  channel?: number;
  /** Is called with the number of each knob that is turned, also of others, to find it out. */
  onTurn?: (knob: number) => void;
}

const MAX_KNOB = 127;
/** Of a message of three bytes: its kind, with the channel in the lower four bits. */
const CONTROL_CHANGE = 0xb0;
const CHANNELS = 16;

/**
 * Changes parameters of smoke by knobs and faders of MIDI devices, also those that are plugged in later. Before a knob is
 * turned, its parameters stay as they are. The browser may ask the person for permission. Also works with reduced motion.
 * @throws UnsupportedError where the browser has no Web MIDI, and where the page or the person does not allow it.
 * ParameterError for an invalid option, a parameter that cannot be driven or an invalid value
 */
export async function driveByMidi(smoke: DrivenSmoke, options: MidiDriverOptions): Promise<Driver> {
  requireOptions('driveByMidi', options, ['knobs', 'channel', 'onTurn', ...OPTIONS]);
  const { knobs, channel, onTurn, signal } = options;
  const entries = Object.entries(requireObject(knobs)).map(([knob, ranges]) => [
    requireKnob(knob),
    requireRanges(`knobs.${knob}`, ranges),
  ]) as [number, ReturnType<typeof requireRanges>][];
  if (channel !== undefined && !(Number.isInteger(channel) && channel >= 1 && channel <= CHANNELS))
    throw new ParameterError('channel', channel, 'a whole number from 1 to 16');
  if (onTurn !== undefined && typeof onTurn !== 'function') throw new ParameterError('onTurn', onTurn, 'a function');
  requireDriver(smoke, options);
  const access = await requestAccess();
  signal?.throwIfAborted();
  const turned = new Map<number, number>();
  return drive(
    smoke,
    {
      tracks: entries.map(([, lanes]) => lanes),
      isControl: true,
      start(wake, end) {
        const receive = ({ data }: MIDIMessageEvent) => {
          if (data?.length !== 3 || (data[0] & 0xf0) !== CONTROL_CHANGE) return;
          if (channel !== undefined && (data[0] & 0x0f) + 1 !== channel) return;
          turned.set(data[1], data[2] / 127);
          onTurn?.(data[1]);
          wake();
        };
        const connectInputs = () => {
          for (const input of access.inputs.values()) input.addEventListener('midimessage', receive, { signal: end });
        };
        // The same function is added to an input once.
        access.addEventListener('statechange', connectInputs, { signal: end });
        connectInputs();
      },
      measure: () => entries.map(([knob]) => turned.get(knob)),
    },
    options,
  );
}

async function requestAccess(): Promise<MIDIAccess> {
  // Absent in Safari, and on pages without HTTPS.
  const { requestMIDIAccess } = navigator as Partial<Pick<Navigator, 'requestMIDIAccess'>>;
  if (!requestMIDIAccess)
    throw new UnsupportedError(
      isSecureContext
        ? 'This browser has no Web MIDI. Chrome, Edge and Firefox have it.'
        : 'Browsers give access to MIDI devices only to pages that are served by HTTPS or from localhost.',
    );
  try {
    return await requestMIDIAccess.call(navigator);
  } catch (cause) {
    throw new UnsupportedError(
      'Access to MIDI devices was refused. Allow it in the settings of the browser for this page, and call driveByMidi() again. ' +
        'A page in an iframe needs allow="midi" there, and no header of the page may forbid it.',
      { cause },
    );
  }
}

function requireObject(knobs: unknown): object {
  if (typeof knobs !== 'object' || knobs === null || Object.keys(knobs).length === 0)
    throw new ParameterError('knobs', knobs, "ranges by knob, such as { 21: { 'emission.rate': [0, 60] } }");
  return knobs;
}

function requireKnob(text: string): number {
  const knob = Number(text);
  requireWhole(`knobs.${text}`, knob);
  if (knob > MAX_KNOB) throw new ParameterError(`knobs.${text}`, text, `the number of a controller, 0 to ${MAX_KNOB}`);
  return knob;
}
