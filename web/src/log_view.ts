import { element, whileOpen } from "./page";

interface Line { number: number; level: string; text: string }

const PERIOD_MS = 700;
const MOST_LINES = 200;

/** The simulator's log, asked for while it is open. */
export class LogView {
  private readonly list = element("log-lines");
  private last = 0;

  constructor(private readonly ask: (args: unknown[]) => Promise<unknown>) {
    whileOpen(element<HTMLDetailsElement>("log"), PERIOD_MS, () => void this.refresh());
  }

  /** Another simulator numbers its lines anew. */
  clear(): void {
    this.last = 0;
    this.list.replaceChildren();
  }

  private async refresh(): Promise<void> {
    let lines: Line[];
    const from = this.last;
    try {
      lines = (await this.ask([from])) as Line[];
    } catch {
      return; // the page says elsewhere that the connection was lost
    }
    if (from !== this.last) return; // two answers at once
    const list = this.list;
    const atEnd = list.scrollTop + list.clientHeight >= list.scrollHeight - 4;
    for (const line of lines) {
      const item = document.createElement("li");
      item.className = line.level;
      item.textContent = line.text;
      list.append(item);
      this.last = line.number;
    }
    while (list.childElementCount > MOST_LINES) list.firstElementChild?.remove();
    element("log-empty").hidden = list.childElementCount > 0;
    if (atEnd) list.scrollTop = list.scrollHeight;
  }
}
