import { fileURLToPath } from 'node:url';
import { mergeConfig, type Plugin } from 'vite';
import site from '../../vite.config.ts';

/** Pages under a Content-Security-Policy of the test's choice: `/page.html?policy=worker-src%20'none'`. */
function policies(): Plugin {
  return {
    name: 'policies',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const { searchParams } = new URL(request.url ?? '/', 'http://localhost');
        const policy = searchParams.get('policy');
        if (policy) response.setHeader('content-security-policy', policy);
        next();
      });
    },
  };
}

/** The development server as the tests want it: nothing reloads a page in the middle of a test. */
export default mergeConfig(site, {
  root: fileURLToPath(new URL('../..', import.meta.url)),
  plugins: [policies()],
  cacheDir: '.cache/vite-tests',
  server: { host: '127.0.0.1', hmr: false, watch: null },
});
