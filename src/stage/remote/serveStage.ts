import type { RemoteStage } from './contract.ts';
import { packError } from './packedErrors.ts';
import { packValue, readRequest, notificationOf, type EventName, type Method, type ReadRequest } from './protocol.ts';

/** Serves a stage on a MessagePort: handles requests and sends the events that the client listens to. */
export function serveStage(port: MessagePort, stage: RemoteStage): void {
  const service = new Service(port, stage);
  port.onmessage = ({ data }) => {
    const request = readRequest(data);
    if (request) void service.answer(request);
  };
}

class Service {
  private readonly port: MessagePort;
  private readonly stage: RemoteStage;
  private readonly ends = new Map<EventName, () => void>();

  constructor(port: MessagePort, stage: RemoteStage) {
    this.port = port;
    this.stage = stage;
  }

  async answer(request: ReadRequest): Promise<void> {
    const { id } = request;
    try {
      if ('error' in request) throw request.error;
      const { value, moved } = packValue(request.method, await this.act(request.method, request.args));
      this.port.postMessage({ id, value }, moved);
      if (request.method === 'dispose') this.port.close();
    } catch (error) {
      this.port.postMessage({ id, error: packError(error) });
    }
  }

  private act(method: Method, args: readonly unknown[]): unknown {
    if (method === 'listen') return this.listen(args[0] as EventName);
    if (method === 'unlisten') return this.unlisten(args[0] as EventName);
    return (this.stage[method] as (...given: readonly unknown[]) => unknown)(...args);
  }

  private listen(event: EventName): void {
    this.unlisten(event);
    const end = this.stage.on(event, (detail) => this.port.postMessage(notificationOf(event, detail)));
    this.ends.set(event, end);
  }

  private unlisten(event: EventName): void {
    this.ends.get(event)?.();
    this.ends.delete(event);
  }
}
