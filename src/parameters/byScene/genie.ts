import type { Values, Preset } from '../parameter.ts';

/** Values shared by all presets of this scene. */
const smoke: Values = {
  scene: 'genie',
  'emission.rate': 190,
  'emission.lifetime': 2,
  'emission.growthTime': 0.5,
  'emission.density': '0:1,.7:1,1:0',
  'forces.turbulence': 0.6,
  'simulation.maxParticles': 1000,
  'puff.turn': 0.6,
  'puff.stretch': 1.4,
  'puff.billow': 0.5,
  'style.simplify': 4,
  'style.form': 0.3,
};

export const presets: readonly Preset[] = [
  {
    name: 'genie',
    values: {
      ...smoke,
      'style.smokeColor': '#8ccbf0',
      'style.inkColor': '#221a3e',
      'style.innerLine': 0.42,
      'style.strokes': 0.4,
      'light.azimuth': 38,
      'light.elevation': 46,
    },
  },
  {
    name: 'genie-sumi-e',
    values: {
      ...smoke,
      'style.ramp': '0:c9c6c0,.36:fbf9f2',
      'style.inkColor': '#17161a',
      'style.outlineWidth': 3.4,
      'style.inkSwell': 1,
      'style.boil': 0.5,
      'style.innerLine': 0.5,
      'style.backdrop': '0:f2efe6,1:faf8f1',
      'style.wash': 1,
      'style.washColor': '#f6f3ea',
      'light.azimuth': 38,
      'light.elevation': 52,
      'style.strokes': 0.5,
    },
  },
  {
    name: 'genie-potion',
    values: {
      ...smoke,
      'emission.rate': 80,
      'puff.drawing':
        'ffffff*N1oeRcRZTXUVVSYSZQcQfQhQkSnSoVrXsZtcveviukvntpsrrupumwkwhwfwcuauXrVpUnTkR,ffffff*F6l3g2g3g1sfzezcvYmOiKgKgOeYacRfNeN,4a3a66*HF2dYbaZbZeYgZjalcnfogojolnmkojofnemakZhY,4a3a66*L-AgYfYcZabZdYgZiZlbmdogohoknmmniohodmclZ,4a3a66*ICRs7YdccckYj,*GzMg_.IDJgzgy.JTMg_.ESSjkkkkkkjkjkj.KWnkdkdkdkckcjc;ffffff*N1oeRcRZTXUVVSYSZQcQfQhQkSnSoVrXsZtcveviukvntpsrrupumwkwhwfwcuauXrVpUnTkR,ffffff*F6l3g2g3g1sfzezcvYmOiKgKgOeYacRfNeN,4a3a66*HSFhZeYaZYaXcWeYhZjbmfninmnnmqkpipfnd,4a3a66*MJtbaZdYfWiXkYmaneohnllnjphpeqcnamZiZ,4a3a66*ICRs7YdccckYj,*GzMg_.IDJgzgy.JTMg_.ESSjkkkkkkjkjkj.KWnkdkdkdkckcjc',
      'puff.upright': 0.9,
      'puff.size': 0.95,
      'style.simplify': 0,
      'style.form': 0,
      'style.ramp': '0:5cae6a,.34:9fe08a,.66:e6ffc0',
      'style.inkColor': '#16241e',
      'style.outlineWidth': 2.2,
      'style.backdrop': '0:6a4a8c,1:241a44',
      'style.wash': 0.45,
      'style.washColor': '#b8a0e0',
      'light.azimuth': 38,
      'light.elevation': 46,
    },
  },
];
