import type { Values, Preset } from '../parameter.ts';

/** Values shared by all presets of this scene; those with looks of their own are in wispLooks.ts. */
export const smoke: Values = {
  scene: 'wisp',
  'emission.rate': 18,
  'emission.lifetime': 4.5,
  'emission.growthTime': 2.2,
  'forces.turbulence': 1.2,
  'turbulence.scale': 0.7,
  'simulation.maxParticles': 400,
  'puff.turn': 0.6,
  'puff.stretch': 1.4,
  'puff.billow': 0.5,
  'emission.density': '0:1,.85:.45,1:0',
  'emission.dissolve': 'thin',
  'emitters.0.lifetimeVariation': 0.05,
  'style.simplify': 3,
  'style.form': 0.4,
  'light.azimuth': 30,
  'light.elevation': 40,
};

/** A vortex beside the cup, around which the smoke winds. */
export const curl: Values = {
  'vortices.0.circulation': -1.6,
  'vortices.0.coreRadius': 0.4,
  'vortices.0.reach': 1.6,
  'vortices.0.position.x': -0.25,
  'vortices.0.position.y': 2.1,
};

export const presets: readonly Preset[] = [
  {
    name: 'wisp',
    values: {
      ...smoke,
      ...curl,
      'style.smokeColor': '#fffaf0',
    },
  },
];
