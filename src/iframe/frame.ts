/** The page in a frame, `embed.html`: smoke by the same hash and query as the demo, without its panel. */
import { CartoonSmokeElement } from '../element/define.ts';
import { answerPage, originOf } from './answerPage.ts';
import { elementStage } from './elementStage.ts';
import { useBytesInside } from './insideBytes.ts';

function begin(smoke: CartoonSmokeElement): void {
  // A worker would need an origin, and most browsers give a frame of another site a thread of its own.
  smoke.thread = 'main';
  smoke.interactive = new URLSearchParams(location.search).get('interactive') !== '0';
  const follow = () => (smoke.src = location.href);
  addEventListener('hashchange', follow);
  follow();
  const stand = () => {
    // Whoever was here before has ended it.
    if (!smoke.isConnected) document.body.prepend(smoke);
    return smoke.stage;
  };
  answerPage(elementStage(smoke), originOf(location.search), stand);
}

useBytesInside();
const found = document.querySelector('cartoon-smoke');
if (found instanceof CartoonSmokeElement) begin(found);
