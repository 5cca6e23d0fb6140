import type { Preset } from '../parameter.ts';

export const presets: readonly Preset[] = [
  {
    name: 'teapot',
    values: {
      scene: 'teapot',
      // The pot blows for a while, and then nothing passes the gaps between the letters.
      'emitters.0.envelope.start': 0.2,
      'emitters.0.envelope.duration': 2.7,
      'emitters.0.envelope.period': 12,
      'emission.rate': 370,
      'emission.lifetime': 7.2,
      'emission.growthTime': 0.5,
      'emission.density': '0:1,.9:.95,1:0',
      'simulation.maxParticles': 2800,
      'turbulence.speed': 0.15,
      'turbulence.scale': 0.5,
      // The word TEA.
      'shapes.0.outline':
        'AJU5g4g5gg4Hgg1g2g1IggLgKgLHg.GJU9g9gg2PgOggr8gg2Eggrygxgg2DgDg.MhU6gp9q-p9IgcRGgcvIg.NVqkwkwQg',
      'shapes.0.speed': 2.6,
      'shapes.0.hold': 8,
      'shapes.0.size': 3.4,
      'shapes.0.depth': 0.16,
      'shapes.0.position.x': 0.1,
      'shapes.0.position.y': 2.1,
      'shapes.0.envelope.start': 0.5,
      'shapes.0.envelope.duration': 6.1,
      'shapes.0.envelope.period': 12,
      'shapes.0.envelope.fade': 0.6,
      'puff.size': 0.62,
      'style.simplify': 3,
      'style.form': 0.4,
    },
  },
];
