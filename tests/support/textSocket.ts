/** A server of web sockets that sends text, as programs for streams have one. */
import { createHash } from 'node:crypto';
import { createServer } from 'node:http';
import type { AddressInfo, Socket } from 'node:net';

export interface TextSocket {
  readonly port: number;
  /** Sends a text of at most 125 bytes to all pages that are connected. */
  send(text: string): void;
  /** Ends all connections. */
  close(): Promise<void>;
}

/** Of RFC 6455, section 1.3. */
const KEY = '258EAFA5-E914-47DA-95CA-C5AB0DC85B11';

/** @param port of 127.0.0.1; 0 selects a free one */
export async function serveText(port = 0): Promise<TextSocket> {
  const sockets = new Set<Socket>();
  const server = createServer();
  server.on('upgrade', ({ headers }, socket: Socket) => {
    const accept = createHash('sha1').update(`${headers['sec-websocket-key']}${KEY}`).digest('base64');
    const answer = ['HTTP/1.1 101 Switching Protocols', 'Upgrade: websocket', 'Connection: Upgrade'];
    socket.write([...answer, `Sec-WebSocket-Accept: ${accept}`, '', ''].join('\r\n'));
    socket.on('error', () => socket.destroy());
    sockets.add(socket);
  });
  await new Promise<void>((resolve) => server.listen(port, '127.0.0.1', resolve));
  return {
    port: (server.address() as AddressInfo).port,
    send(text) {
      // A single frame: 0x81 is the last one, of text.
      const frame = Buffer.from([0x81, Buffer.byteLength(text), ...Buffer.from(text)]);
      for (const socket of sockets) socket.write(frame);
    },
    close() {
      for (const socket of sockets) socket.destroy();
      return new Promise((resolve) => server.close(() => resolve()));
    },
  };
}
