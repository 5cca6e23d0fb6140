import { presets } from 'cartoon-smoke/preset';
import { Smoke } from './Smoke.jsx';

/** Rendered on the server, where `cartoon-smoke` can be imported as well. */
export default function Page() {
  const { label, text } = presets.find(({ name }) => name === 'air');
  return (
    <main>
      <h1>{label}</h1>
      <p>{text}</p>
      <Smoke />
    </main>
  );
}
