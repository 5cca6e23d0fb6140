import { defineComponent, h, nextTick, onBeforeUnmount, onMounted, ref, useId, type Ref } from 'vue';
import { withBase } from 'vitepress';
import type { CostReport, MeasureCosts } from '../../../src/demo/costs/report.ts';
import { cellsOf, markdownOf, passesOf } from './costsTable.ts';

/** The page of the measurement in the frame. */
interface MeasuringWindow extends Window {
  readonly measureCosts?: MeasureCosts;
}

const ROUNDS = [1, 5, 15];
const FILE = 'cartoon-smoke-costs.md';

/** Measures the visitor's machine when its button is pressed, in a frame, and shows a table. Nothing is sent. */
export default defineComponent({
  setup(_, { slots }) {
    const id = useId();
    const isMounted = ref(false);
    const isRunning = ref(false);
    const rounds = ref(5);
    const share = ref(0);
    const message = ref('');
    const report = ref<CostReport>();
    const frame = ref<HTMLIFrameElement>();
    const text = ref<HTMLTextAreaElement>();
    let abort: AbortController | undefined;

    onMounted(() => (isMounted.value = true));
    onBeforeUnmount(() => abort?.abort());

    async function start(): Promise<void> {
      abort = new AbortController();
      const { signal } = abort;
      isRunning.value = true;
      report.value = undefined;
      share.value = 0;
      message.value = 'Loading';
      try {
        await nextTick();
        const measure = await loadedIn(frame, signal);
        const onProgress = (done: number, name: string) => {
          if (signal.aborted) return;
          share.value = done;
          message.value = `Measuring: ${name.replaceAll('`', '')}`;
        };
        // The frame goes at once, also while it waits for something.
        report.value = await Promise.race([measure({ rounds: rounds.value, signal, onProgress }), abortion(signal)]);
        message.value = 'Done.';
      } catch (error) {
        // Errors of the frame are of another realm.
        message.value = signal.aborted ? 'Cancelled.' : (error as Error).message;
      } finally {
        isRunning.value = false;
      }
    }

    async function copy(): Promise<void> {
      try {
        await navigator.clipboard.writeText(text.value!.value);
        message.value = 'Copied.';
      } catch {
        text.value!.focus();
        text.value!.select();
        message.value = 'The browser does not allow copying. The table is selected: copy it with the keyboard.';
      }
    }

    function download(): void {
      const address = URL.createObjectURL(new Blob([text.value!.value], { type: 'text/markdown' }));
      const link = document.createElement('a');
      link.href = address;
      link.download = FILE;
      link.click();
      // The browser reads the URL after this task.
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
    }

    const stage = () =>
      h('div', { class: 'live-stage' }, [
        h('div', { class: 'live-poster' }, slots.default?.()),
        isRunning.value
          ? h('iframe', { ref: frame, title: 'The smoke that is measured', src: withBase('/../costs.html') })
          : undefined,
      ]);
    const controls = () =>
      h('div', { class: 'measure-controls' }, [
        isRunning.value
          ? h('button', { key: 'cancel', type: 'button', onClick: () => abort?.abort() }, 'Cancel')
          : h('button', { key: 'start', type: 'button', onClick: () => void start() }, 'Measure this machine'),
        h('label', [
          'Rounds ',
          h(
            'select',
            {
              value: rounds.value,
              disabled: isRunning.value,
              onChange: (event: Event) => (rounds.value = Number((event.target as HTMLSelectElement).value)),
            },
            ROUNDS.map((count) => h('option', { value: count }, count)),
          ),
        ]),
        isRunning.value ? h('progress', { value: share.value, 'aria-label': 'Progress' }) : undefined,
      ]);
    const table = (shown: CostReport) => {
      const { head, rows } = cellsOf(shown);
      return [
        // A keyboard has to scroll it where it is wider than the page.
        h('div', { class: 'measure-table', tabindex: 0, role: 'group', 'aria-label': 'What this machine measured' }, [
          h('table', [
            h(
              'thead',
              h(
                'tr',
                head.map((cell) => h('th', { scope: 'col' }, cell)),
              ),
            ),
            h(
              'tbody',
              rows.map(([name, ...cells]) =>
                h('tr', [h('th', { scope: 'row' }, marked(name)), ...cells.map((cell) => h('td', cell))]),
              ),
            ),
          ]),
        ]),
        h('p', { class: 'measure-passes' }, passesOf(shown)),
        h('label', { for: id }, 'The table as Markdown'),
        h('textarea', { id, ref: text, readonly: true, rows: 6, value: markdownOf(shown, navigator.userAgent) }),
        h('div', { class: 'measure-controls' }, [
          h('button', { type: 'button', onClick: () => void copy() }, 'Copy'),
          h('button', { type: 'button', onClick: download }, 'Download'),
        ]),
      ];
    };
    return () =>
      h('div', { class: 'live' }, [
        stage(),
        isMounted.value ? controls() : undefined,
        h('p', { role: 'status', class: 'measure-status' }, message.value),
        ...(report.value ? table(report.value) : []),
      ]);
  },
});

/** Rejects with the reason of the signal. */
function abortion(signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason as Error), { once: true });
  });
}

/** The function of the page in a frame. @throws Error when the page cannot be loaded; the reason of the signal */
function loadedIn(mounted: Ref<HTMLIFrameElement | undefined>, signal: AbortSignal): Promise<MeasureCosts> {
  const frame = mounted.value!;
  const loading = new Promise<MeasureCosts>((resolve, reject) => {
    frame.addEventListener(
      'load',
      () => {
        // The browser's own page about an error is of another origin.
        const { measureCosts } = frame.contentDocument ? (frame.contentWindow as MeasuringWindow) : {};
        if (measureCosts) resolve(measureCosts);
        else reject(new Error('The page of the measurement could not be loaded.'));
      },
      { once: true },
    );
  });
  return Promise.race([loading, abortion(signal)]);
}

/** Markdown with code, as elements. */
function marked(text: string) {
  return text.split('`').map((part, index) => (index % 2 === 1 ? h('code', part) : part));
}
