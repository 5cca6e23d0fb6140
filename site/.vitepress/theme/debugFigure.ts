import { computed, defineComponent, h, onMounted, ref, useId } from 'vue';
import { withBase } from 'vitepress';

/** What the renderer can show, with its name on the page. */
const VIEWS = {
  '': 'Picture',
  depth: 'Depth',
  normals: 'Normals',
  ink: 'Ink',
  lit: 'In light',
  unlit: 'In shadow',
  counts: 'Volumes at a pixel',
  overdraw: 'Overdraw',
} as const;
type View = keyof typeof VIEWS;

/** The page of the demo in the frame. */
interface DemoWindow extends Window {
  readonly cartoonSmoke?: { view: string | undefined };
}

/** A debug view of the demo, in a frame that starts when its button is pressed. Its slot is a picture until then. */
export default defineComponent({
  props: {
    view: { type: String as () => View, required: true },
    preset: { type: String, required: true },
  },
  setup(props, { slots }) {
    const id = useId();
    const isMounted = ref(false);
    const isStarted = ref(false);
    const chosen = ref<View>(props.view);
    const frame = ref<HTMLIFrameElement>();
    const query = computed(() => `ui=0&paused=1&t=4${props.view ? `&view=${props.view}` : ''}`);
    onMounted(() => (isMounted.value = true));

    function choose(view: View): void {
      chosen.value = view;
      const { cartoonSmoke } = (frame.value?.contentWindow ?? {}) as Partial<DemoWindow>;
      if (cartoonSmoke) cartoonSmoke.view = view || undefined;
    }

    const choices = () =>
      h('fieldset', { class: 'views' }, [
        h('legend', 'Show'),
        ...Object.entries(VIEWS).map(([view, label]) =>
          h('label', [
            h('input', {
              type: 'radio',
              name: id,
              checked: view === chosen.value,
              onChange: () => choose(view as View),
            }),
            label,
          ]),
        ),
      ]);
    return () =>
      h('div', { class: 'live' }, [
        h('div', { class: 'live-stage' }, [
          h('div', { class: 'live-poster' }, slots.default?.()),
          isStarted.value
            ? h('iframe', {
                ref: frame,
                title: `${VIEWS[props.view]}, drawn by the demo`,
                src: `${withBase('/../index.html')}?${query.value}#v=1&preset=${props.preset}`,
                onLoad: () => choose(chosen.value),
              })
            : undefined,
          isMounted.value && !isStarted.value
            ? h(
                'button',
                { type: 'button', class: 'live-play', onClick: () => (isStarted.value = true) },
                `Show ${VIEWS[props.view].toLowerCase()}`,
              )
            : undefined,
        ]),
        isStarted.value ? choices() : undefined,
      ]);
  },
});
