/** The element, controlled by a slider. */
import 'cartoon-smoke/element';

const smoke = document.querySelector('cartoon-smoke')!;
const slider = document.querySelector('input')!;
const follow = () => smoke.setAttribute('emission-rate', slider.value);
slider.addEventListener('input', follow);
follow();
