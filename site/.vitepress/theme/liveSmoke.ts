import { defineComponent, h, onBeforeUnmount, onMounted, ref, useId } from 'vue';
import { useData, withBase } from 'vitepress';
import type { ThemeConfig } from '../config.ts';
import { readElement, readValues, type Attributes, type Values } from './markup.ts';

interface Notice {
  readonly message: string;
}
interface SmokeElement extends HTMLElement {
  set(values: Values): Promise<void>;
  unset(keys: readonly string[]): Promise<void>;
}

const TYPED_MS = 400;

/**
 * An example that plays beside its code, which can be edited: an element, or values as JSON. Before it starts, and
 * without JavaScript, its slots `poster` and `code` show a picture and the code. It starts when its button is pressed or
 * when the page is idle and shows it.
 */
export default defineComponent({
  props: {
    /** The code, URI-encoded. */
    code: { type: String, required: true },
    kind: { type: String as () => 'element' | 'values', required: true },
    /** Preset of an example with values. */
    preset: { type: String, required: true },
  },
  setup(props, { slots }) {
    const { theme } = useData<ThemeConfig>();
    const id = useId();
    const isMounted = ref(false);
    const isStarted = ref(false);
    const original = decodeURIComponent(props.code);
    const text = ref(original);
    const message = ref('');
    const frame = ref<HTMLElement>();
    let smoke: SmokeElement | undefined;
    let given: Values = {};
    let typing = 0;
    let observer: IntersectionObserver | undefined;

    onMounted(() => {
      isMounted.value = true;
      const connection = (navigator as { connection?: { saveData?: boolean } }).connection;
      if (connection?.saveData || matchMedia('(prefers-reduced-motion: reduce)').matches) return;
      observer = new IntersectionObserver(([{ isIntersecting }]) => isIntersecting && whenIdle(() => void start()), {
        threshold: 0.6,
      });
      if (frame.value) observer.observe(frame.value);
    });
    onBeforeUnmount(() => {
      observer?.disconnect();
      clearTimeout(typing);
      smoke?.remove();
    });

    async function start(): Promise<void> {
      if (isStarted.value || !frame.value) return;
      isStarted.value = true;
      observer?.disconnect();
      try {
        await import(/* @vite-ignore */ new URL(withBase(theme.value.elementScript), location.href).href);
      } catch {
        message.value = 'The script of the element could not be loaded.';
        isStarted.value = false;
        return;
      }
      // Evaluating the script is a long task on a phone, so the smoke starts in the next one.
      await new Promise((resolve) => setTimeout(resolve));
      if (!frame.value) return;
      smoke = document.createElement('cartoon-smoke') as SmokeElement;
      smoke.setAttribute('loading', 'eager');
      smoke.addEventListener('statechange', (event) => {
        const notices = (event as CustomEvent<{ notices?: readonly Notice[] }>).detail.notices ?? [];
        if (notices.length > 0) message.value = notices.map((notice) => notice.message).join(' ');
      });
      smoke.addEventListener('error', (event) => {
        message.value = (event as Event as CustomEvent<{ error: Error }>).detail.error.message;
      });
      apply();
      frame.value.append(smoke);
    }

    function apply(): void {
      message.value = '';
      if (!smoke) return;
      try {
        if (props.kind === 'element') setAttributes(smoke, readElement(text.value), (wrong) => (message.value = wrong));
        else {
          smoke.setAttribute('preset', props.preset);
          const values = readValues(text.value);
          void smoke.unset(Object.keys(given).filter((key) => !(key in values)));
          given = values;
          smoke.set(values).catch((error: Error) => (message.value = error.message));
        }
      } catch (error) {
        message.value = (error as Error).message;
      }
    }

    function change(now: string): void {
      text.value = now;
      clearTimeout(typing);
      typing = window.setTimeout(() => (isStarted.value ? apply() : void start()), TYPED_MS);
    }

    const stage = () =>
      h('div', { class: 'live-stage', ref: frame }, [
        h('div', { class: 'live-poster' }, slots.poster?.()),
        isMounted.value && !isStarted.value
          ? h('button', { type: 'button', class: 'live-play', onClick: () => void start() }, 'Play')
          : undefined,
      ]);
    const editor = () => [
      h('label', { for: id }, props.kind === 'element' ? 'Edit the attributes' : 'Edit the values'),
      h('textarea', {
        id,
        value: text.value,
        rows: Math.max(4, original.split('\n').length),
        spellcheck: false,
        autocapitalize: 'off',
        onInput: (event: Event) => change((event.target as HTMLTextAreaElement).value),
      }),
      h('div', { class: 'live-below' }, [
        h('p', { role: 'status' }, message.value),
        h('button', { type: 'button', disabled: text.value === original, onClick: () => change(original) }, 'Reset'),
      ]),
    ];
    return () =>
      h('div', { class: 'live' }, [
        stage(),
        isMounted.value ? h('div', { key: 'editor' }, editor()) : h('div', { key: 'code' }, slots.code?.()),
      ]);
  },
});

/** Sets those that the element has, and removes the others. */
function setAttributes(smoke: HTMLElement, attributes: Attributes, report: (sentence: string) => void): void {
  const known = new Set<string>(
    (smoke.constructor as typeof HTMLElement & { observedAttributes: readonly string[] }).observedAttributes,
  );
  for (const name of smoke.getAttributeNames()) {
    if (known.has(name) && name !== 'loading' && !attributes.has(name)) smoke.removeAttribute(name);
  }
  for (const [name, value] of attributes) {
    if (!known.has(name)) report(`There is no attribute ${name}.`);
    else if (smoke.getAttribute(name) !== value) smoke.setAttribute(name, value);
  }
}

function whenIdle(work: () => void): void {
  // Safari has no requestIdleCallback.
  if ('requestIdleCallback' in window) requestIdleCallback(work, { timeout: 4000 });
  else setTimeout(work, 1500);
}
