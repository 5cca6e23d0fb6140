/** A locomotive that puffs as you scroll: faster scrolling makes more smoke, and the way along the page its colour. */
import 'cartoon-smoke/element';
import { driveByScroll } from 'cartoon-smoke';

const smoke = document.querySelector('cartoon-smoke')!;

driveByScroll(smoke, {
  by: 'speed',
  fullSpeed: 1500,
  drives: { 'emission.rate': [6, 110], 'emitters.0.speed': [0.7, 2.6], 'emitters.0.size': [0.2, 0.36] },
  smoothing: 0.25,
});
driveByScroll(smoke, { drives: { 'style.smokeColor': ['#fff4e3', '#f2a67c'] } });
