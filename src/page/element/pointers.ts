import { keyOf, ORBIT_PER_KEY, ORBIT_PER_PIXEL, spread } from '../gestures.ts';
import { zoomOf } from '../zoom.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { ignoreRejection } from './deferred.ts';
import type { Shell } from './shell/shell.ts';

const ZOOM_PER_PIXEL = 0.01;
const ZOOM_PER_KEY = 1.15;

/**
 * A pointer that is down. Whether it holds a rigid is known only later, because the stage may run in another thread.
 */
interface Press {
  x: number;
  y: number;
  readonly isHolding: Promise<boolean>;
  /** Whether it is known to hold nothing. */
  isLoose: boolean;
}

/** Keys that move the view. */
const KEYS: Readonly<Record<string, (stage: RemoteStage) => Promise<void>>> = {
  ArrowLeft: (stage) => stage.orbit(-ORBIT_PER_KEY, 0),
  ArrowRight: (stage) => stage.orbit(ORBIT_PER_KEY, 0),
  ArrowUp: (stage) => stage.orbit(0, ORBIT_PER_KEY),
  ArrowDown: (stage) => stage.orbit(0, -ORBIT_PER_KEY),
  '+': (stage) => stage.zoom(ZOOM_PER_KEY),
  '=': (stage) => stage.zoom(ZOOM_PER_KEY),
  '-': (stage) => stage.zoom(1 / ZOOM_PER_KEY),
  '0': (stage) => stage.resetView(),
};

/**
 * Lets users drag rigids and orbit the view while the element is interactive; otherwise pointers and keys belong to the
 * page. The wheel scrolls the page; with Ctrl, as in a trackpad pinch, it zooms. Vertical swipes scroll the page
 * (`touch-action` of the canvas), and two fingers zoom.
 */
export class PointerControls {
  private readonly stage: RemoteStage;
  private readonly shell: Shell;
  private readonly presses = new Map<number, Press>();
  private listening: AbortController | undefined;

  constructor(stage: RemoteStage, shell: Shell) {
    this.stage = stage;
    this.shell = shell;
  }

  toggle(isInteractive: boolean): void {
    const { canvas, container } = this.shell;
    container.classList.toggle('interactive', isInteractive);
    if (!canvas || isInteractive === (this.listening !== undefined)) return;
    this.listening?.abort();
    this.listening = undefined;
    for (const id of this.presses.keys()) this.end(id, { type: 'cancel', x: 0, y: 0 });
    if (isInteractive) this.listen(canvas);
    else canvas.removeAttribute('tabindex');
  }

  private listen(canvas: HTMLCanvasElement): void {
    const { signal } = (this.listening = new AbortController());
    canvas.tabIndex = 0;
    canvas.addEventListener('pointerdown', (event) => this.press(event, canvas), { signal });
    canvas.addEventListener('pointermove', (event) => this.move(event), { signal });
    canvas.addEventListener('pointerup', (event) => this.release(event, 'up'), { signal });
    canvas.addEventListener('pointercancel', (event) => this.release(event, 'cancel'), { signal });
    canvas.addEventListener('wheel', (event) => this.wheel(event), { signal, passive: false });
    canvas.addEventListener('keydown', (event) => this.key(event), { signal });
  }

  private press(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    const asked = this.stage.pointer({ type: 'down', id: event.pointerId, ...placeOf(event) });
    const isHolding = asked.then(
      (held) => held === 'rigid',
      () => false,
    );
    const press = { x: event.clientX, y: event.clientY, isHolding, isLoose: false };
    this.presses.set(event.pointerId, press);
    // The pointer may be up by the time of the answer.
    const isOn = () => this.presses.get(event.pointerId) === press;
    ignoreRejection(
      isHolding.then((isHeld) => {
        press.isLoose = !isHeld;
        canvas.classList.toggle('holding', isHeld && isOn());
      }),
    );
  }

  private move(event: PointerEvent): void {
    const press = this.presses.get(event.pointerId);
    // A stage draws more often while a pointer moves over it.
    if (!press) return ignoreRejection(this.stage.pointer({ type: 'move', id: event.pointerId, ...placeOf(event) }));
    // The button was released where no event could fire, for example while the canvas was moved within the page.
    if (event.buttons === 0) return this.release(event, 'cancel');
    const before = this.spread();
    const [dx, dy] = [event.clientX - press.x, event.clientY - press.y];
    Object.assign(press, { x: event.clientX, y: event.clientY });
    const after = this.spread();
    const nearer = before > 0 && after > 0 ? after / before : 1;
    const share = 1 / this.presses.size;
    const input = { type: 'move', id: event.pointerId, ...placeOf(event) } as const;
    ignoreRejection(
      press.isHolding.then<unknown>((isHeld) =>
        isHeld ? this.stage.pointer(input) : this.look(dx * share, dy * share, nearer),
      ),
    );
  }

  /** @param nearer ratio of the distances between two fingers, after to before */
  private look(dx: number, dy: number, nearer: number): Promise<unknown> {
    const orbited = this.stage.orbit(-dx * ORBIT_PER_PIXEL, dy * ORBIT_PER_PIXEL);
    return nearer === 1 ? orbited : Promise.all([orbited, this.stage.zoom(nearer)]);
  }

  /** Distance between two pointers that hold nothing, in pixels; 0 for fewer than two. */
  private spread(): number {
    return spread([...this.presses.values()].filter(({ isLoose }) => isLoose));
  }

  private release(event: PointerEvent, type: 'up' | 'cancel'): void {
    this.end(event.pointerId, { type, ...placeOf(event) });
  }

  private end(id: number, how: { type: 'up' | 'cancel'; x: number; y: number }): void {
    const press = this.presses.get(id);
    this.presses.delete(id);
    if (press) ignoreRejection(press.isHolding.then<unknown>((isHeld) => isHeld && this.stage.pointer({ id, ...how })));
    this.shell.canvas?.classList.remove('holding');
  }

  private wheel(event: WheelEvent): void {
    if (!event.ctrlKey) return;
    event.preventDefault();
    ignoreRejection(this.stage.zoom(Math.exp(-event.deltaY * ZOOM_PER_PIXEL)));
  }

  private key(event: KeyboardEvent): void {
    const act = KEYS[keyOf(event)];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    ignoreRejection(act(this.stage));
  }
}

/** Offset from the top left of the canvas in CSS pixels, before any transforms of the page. */
function placeOf({ offsetX, offsetY, target }: PointerEvent): { x: number; y: number } {
  const zoom = zoomOf(target as Element);
  return { x: offsetX / zoom, y: offsetY / zoom };
}
