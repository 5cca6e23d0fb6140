import type { Stage } from '../../index.ts';
import { create } from '../ui/dom.ts';
import type { Scrubber } from './scrubber.ts';
import { strings } from '../strings.ts';

/** Initial length of the timeline and its increment, in seconds: a compromise between range and precision. */
const SPAN_SECONDS = 10;
const STEP_SECONDS = 0.1;

/** A slider over simulated time. The thumb shows the requested time, the filled part the current time. */
export function createTimeline(stage: Stage, scrubber: Scrubber): HTMLInputElement {
  const name = strings.transport.timeline;
  const range = { type: 'range', min: 0, max: SPAN_SECONDS, step: STEP_SECONDS, value: 0 };
  const line = create('input', { ...range, class: 'timeline', 'aria-label': name, title: name });
  let isHeld = false;
  const fill = (seconds: number) => line.style.setProperty('--filled', String(seconds / Number(line.max)));
  const show = (seconds: number) => {
    const wanted = scrubber.wanted ?? seconds;
    const last = Math.max(seconds, wanted);
    if (last >= Number(line.max)) line.max = String(SPAN_SECONDS * (Math.floor(last / SPAN_SECONDS) + 1));
    if (!isHeld) line.value = String(wanted);
    line.setAttribute('aria-valuetext', strings.transport.time(line.valueAsNumber));
    fill(seconds);
  };
  scrubber.listen(() => show(stage.stats.time));
  stage.on('frame', ({ time }) => show(time));
  line.addEventListener('input', () => void scrubber.go(line.valueAsNumber));
  pauseWhileDragging(line, stage, (held) => (isHeld = held));
  show(stage.stats.time);
  return line;
}

/** Pauses the stage while a pointer holds the thumb, and resumes afterwards if it was playing. */
function pauseWhileDragging(line: HTMLInputElement, stage: Stage, notify: (isHeld: boolean) => void): void {
  line.addEventListener('pointerdown', () => {
    const goesOn = stage.playing;
    stage.pause();
    notify(true);
    const release = () => {
      removeEventListener('pointerup', release);
      removeEventListener('pointercancel', release);
      notify(false);
      if (goesOn) stage.play();
    };
    addEventListener('pointerup', release);
    addEventListener('pointercancel', release);
  });
}
