import react from '@vitejs/plugin-react';
import { defineConfig } from 'vitest/config';

const server = process.env.APSIS_SERVER ?? 'http://localhost:8080';
const proxy = { '/physics-engine-websocket': { target: server, ws: true } };

export default defineConfig({
  plugins: [react()],
  // sockjs-client reads `global`, which browsers do not have.
  define: { global: 'globalThis' },
  server: { proxy },
  preview: { proxy },
  build: {
    sourcemap: false,
    // p5 is the largest part; it comes in one piece because it is not split further, and is cached by its own hash.
    chunkSizeWarningLimit: 700,
    rolldownOptions: {
      output: {
        // p5 is LGPL: an unmodified module in a file of its own, so that it can be replaced.
        codeSplitting: { groups: [{ name: 'p5', test: /node_modules[\\/]p5[\\/]/ }] },
      },
    },
  },
  test: {
    environment: 'jsdom',
    include: ['src/**/*.test.{ts,tsx}'],
    setupFiles: ['src/testSetup.ts'],
    css: { modules: { classNameStrategy: 'non-scoped' } },
  },
});
