/* Explains why a page cannot run: opened from the disk, or in an older browser. ECMAScript 5, because older browsers run it. */
(function () {
  var isFile = location.protocol === 'file:' && document.querySelector('script[type=module]');
  var isRecent =
    window.WebAssembly && window.WebGL2RenderingContext && window.DecompressionStream && document.adoptedStyleSheets;
  if (!isFile && isRecent && Array.prototype.toSorted) return;
  var text = isFile
    ? 'Browsers do not run this page from a file. Serve the folder with a web server, for example with “npx serve” in it, and open the address that it prints.'
    : 'Cartoon Smoke needs a newer browser: Chrome or Edge 111, Firefox 115, Safari 16.4, or later.';
  var box = document.createElement('p');
  box.setAttribute('role', 'alert');
  box.style.cssText =
    'max-width: 34em; margin: 15vh auto; padding: 1.2em 1.5em; font: 18px/1.5 sans-serif; color: #1d1720; background: #fbf3df; border: 2.5px solid #1d1720; border-radius: 10px';
  box.appendChild(document.createTextNode(text));
  document.body.innerHTML = '';
  document.body.appendChild(box);
})();
