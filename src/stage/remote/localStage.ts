import { SimulatorError } from '../../base/errors.ts';
import type { Stage } from '../stage.ts';
import type { RemoteStage, Thread } from './contract.ts';
import { makeMethods, methodNames, methods, type MethodEntry, type MethodName } from './methods.ts';

/**
 * Wraps a stage of this thread as a RemoteStage.
 * @param release called once, after disposal
 */
export function localStage(stage: Stage, thread: Thread = 'main', release?: () => void): RemoteStage {
  let isDisposed = false;
  const call = async (name: MethodName, args: unknown[]) => {
    if (isDisposed) throw new SimulatorError('This stage was disposed; create a new one.');
    const entry: MethodEntry = methods[name];
    return entry.run(stage, ...args.slice(0, entry.takes.length));
  };
  return {
    ...makeMethods(methodNames, call),
    ready: stage.ready,
    thread,
    on: (event, listener) => stage.on(event, listener),
    async dispose() {
      if (isDisposed) return;
      isDisposed = true;
      stage.dispose();
      release?.();
    },
  };
}
