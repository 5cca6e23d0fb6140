'use client';
import 'cartoon-smoke/react';
import { useEffect, useRef, useState } from 'react';

export function Smoke() {
  const smoke = useRef(null);
  const [rate, setRate] = useState(30);
  const [state, setState] = useState('loading');
  // The element starts before React adds event listeners to the page of the server.
  useEffect(() => {
    smoke.current.ready.then(
      () => setState('ready'),
      (error) => setState(error.message),
    );
  }, []);
  return (
    <>
      <cartoon-smoke ref={smoke} preset="air" style-smoke-color="#fff4e3" emission-rate={rate} />
      <label>
        Rate
        <input type="range" min="0" max="60" value={rate} onChange={({ target }) => setRate(target.valueAsNumber)} />
      </label>
      <p>The smoke is {state}.</p>
    </>
  );
}
