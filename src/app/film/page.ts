/** The page that `cartoon-smoke film` opens in a browser. It asks the command for work. */
import { Receiver } from './receiver.ts';

const receiver = new Receiver();

async function run(): Promise<void> {
  const { film } = await import('./film.ts');
  await film(await receiver.order(), receiver);
  await receiver.end();
}

addEventListener('error', ({ message }) => void receiver.fail(message));
run().catch((error: unknown) => receiver.fail(error));
