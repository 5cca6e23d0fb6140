import type { Values, Preset } from '../parameter.ts';

/** The first look of the scene. */
const evening: Values = {
  scene: 'campfire',
  'emission.rate': 70,
  'emission.lifetime': 4.4,
  'emission.growthTime': 0.35,
  'emission.density': '0:1,.1:.8,.22:.5,.32:.5,.55:1,1:0',
  'forces.turbulence': 1.5,
  'forces.wind.x': 0.12,
  'simulation.maxParticles': 800,
  'style.ramp': '0:a88fb8,.3:d9c2cc,.6:ffffff',
  'style.heatRamp': '0:7a7494,.13:9a7078,.24:cf6a4c,.36:ea7a38,.54:f99f3e,.8:ffe38c,1:fff0bb',
  // Without blending, a whole puff changes its colour band at once.
  'style.softColors': 1,
  'style.rim': 0.22,
  'style.rimColor': '#d9c8f2',
  'style.inkColor': '#1b1226',
  'style.innerLine': 0.22,
  'light.azimuth': 26,
  'light.elevation': 38,
  'puff.turn': 0.6,
  'puff.stretch': 1.4,
  'puff.billow': 0.4,
  'style.simplify': 3,
};

export const presets: readonly Preset[] = [
  {
    name: 'campfire',
    values: evening,
  },
  {
    name: 'campfire-night',
    values: {
      ...evening,
      'emission.rate': 80,
      // Fire keeps its colour, and smoke takes on that of the night as soon as it is no longer red.
      'emission.glow': '.15:0,.19:1',
      'emitters.1.size': 0.06,
      'emitters.1.share': 0.3,
      'style.heatRamp': '0:a4a4d0,.13:a8788c,.24:d4603f,.36:ee7632,.54:fa9c3a,.8:ffd878,1:fff2c0',
      'style.rim': 0,
      'style.inkLight': 0.5,
      'style.backdrop': '0:4050a0,.5:27346f,1:141b48',
      'light.azimuth': -10,
      'light.elevation': 44,
      'light.color': '#8ca8ff',
      'light.intensity': 0.45,
      'light.ambientColor': '#6c82e0',
      'light.ambient': 0.28,
    },
  },
  {
    name: 'campfire-popcorn',
    values: {
      scene: 'campfire',
      'emission.rate': 26,
      'emission.lifetime': 2.6,
      'emission.growthTime': 0.25,
      'emission.density': '0:.5,.15:1,.92:1,1:0',
      'emitters.0.speed': 5.2,
      'emitters.0.speedVariation': 0.3,
      'emitters.0.spread': 0.42,
      'emitters.0.size': 0.22,
      'emitters.0.sizeVariation': 0.25,
      'emitters.0.temperature': 0,
      'emitters.1.share': 0,
      'gravity.acceleration': 4.2,
      'drag.rate': 0.4,
      'simulation.maxParticles': 300,
      'puff.drawing':
        'ffffff*IpZeRZSWUTYScQgSkToWsaudvjvmuqstoukwguctYqUnS,ffffff*OJPdQaSVUTXQcQgRkTpVsaudwjwmvrstovlwgwbtYrUmR,ffffff*O6YeTaTXWUYTcSgTkUoXqatetiumtpqsotkugtcsYpWmT,ffffff*HaleSaTXWVYScSgTkUoXqbteuitltpqsotkugucrYpWmT,ffffff*Lm4eSaSXVTZSbSgSlUnWraueuivmtqrsoukuguctYpVmT,ffffff*LGAeSaUXVUZTcSgTkUnXraseuiumsprsntkugtcsZpVmU,f2b84a*JuKdYaZWdVgWjZneoionmqkrgqcma,*GaLqcpZnYlWkWhV.HJZjpkplonnompk.LandYbZbaZbZcYe.HK5jYhWgXeXcYbY;ffffff*LhIeQZSWTSYRbQgRlSoWtZuewiwnuqsupvkwgvcuXqUnS,ffffff*HaAeSaSXVTYScSgSkToXraueuiumuprtoukuguctYpVmS,ffffff*PN-dQaRVUTYRbQgQlToVsavdwjvmvrstpwkwgvctXrUmR,ffffff*Ja_eTbUXWVZTdTgTjVnYqasetiumsoprotjtgtdrYpXlU,ffffff*M69eUbWZXWZVdUgUjWnZpbqesislqnpqnsjsgrdqZnXlW,ffffff*LGAeSaUXVUZTcSgTkUnXraseuiumsprsntkugtcsZpVmU,f2b84a*IeMfXbYZcYgakboepiqlnmlognblZ,*FVsppsmskthtesa.GqhmXkXiVgWeWbW.IZqdpfphpipjolo.JCocbbbbbadadaf;ffffff*IpIeTaUYWVZTcTgTkVnXqbsetitlspqrntktgtcrZoWmU,ffffff*NhDeUbUYXVZUdUgUjVnYpbsesislsoprnsjsgsdrZoXlU,ffffff*PN-eTbVYWVaUcUgUkVmYqbretislroqrnsjsgsdrZoWlV,ffffff*NW4eSbUXVUZTcSgSkVnXraseuiumtpqroujugtdsYpWlT,ffffff*IyxeRaSWUTYRcRgRkToWsauevivmuqrtpvkvgvctXqVmS,ffffff*Gh5eTbVXWWaUcTgUkWmYqbretislroqqnsjtgsdqZpWlV,ffffff*LiAeQZSWUSXRbQgRlSpWsZuewiwnuqsupvlwgvbuXqUnS,f2b84a*KB-dZaaWdVgWjZmenimnmqjrgqdma,*ImebWYXXZWaVeUf.KWHZhZhZjajalbl.INSjnkmmmmknjni.GtzodmbmblZjZiY',
      'style.ramp': '0:d6a878,.34:fff0d0,.66:fffaf0',
      'style.inkColor': '#2c1826',
      'style.innerLine': 0.22,
      'light.azimuth': 26,
      'light.elevation': 38,
    },
  },
];
