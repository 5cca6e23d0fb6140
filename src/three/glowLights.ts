import { PointLight, type Object3D } from 'three';
import { CANDELA, glowColors } from '../renderer/glow.ts';
import type { Style } from '../renderer/style.ts';
import { LAMP_FLOATS } from '../simulator/layout.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { newPose } from './shapes.ts';
import type { SmokeFrame } from './smokeSpace.ts';

/** Number of lights. */
const LIGHTS = 3;

/** What the lights of a frame follow from. */
interface Glowing {
  /** The smoke object. */
  readonly object: Object3D;
  readonly frame: SmokeFrame;
  readonly simulator: Simulator;
  readonly style: Style;
  readonly blend: number;
}

/** Point lights at the glowing parts of smoke, for the objects of a host's scene. */
export class GlowLights {
  readonly lights: readonly PointLight[] = Array.from({ length: LIGHTS }, (_, index) => {
    const light = new PointLight(undefined, 0);
    light.name = `CartoonSmoke.glowLights.${index}`;
    return light;
  });
  private style: Style | undefined;
  private colors: Float32Array | undefined;

  /** Moves the lights to where smoke glows between the last two steps, in the space of the smoke object. */
  show({ object, frame, simulator, style, blend }: Glowing): void {
    if (style !== this.style) this.colors = glowColors(style);
    object.updateWorldMatrix(true, false);
    this.style = style;
    const lamps = this.colors && simulator.glow(blend, this.colors);
    this.lights.forEach((light, index) => {
      const [x, y, z, , ...color] = lamps?.subarray(LAMP_FLOATS * index, LAMP_FLOATS * (index + 1)) ?? [
        0, 0, 0, 0, 0, 0, 0,
      ];
      const [red, green, blue] = color;
      const strength = Math.max(red, green, blue);
      light.intensity = CANDELA * strength * frame.now.scale ** 2;
      if (strength === 0) return;
      light.color.setRGB(red / strength, green / strength, blue / strength);
      light.position.set(x, y, z);
      // Local smoke is drawn where its object is now, which may have moved since the last step.
      if (frame.space === 'world')
        object.worldToLocal(frame.toWorld({ ...newPose(), position: light.position }).position);
    });
  }

  /** Turns the lights off, for those that stay in a scene. */
  dispose(): void {
    for (const light of this.lights) {
      light.intensity = 0;
      light.dispose();
    }
  }
}
