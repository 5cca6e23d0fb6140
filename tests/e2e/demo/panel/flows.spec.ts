import type { Page } from '@playwright/test';
import { readPath, type PathPoint } from '../../../../src/parameters/path.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { bendingColumn, turningBox } from '../../../support/files/glb.ts';
import { ask, expectValue, LIGHT, open, valueOf } from '../page.ts';

type Place = readonly [x: number, y: number];

const handle = (index: number) => `[data-gizmo="flows.0.points.${index}"]`;
/** A preset without its smoke. */
const without = (preset: string) => `#v=1&preset=${preset}&emission.rate=0&puff.variations=1`;
const handles = (page: Page) => page.locator('[data-gizmo^="flows"]').filter({ visible: true });
const pointsOf = async (page: Page) =>
  (((await valueOf(page, 'flows.0.points')) as string | undefined) ?? '').split(',');

/** Waits for the points of the stroke: its first handle may be focused before they can be read. */
async function drawnPoints(page: Page): Promise<string[]> {
  await expect.poll(async () => (await pointsOf(page)).length).toBeGreaterThan(3);
  const points = await pointsOf(page);
  await expect(handles(page)).toHaveCount(points.length);
  return points;
}

/** Opens the page with the handles and the brush. */
async function begin(page: Page): Promise<void> {
  await page.setViewportSize({ width: 690, height: 480 });
  await open(page, `?paused=1&t=1${LIGHT}`);
  await page.keyboard.press('h');
  await page.getByRole('button', { name: 'Draw a flow' }).click();
}

async function draw(page: Page, places: readonly Place[]): Promise<void> {
  const [[x, y], ...rest] = places;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const [toX, toY] of rest) await page.mouse.move(toX, toY, { steps: 4 });
  await page.mouse.up();
}

const S: readonly Place[] = [
  [250, 380],
  [420, 340],
  [300, 240],
  [430, 160],
];

test('a stroke over the picture is a flow with a handle for each point, with undo', async ({ page }) => {
  await begin(page);
  await draw(page, S);
  const points = await drawnPoints(page);
  await expectValue(page, 'flows.0.closed', 'open');
  const ends = [S[0], S.at(-1)!];
  for (const [at, index] of [0, points.length - 1].entries()) {
    const box = (await page.locator(handle(index)).boundingBox())!;
    const off = Math.hypot(box.x + box.width / 2 - ends[at][0], box.y + box.height / 2 - ends[at][1]);
    expect(off, 'the handle is where the stroke was').toBeLessThan(4);
  }
  await page.keyboard.press('Control+z');
  await expectValue(page, 'flows.0.points', undefined);
  await expect(handles(page)).toHaveCount(0);
});

test('a stroke that returns to its start is a ring', async ({ page }) => {
  await begin(page);
  await draw(page, [...S, [250, 200], [252, 372]]);
  await expectValue(page, 'flows.0.closed', 'ring');
});

test('points are moved, added and removed by pointer and keys', async ({ page }) => {
  await begin(page);
  await draw(page, S);
  await expect(page.locator(handle(0))).toBeFocused();
  const points = await drawnPoints(page);
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => pointsOf(page)).not.toEqual(points);
  const moved = await pointsOf(page);
  expect(moved.slice(1)).toEqual(points.slice(1));
  await page.keyboard.press('Enter');
  await expect(handles(page)).toHaveCount(points.length + 1);
  await expect(page.locator(handle(1))).toBeFocused();
  await page.keyboard.press('Delete');
  await expect.poll(() => pointsOf(page)).toEqual(moved);
  const box = (await page.locator(handle(2)).boundingBox())!;
  await draw(page, [
    [box.x + 16, box.y + 16],
    [box.x + 56, box.y + 16],
  ]);
  await expect.poll(async () => (await pointsOf(page))[2]).not.toBe(moved[2]);
  expect((await pointsOf(page)).toSpliced(2, 1)).toEqual(moved.toSpliced(2, 1));
});

test('Escape cancels, Enter draws a straight flow, and a click draws nothing', async ({ page }) => {
  await begin(page);
  await page.mouse.click(300, 300);
  const brush = page.getByRole('group', { name: 'Draw a flow' });
  await expect(brush).toBeVisible();
  await page.mouse.move(250, 380);
  await page.mouse.down();
  await page.mouse.move(300, 240, { steps: 4 });
  expect(await page.evaluate(() => String(getSelection())), 'selected text').toBe('');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect(brush).toBeHidden();
  await expect(page.getByRole('button', { name: 'Draw a flow' })).toBeFocused();
  await expectValue(page, 'flows.0.points', undefined);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(handles(page)).toHaveCount(3);
  await expect(page.locator(handle(0))).toBeFocused();
});

/** A camera in front of the target, 10 m away. */
class Camera {
  static readonly distance = 10;
  readonly values: string;
  private readonly target: PathPoint;
  private readonly up: PathPoint;
  private readonly back: PathPoint;
  private readonly fieldOfView: number;

  /**
   * @param elevation degrees
   * @param fieldOfView of the scene, radians
   */
  constructor(target: PathPoint, elevation: number, fieldOfView: number) {
    this.fieldOfView = fieldOfView;
    const [x, y, z] = (this.target = target);
    const angle = (elevation * Math.PI) / 180;
    this.up = [0, Math.cos(angle), -Math.sin(angle)];
    this.back = [0, Math.sin(angle), Math.cos(angle)];
    this.values =
      `&camera.azimuth=0&camera.elevation=${elevation}&camera.distance=${Camera.distance}` +
      `&camera.target.x=${x}&camera.target.y=${y}&camera.target.z=${z}`;
  }

