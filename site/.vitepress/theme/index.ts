import { withBase, type Theme } from 'vitepress';
import DefaultTheme from 'vitepress/theme-without-fonts';
import './site.css';
import { workOffline } from './offline.ts';

export default {
  extends: DefaultTheme,
  enhanceApp() {
    if (!import.meta.env.SSR) addEventListener('load', () => void workOffline(withBase('/')), { once: true });
  },
} satisfies Theme;
