/** A choice of the user, kept in the browser. Where storage is denied, it lasts as long as the page. */
export class Flag {
  private readonly key: string;
  private isOn: boolean;

  /** @param name of the entry in localStorage, which exists while the flag is on */
  constructor(name: string) {
    this.key = `cartoon-smoke.${name}`;
    try {
      this.isOn = localStorage.getItem(this.key) !== null;
    } catch {
      this.isOn = false;
    }
  }

  get value(): boolean {
    return this.isOn;
  }

  set value(isOn: boolean) {
    this.isOn = isOn;
    try {
      if (isOn) localStorage.setItem(this.key, '1');
      else localStorage.removeItem(this.key);
    } catch {
      // Denied or full: it lasts as long as the page.
    }
  }
}
