/**
 * Debian's WebKitGTK, driven by W3C WebDriver. The five required commands are plain HTTP. Client libraries for Node are
 * far larger, and their current versions require a newer Node than this project.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { findFreePort } from '../../support/server.ts';
import { LIMIT, type Driver } from './driver.ts';
import { startDisplay, startProgram, stopProgram } from './display.ts';

/**
 * @param path of MiniBrowser
 * @param features enabled in addition to WebGL
 */
export async function startWebKit(path: string, features: readonly string[] = []): Promise<Driver> {
  const display = await startDisplay();
  const port = await findFreePort();
  const server = startProgram('WebKitWebDriver', [`--port=${port}`], {
    // Its sandbox needs privileges that containers lack.
    env: { ...display.environment, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' },
    stdio: 'ignore',
  });
  const address = `http://127.0.0.1:${port}`;
  await untilReady(`${address}/status`);
  const switches = ['WebGL', ...features].map((feature) => `+${feature}`).join();
  const browserOptions = { binary: path, args: ['--automation', `--features=${switches}`] };
  const { sessionId } = await command<{ sessionId: string }>('POST', `${address}/session`, {
    capabilities: {
      alwaysMatch: { 'webkitgtk:browserOptions': browserOptions, timeouts: { script: LIMIT, pageLoad: LIMIT } },
    },
  });
  const session = `${address}/session/${sessionId}`;
  const open = async (url: string) => void (await command('POST', `${session}/url`, { url }));
  const evaluate = async (expression: string) => {
    const script = `Promise.resolve().then(() => (${expression})).then(
      (value) => arguments[0]({ value }),
      (error) => arguments[0]({ error: [error, error?.stack].join('\\n') }),
    )`;
    type Answer = { value?: unknown; error?: string };
    const { value, error } = await command<Answer>('POST', `${session}/execute/async`, { script, args: [] });
    if (error !== undefined) throw new Error(error);
    return value;
  };
  return {
    open,
    evaluate,
    // WebGL reports "Apple GPU" on every machine; this internal page of WebKitGTK shows the actual renderer.
    async renderer() {
      await open('webkit://gpu');
      const text = await evaluate('document.body.innerText');
      return /GL_RENDERER\s+(.+)/.exec(String(text))?.[1] ?? 'unknown';
    },
    async close() {
      try {
        await command('DELETE', session);
      } finally {
        await stopProgram(server);
        await display.stop();
      }
    },
  };
}

async function untilReady(status: string): Promise<void> {
  const end = Date.now() + LIMIT;
  while (!(await answers(status))) {
    if (Date.now() > end) throw new Error('WebKitWebDriver does not answer.');
    await sleep(100);
  }
}

async function answers(address: string): Promise<boolean> {
  try {
    return (await fetch(address)).ok;
  } catch {
    return false;
  }
}

/** @throws the driver's response on an error */
async function command<Value>(method: string, address: string, body?: object): Promise<Value> {
  const response = await fetch(address, { method, body: body && JSON.stringify(body) });
  const { value } = (await response.json()) as { value: Value & { error?: string; message?: string } };
  if (!response.ok) throw new Error(`WebDriver: ${value.error}: ${value.message}`);
  return value;
}
