/** Balls and crates that are kept far below the scene until the user drops them. */
import type { Color } from '../renderer/gpu/ramps.ts';
import type { RigidDescription } from '../simulator/rigid.ts';
import { Dropped } from './dropped.ts';
import { ballModel, crateModel, jollyBall, jollyCrate } from './models/toys.ts';
import type { Scene } from './scene.ts';

/** Metres: ball radius, and half of a crate's side. */
const BALL = 0.22;
const CRATE = 0.2;
/** Where unused objects sleep, stacked vertically, so that they do not widen the bounds of the rigids. */
const CELLAR = -500;
const STOREY = 3;

const CREAM: Color = [252, 232, 196];
/** Colours of a ball and its band; undefined for a crate. */
const THINGS: readonly (readonly [Color, Color] | undefined)[] = [
  undefined,
  [[82, 156, 214], CREAM],
  undefined,
  [[250, 190, 76], [226, 100, 90]],
  undefined,
  [[236, 96, 84], CREAM],
]; // prettier-ignore

/** Adds droppable objects, unless the scene defines its own. */
export function withDrops(scene: Scene): Scene {
  return dropping(scene.drops ? scene : withThings(scene));
}

function dropping(scene: Scene): Scene {
  return { ...scene, createDropped: () => new Dropped(scene.drops!, scene.rigids) };
}

function withThings(scene: Scene): Scene {
  const first = scene.rigids.length;
  const drops = THINGS.map((_, index) => first + index);
  const [ball, crate] = [ballModel(BALL), crateModel(CRATE)];
  const toys = THINGS.flatMap((colors, index) =>
    colors ? jollyBall(drops[index], ball, ...colors) : jollyCrate(drops[index], crate),
  );
  return {
    ...scene,
    drops,
    rigids: [...scene.rigids, ...THINGS.map(thing), cellar(), ...groundOf(scene)],
    surfaces: [...scene.surfaces, ...toys],
  };
}

function thing(colors: (typeof THINGS)[number], index: number): RigidDescription {
  const shape = colors
    ? ({ type: 'ball', radius: BALL } as const)
    : ({ type: 'cuboid', halfExtents: [CRATE, CRATE, CRATE] } as const);
  return {
    kind: 'dynamic',
    shape,
    position: [0, CELLAR - STOREY * index, 0],
    restitution: colors ? 0.7 : 0.3,
    friction: 0.6,
    density: 120,
  };
}

function cellar(): RigidDescription {
  const parts = THINGS.map((colors, index) => ({
    shape: { type: 'cuboid', halfExtents: [0.4, 0.1, 0.4] } as const,
    position: [0, -STOREY * index - (colors ? BALL : CRATE) - 0.1, 0] as const,
  }));
  return { kind: 'fixed', shape: { type: 'compound', parts }, position: [0, CELLAR, 0] };
}

function groundOf({ ground }: Scene): RigidDescription[] {
  if (!ground) return [];
  const shape = { type: 'compound', parts: ground } as const;
  return [{ kind: 'fixed', shape, position: [0, 0, 0], restitution: 0.4, friction: 0.7 }];
}
