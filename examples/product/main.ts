/** Steam beside a product, and a puff on the button. */
import 'cartoon-smoke/element';
import { puff } from 'cartoon-smoke/puff';

const button = document.querySelector('button')!;
button.addEventListener('click', () => void puff(button));
