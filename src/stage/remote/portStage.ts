import { SimulatorError } from '../../base/errors.ts';
import type { LoadProgress } from '../../simulator/load.ts';
import type { StageEvents } from '../contract.ts';
import { Listeners } from '../listeners.ts';
import type { RemoteStage, Thread } from './contract.ts';
import { makeMethods } from './makeMethods.ts';
import { methodNames, methods } from './methods.ts';
import { OPENING, packArgument, readReply, readNotification, type EventName, type Method } from './protocol.ts';

interface Waiting {
  readonly method: Method;
  readonly resolve: (value: unknown) => void;
  readonly reject: (error: Error) => void;
}

const ended = () => new SimulatorError('This stage was disposed; create a new one.');

/** A stage at the other end of a MessagePort. */
export class PortStage {
  /** Resolves when the stage is open; rejects with the error that prevented it. */
  readonly opened: Promise<void>;
  readonly stage: RemoteStage;
  private readonly port: MessagePort;
  private readonly release: () => void;
  private readonly onProgress: ((progress: LoadProgress) => void) | undefined;
  private readonly listeners = new Listeners<StageEvents>();
  private readonly waiting = new Map<number, Waiting>();
  private latest = OPENING;
  private failure: Error | undefined;
  private hasEnded = false;

  /** @param release called once, after disposal */
  constructor(
    port: MessagePort,
    thread: Thread,
    release: () => void = () => {},
    onProgress?: (progress: LoadProgress) => void,
  ) {
    this.port = port;
    this.release = release;
    this.onProgress = onProgress;
    this.opened = new Promise((resolve, reject) => {
      this.waiting.set(OPENING, { method: 'listen', resolve: () => resolve(), reject });
    });
    // Avoids an unhandled rejection when `opened` is not awaited.
    this.opened.catch(() => undefined);
    this.stage = this.makeFace(thread);
    port.onmessage = ({ data }) => this.receive(data);
  }

  /** The other side is gone: rejects pending and later calls and notifies the error listeners. */
  fail(error: Error): void {
    if (this.hasEnded || this.failure) return;
    this.failure = error;
    this.rejectAll(error);
    this.listeners.notify('error', error);
  }

  /** Closes this connection without disposing the stage. */
  abandon(): void {
    this.hasEnded = true;
    this.rejectAll(ended());
    this.port.close();
  }

  private makeFace(thread: Thread): RemoteStage {
    return {
      // Extra arguments that only a stage accepts, such as functions, cannot be cloned.
      ...makeMethods(methodNames, (name, args) =>
        this.call(name, args.slice(0, methods[name].takes.length).map(packArgument)),
      ),
      ready: this.opened,
      thread,
      on: (event, listener) => this.listen(event, listener),
      dispose: () => this.dispose(),
    };
  }

  private call(method: Method, args: readonly unknown[]): Promise<unknown> {
    if (this.hasEnded || this.failure) return Promise.reject(this.failure ?? ended());
    const id = ++this.latest;
    return new Promise((resolve, reject) => {
      // First, because postMessage throws for values that cannot be cloned, and no reply would follow.
      this.port.postMessage({ id, method, args });
      this.waiting.set(id, { method, resolve, reject });
    });
  }

  private receive(message: unknown): void {
    const reply = readReply(message, (id) => (id === OPENING ? 'listen' : this.waiting.get(id)?.method));
    if (reply) {
      const isWaitedFor = this.waiting.has(reply.id);
      if (!isWaitedFor) return 'thrown' in reply ? this.fail(reply.thrown) : undefined;
      const { resolve, reject } = this.waiting.get(reply.id)!;
      this.waiting.delete(reply.id);
      return 'thrown' in reply ? reject(reply.thrown) : resolve(reply.value);
    }
    const notified = readNotification(message);
    if (notified?.event === 'progress') this.onProgress?.(notified.detail as LoadProgress);
    else if (notified) this.listeners.notify(notified.event, notified.detail as never);
  }

  private listen<Name extends EventName>(event: Name, listener: (detail: StageEvents[Name]) => void): () => void {
    const isFirst = !this.listeners.has(event);
    const end = this.listeners.add(event, listener);
    if (isFirst) this.mention('listen', event);
    return () => {
      end();
      if (!this.listeners.has(event)) this.mention('unlisten', event);
    };
  }

  /** Rejects only when the stage has ended, and then no events follow. */
  private mention(method: 'listen' | 'unlisten', event: EventName): void {
    this.call(method, [event]).catch(() => undefined);
  }

  private async dispose(): Promise<void> {
    if (this.hasEnded) return;
    this.listeners.clear();
    this.port.postMessage({ id: ++this.latest, method: 'dispose' });
    // Messages sent before closing are still delivered.
    this.abandon();
    this.release();
  }

  private rejectAll(error: Error): void {
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
  }
}
