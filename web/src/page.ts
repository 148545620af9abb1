// Small things that all parts of the page need.

/** The element of that id, which index.html has. */
export function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found as T;
}

/** A colour or size of view.css, as it is in light or dark. */
export function styled(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Calls a function that often while a <details> is open, and once right when it is opened. */
export function whileOpen(details: HTMLDetailsElement, periodMs: number, tick: () => void): void {
  let timer = 0;
  details.addEventListener("toggle", () => {
    clearInterval(timer);
    timer = 0;
    if (!details.open) return;
    tick();
    timer = window.setInterval(tick, periodMs);
  });
}
