import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';

/** The demo site: relative addresses, so that it works from any folder of any host. */
export default defineConfig({
  base: './',
  plugins: [glsl()],
  build: { target: 'es2023', sourcemap: true, chunkSizeWarningLimit: 800 },
});