  get eye(): PathPoint {
    return this.target.map((part, axis) => part + Camera.distance * this.back[axis]) as unknown as PathPoint;
  }

  /** Where the page shows a point of the scene, CSS pixels. */
  async seen(page: Page, point: PathPoint): Promise<Place> {
    const { x, y, width, height } = (await page.locator('#smoke').boundingBox())!;
    const from = point.map((part, axis) => part - this.target[axis]);
    const along = (axes: PathPoint) => from.reduce((sum, part, axis) => sum + part * axes[axis], 0);
    const pixels = height / 2 / Math.tan(this.fieldOfView / 2) / (Camera.distance - along(this.back));
    return [x + width / 2 + pixels * from[0], y + height / 2 - pixels * along(this.up)];
  }
}

/** The points of a stroke over points of the scene. */
async function drawnOver(page: Page, camera: Camera, points: readonly PathPoint[]): Promise<PathPoint[]> {
  await page.getByRole('button', { name: 'Draw a flow' }).click();
  await draw(page, await Promise.all(points.map((point) => camera.seen(page, point))));
  await expect.poll(() => valueOf(page, 'flows.0.points')).not.toBeUndefined();
  const drawn = readPath(String(await valueOf(page, 'flows.0.points')));
  await page.keyboard.press('Control+z');
  await expectValue(page, 'flows.0.points', undefined);
  return drawn;
}

/** @param metres a pixel is a hundredth of a metre */
function expectNear(point: PathPoint | undefined, wanted: PathPoint, metres = 0.03): void {
  const off = Math.hypot(...wanted.map((part, axis) => part - (point?.[axis] ?? NaN)));
  expect(off, `${point?.join(' ')} is not ${wanted.join(' ')}`).toBeLessThan(metres);
}

test('a stroke is as far away as the surface or the puff under its ends', async ({ page }) => {
  const camera = new Camera([0, 1.1, 0], 25, 0.58);
  await page.setViewportSize({ width: 690, height: 480 });
  await open(page, `?paused=1${without('lamp')}${camera.values}`);
  await page.keyboard.press('h');
  await test.step('on the table, nearer and farther than the target', async () => {
    const [near, far] = [[-1.1, 0, 1.1], [-1.2, 0, -1]] as const; // prettier-ignore
    // A little off the straight line, so that it stays a point.
    const middle = [-1.23, 0, 0.05] as const;
    const points = await drawnOver(page, camera, [near, middle, far]);
    expect(points).toHaveLength(3);
    [near, middle, far].forEach((wanted, index) => expectNear(points[index], wanted, 0.05));
    for (const [, y] of points) expect(Math.abs(y)).toBeLessThan(0.025);
  });
  await test.step('on the ball, and in front of nothing as far away as the target', async () => {
    const [centre, radius, { eye }] = [[1.5, 1.75, 0.1], 0.26, camera] as const;
    const away = Math.hypot(...centre.map((part, axis) => eye[axis] - part));
    const front = centre.map((part, axis) => part + (radius / away) * (eye[axis] - part)) as unknown as PathPoint;
    const empty = [-1, 2.1, -Math.tan((25 * Math.PI) / 180)] as const;
    const points = await drawnOver(page, camera, [front, empty]);
    expectNear(points[0], front);
    expectNear(points.at(-1), empty);
  });
  await test.step('in smoke before the table', async () => {
    const table = [-1, 0, 0.9] as const;
    const smoke = table.map((part, axis) => (part + camera.eye[axis]) / 2) as unknown as PathPoint;
    await page.evaluate(([x, y, z]) => {
      const stage = window.cartoonSmoke!;
      stage.emit({ position: { x, y, z }, count: 60, size: 0.6, radius: 0.2, speed: 0 });
      stage.step(6);
    }, smoke);
    await expect.poll(() => ask(page, (stage) => stage.stats.alive)).toBe(60);
    const points = await drawnOver(page, camera, [table, [-0.2, 0, 1.3]]);
    expectNear(points[0], smoke, 0.5);
    expectNear(points.at(-1), [-0.2, 0, 1.3]);
  });
});

for (const [name, file, size, low, places] of [
  [
    'whose parts move',
    turningBox,
    1.75,
    -0.5,
    [
      [0.3, 0.1, 0.5],
      [-0.3, 1, 0.25],
    ],
  ],
  [
    'that bends',
    bendingColumn,
    2,
    0,
    [
      [0.1, 0.5, 0.25 - 0.1 * (Math.SQRT2 - 1)],
      [0, 1.4, 0.25],
    ],
  ],
] as const)
  // prettier-ignore
  test(`a stroke lies on a model ${name}`, async ({ page }) => {
    const camera = new Camera([0, 0.5, 0], 0, 0.3);
    await page.setViewportSize({ width: 690, height: 480 });
    await open(page, `?paused=1${without('air')}${camera.values}`);
    await page.keyboard.press('h');
    await page.evaluate(
      ([base64, height, y]) =>
        window.cartoonSmoke!.setModel(
          Uint8Array.from(atob(base64), (each) => each.charCodeAt(0)),
          { position: { x: 0, y, z: 0 }, size: height },
        ),
      [Buffer.from(file().pack()).toString('base64'), size, low] as const,
    );
    const points = await drawnOver(page, camera, places);
    places.forEach((wanted, index) => expectNear(points.at(index - 2), wanted));
  });
