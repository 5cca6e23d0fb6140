/** Takes files that are dropped anywhere on the page. */
export function acceptDrops(page: HTMLElement, open: (file: File) => void): void {
  page.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    page.classList.add('is-dropping');
  });
  page.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) page.classList.remove('is-dropping');
  });
  page.addEventListener('drop', (event) => {
    page.classList.remove('is-dropping');
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    open(file);
  });
}
