/** The page in a frame, `embed.html`: smoke by the same hash and query as the demo, without its panel. */
import { CartoonSmokeElement } from '../element/define.ts';
import { answerPage, originOf } from './answerPage.ts';
import { HANDED_ON } from '../element/methods.ts';
import { SimulatorError, LoadError } from '../preset/errors.ts';
import type { RemoteMethods, RemoteStage } from '../remote/contract.ts';
import { unpackBytes } from '../preset/packing.ts';
import { takeWasmFrom } from '../sim/load.ts';

/** Written by the build: the core, deflated, in base64url; and the address of the script that brings the physics. */
declare const CORE_WASM: string | undefined;
declare const PHYSICS_SCRIPT: string;

/** What that script calls. */
type Bring = (packed: string) => void;
type Asked = (...given: never[]) => Promise<unknown>;

const MAX_BYTES = 16 * 1024 * 1024;

function begin(smoke: CartoonSmokeElement): void {
  // A worker would need an origin, and most browsers give a frame of another site a thread of its own.
  smoke.thread = 'main';
  smoke.interactive = new URLSearchParams(location.search).get('interactive') !== '0';
  const follow = () => (smoke.src = location.href);
  addEventListener('hashchange', follow);
  follow();
  const stand = () => {
    // Whoever was here before has ended it.
    if (!smoke.isConnected) document.body.prepend(smoke);
    return smoke.stage;
  };
  answerPage(elementStage(smoke), originOf(location.search), stand);
}

/** The smoke of an element as a RemoteStage. The element knows by itself how large it is and whether it is in view. */
function elementStage(element: CartoonSmokeElement): RemoteStage {
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

/**
 * Takes the WASM from the scripts of a built page: nothing else can be fetched in a sandbox without an origin. From a
 * development server it is fetched.
 */
function useBytesInside(): void {
  if (typeof CORE_WASM === 'undefined') return;
  takeWasmFrom(async (physics) => {
    const packed = physics ? await fetchPhysics(PHYSICS_SCRIPT) : CORE_WASM;
    return (await unpackBytes(packed, MAX_BYTES)).bytes;
  });
}

function fetchPhysics(address: string): Promise<string> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    (globalThis as { bringPhysics?: Bring }).bringPhysics = resolve;
    script.onload = () => script.remove();
    script.onerror = () => reject(new LoadError(`${address} could not be fetched.`));
    script.src = address;
    document.head.append(script);
  });
}

useBytesInside();
const found = document.querySelector('cartoon-smoke');
if (found instanceof CartoonSmokeElement) begin(found);
