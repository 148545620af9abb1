import { element, whileOpen } from "./page";

interface Line { number: number; level: string; text: string }
interface ArenaEvent { number: number; time: number; cause: string; what: string }

const PERIOD_MS = 700;
const MOST_LINES = 200;

/** The simulator's log and what timers and traps do to obstacles, asked for while it is open. */
export class LogView {
  private readonly list = element("log-lines");
  private last = 0;
  private lastEvent = 0;
  private events = 0; // that there are, 0 where they cannot be asked for

  constructor(
    private readonly ask: (args: unknown[]) => Promise<unknown>,
    private readonly askEvents: (args: unknown[]) => Promise<unknown>,
  ) {
    whileOpen(element<HTMLDetailsElement>("log"), PERIOD_MS, () => void this.refresh());
  }

  /** Another simulator numbers its lines anew. */
  clear(): void {
    this.last = 0;
    this.lastEvent = 0;
    this.list.replaceChildren();
  }

  /** So many events there have been. */
  setEvents(events: number): void {
    this.events = events;
  }

  private async refresh(): Promise<void> {
    const from = this.last;
    const fromEvent = this.lastEvent;
    let lines: Line[];
    let events: ArenaEvent[] = [];
    try {
      lines = (await this.ask([from])) as Line[];
      if (this.events > fromEvent) events = (await this.askEvents([fromEvent])) as ArenaEvent[];
    } catch {
      return; // the page says elsewhere that the connection was lost
    }
    if (from !== this.last || fromEvent !== this.lastEvent) return; // two answers at once
    const list = this.list;
    const atEnd = list.scrollTop + list.clientHeight >= list.scrollHeight - 4;
    for (const line of lines) {
      this.add(line.level, line.text);
      this.last = line.number;
    }
    for (const { number, time, cause, what } of events) {
      this.lastEvent = number;
      // What somebody asked for he knows; what is said is in the log itself.
      if (cause === "service" || what.startsWith("say ")) continue;
      this.add("event", `${time.toFixed(1)} s: ${cause}: ${what}`);
    }
    while (list.childElementCount > MOST_LINES) list.firstElementChild?.remove();
    element("log-empty").hidden = list.childElementCount > 0;
    if (atEnd) list.scrollTop = list.scrollHeight;
  }

  private add(kind: string, text: string): void {
    const item = document.createElement("li");
    item.className = kind;
    item.textContent = text;
    this.list.append(item);
  }
}
