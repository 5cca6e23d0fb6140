/**
 * Debian's WebKitGTK, which speaks W3C WebDriver. The four commands that are needed are plain HTTP; the client
 * libraries for Node are far larger, and their current versions need a newer Node than the project does.
 */
import { spawn } from 'node:child_process';
import { setTimeout as sleep } from 'node:timers/promises';
import { findFreePort } from '../../support/server.ts';
import { startDisplay, stopProcess } from './display.ts';
import type { Driver } from './driver.ts';

export async function startWebKit(path: string, limit: number): Promise<Driver> {
  const display = await startDisplay();
  const port = await findFreePort();
  const server = spawn('WebKitWebDriver', [`--port=${port}`], {
    // Its sandbox needs rights that containers do not give.
    env: { ...display.environment, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' },
    stdio: 'ignore',
  });
  const address = `http://127.0.0.1:${port}`;
  await untilReady(`${address}/status`, limit);
  const capabilities = {
    alwaysMatch: {
      'webkitgtk:browserOptions': { binary: path, args: ['--automation', '--features=+WebGL'] },
      timeouts: { script: limit, pageLoad: limit },
    },
  };
  const { sessionId } = await command<{ sessionId: string }>('POST', `${address}/session`, { capabilities });
  const session = `${address}/session/${sessionId}`;
  return {
    open: async (url) => void (await command('POST', `${session}/url`, { url })),
    evaluate: async (expression) => {
      const script = `const done = arguments[0];
        Promise.resolve().then(() => (${expression})).then((value) => done({ value }), (error) => done({ error: String(error) + '\\n' + error?.stack }))`;
      const answer = await command<{ value?: unknown; error?: string }>('POST', `${session}/execute/async`, {
        script,
        args: [],
      });
      if (answer.error !== undefined) throw new Error(answer.error);
      return answer.value;
    },
    close: async () => {
      await command('DELETE', session);
      await stopProcess(server);
      await display.stop();
    },
  };
}

async function untilReady(status: string, limit: number): Promise<void> {
  const end = Date.now() + limit;
  while (
    !(await fetch(status).then(
      ({ ok }) => ok,
      () => false,
    ))
  ) {
    if (Date.now() > end) throw new Error('WebKitWebDriver does not answer.');
    await sleep(100);
  }
}

async function command<Value>(method: string, address: string, body?: object): Promise<Value> {
  const response = await fetch(address, { method, body: body && JSON.stringify(body) });
  const { value } = (await response.json()) as { value: Value & { error?: string; message?: string } };
  if (!response.ok) throw new Error(`WebDriver: ${value.error}: ${value.message}`);
  return value;
}
