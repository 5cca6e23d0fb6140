import { withBase, type Theme } from 'vitepress';
import DefaultTheme from 'vitepress/theme-without-fonts';
import './site.css';
import DebugFigure from './debugFigure.ts';
import LiveSmoke from './liveSmoke.ts';
import MeasureCosts from './measureCosts.ts';
import { workOffline } from './offline.ts';

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    app.component('LiveSmoke', LiveSmoke);
    app.component('DebugFigure', DebugFigure);
    app.component('MeasureCosts', MeasureCosts);
    if (!import.meta.env.SSR) addEventListener('load', () => void workOffline(withBase('/')), { once: true });
  },
} satisfies Theme;
