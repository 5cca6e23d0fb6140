import { it } from 'vitest';
import { expectRoundTrips } from './roundTrip.ts';

it('10,000 random states survive a round trip through links', () => expectRoundTrips(10_000));
