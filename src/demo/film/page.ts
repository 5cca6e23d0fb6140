/** The page that `cartoon-smoke film` opens in a browser. It asks the command for work. */
import { Receiver } from './receiver.ts';

const receiver = new Receiver();

async function run(): Promise<void> {
  const { film, flipbook } = await import('./film.ts');
  const order = await receiver.order();
  if ('columns' in order) await flipbook(order, receiver);
  else await film(order, receiver);
  await receiver.end();
}

addEventListener('error', ({ message }) => void receiver.fail(message));
run().catch((error: unknown) => receiver.fail(error));
