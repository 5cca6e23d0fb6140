import type { CartoonSmokeElement } from '../element/cartoonSmokeElement.ts';
import { HANDED_ON } from '../element/methods.ts';
import { SimulatorError } from '../preset/errors.ts';
import type { RemoteMethods, RemoteStage } from '../remote/contract.ts';

/** The smoke of an element as a RemoteStage. The element knows by itself how large it is and whether it is in view. */
export function elementStage(element: CartoonSmokeElement): RemoteStage {
  const handedOn = HANDED_ON.map((name) => [
    name,
    async (...given: never[]) => {
      // One that is on no page would wait to be put back.
      if (!element.isConnected) throw new SimulatorError('This stage was disposed; connect again.');
      return (element[name] as Asked)(...given);
    },
  ]);
  return {
    ...(Object.fromEntries(handedOn) as Pick<RemoteMethods, (typeof HANDED_ON)[number]>),
    play: async () => element.play(),
    pause: async () => element.pause(),
    setBackground: async (isShown) => void (element.transparent = !isShown),
    resize: async () => {},
    setVisible: async () => {},
    ready: element.ready,
    thread: 'frame',
    on(event, listener) {
      const end = element.stage.then((stage) => stage.on(event, listener));
      return () => void end.then((stop) => stop());
    },
    dispose: async () => element.remove(),
  };
}

type Asked = (...given: never[]) => Promise<unknown>;
