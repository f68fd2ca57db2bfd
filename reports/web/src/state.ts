// What the reader chose, kept in the URL hash so that a view can be linked: #case=..&truth=..&norm=..&sort=..&filter=..

export class State {
  private values: URLSearchParams;
  private listeners: (() => void)[] = [];

  constructor() {
    this.values = new URLSearchParams(location.hash.slice(1));
    addEventListener('hashchange', () => {
      const next = new URLSearchParams(location.hash.slice(1));
      const isAnchor = [...next.keys()].length === 1 && [...next.values()][0] === '';
      if (isAnchor || next.toString() === this.values.toString()) return;
      this.values = next;
      this.tell();
    });
  }

  get(key: string): string {
    return this.values.get(key) ?? '';
  }

  set(changes: Record<string, string>): void {
    for (const [key, value] of Object.entries(changes)) {
      if (value) this.values.set(key, value);
      else this.values.delete(key);
    }
    history.replaceState(null, '', `#${this.values.toString()}`);
    this.tell();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
