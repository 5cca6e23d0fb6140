/** Entry of `overlay.html`: the smoke of a link over a stream, and nothing else. docs/overlay.md explains the query. */
import { createStage } from '../../index.ts';
import { pauseWhileHidden, readEnvironment, sizeOf, watchSize } from '../../internal.ts';
import { decode } from '../../preset.ts';
import { create } from '../ui/dom.ts';
import { listen } from './listen.ts';
import { readOptions } from './options.ts';
import { Player } from './player.ts';

const MAX_MESSAGES = 8;

const canvas = document.querySelector('canvas')!;
const messages = document.querySelector('#messages')!;
const { triggers, seconds, waits, explains, notices } = readOptions(location.search);

/** Viewers of a stream see no messages. */
function say(sentence: string): void {
  if (!explains) return;
  messages.append(create('p', {}, sentence));
  if (messages.childElementCount > MAX_MESSAGES) messages.firstElementChild!.remove();
}

function fail(error: unknown): void {
  say(error instanceof Error ? error.message : String(error));
}

async function start(): Promise<void> {
  const environment = readEnvironment(location.search);
  const { state, take, notices: ofLink } = await decode(location.hash);
  for (const { message } of [...notices, ...environment.notices, ...ofLink]) say(message);
  const { quality } = environment;
  const options = { values: state.values, ...sizeOf(canvas), quality, background: false, visible: false };
  const stage = await createStage(canvas, options);
  stage.on('error', fail);
  watchSize(canvas, ({ width, height, pixelRatio }) => stage.resize(width, height, pixelRatio));
  pauseWhileHidden(stage);
  const player = new Player(stage, canvas, { state, take, lead: environment.time ?? 0, seconds });
  const play = () => void player.start().catch(fail);
  listen(triggers, play, say);
  if (!waits) play();
  else say('Ready.');
}

start().catch(fail);
