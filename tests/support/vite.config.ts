import { fileURLToPath } from 'node:url';
import { mergeConfig, type Plugin } from 'vite';
import site from '../../vite.config.ts';

/** Pages with a Content-Security-Policy from the query: `/page.html?policy=worker-src%20'none'`. */
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

/** The development server without hot reload, so that no page reloads during a test. */
export default mergeConfig(site, {
  root: fileURLToPath(new URL('../..', import.meta.url)),
  plugins: [policies()],
  cacheDir: '.cache/vite-tests',
  // Added to those of the site, which also sets `noDiscovery`.
  optimizeDeps: {
    include: [
      '@hotwired/turbo',
      'htmx.org',
      'idiomorph',
      'morphdom',
      'react-dom',
      '@vue/reactivity',
      'postprocessing',
      'three/examples/jsm/objects/Reflector.js',
      ...['GLTF', 'OBJ', 'PLY', 'STL', 'USDZ'].map((name) => `three/examples/jsm/exporters/${name}Exporter.js`),
      'three/examples/jsm/libs/fflate.module.js',
      'three/examples/jsm/utils/BufferGeometryUtils.js',
      'three/examples/jsm/postprocessing/EffectComposer.js',
      ...['Bokeh', 'GTAO', 'Output', 'Render', 'SSAO', 'UnrealBloom'].map(
        (name) => `three/examples/jsm/postprocessing/${name}Pass.js`,
      ),
    ],
  },
  server: { host: '127.0.0.1', hmr: false, watch: null },
});
