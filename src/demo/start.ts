/**
 * The page's small entry module. It shows the poster and lays out the stage as with all controls, so that nothing moves
 * when they are added.
 */
import { showPoster } from './poster.ts';
import { LOW, ROOMY } from './mediaQueries.ts';

const find = (selector: string) => document.querySelector<HTMLElement>(selector)!;

// The panel and the gallery that page.ts adds open.
document.body.classList.toggle('has-panel', matchMedia(ROOMY).matches);
find('.skeleton .gallery').hidden = matchMedia(LOW).matches;
// Hidden until now, because the stage would visibly move.
find('#stage').hidden = false;
// The files, the programs and the surfaces of the stage keep network and GPU busy: the poster would appear late.
await showPoster(find('#stage'));
void import('./main.ts');
