import { element, whileOpen } from "./page";
import type { Scene } from "./protocol";

type Ask = (component: string, service: string) => Promise<unknown>;

const PERIOD_MS = 250;
const MOST_SHOWN = 4; // values of a long list

function numberText(value: number): string {
  return Number.isInteger(value) ? String(value) : value.toFixed(3);
}

function valueText(value: unknown): string {
  if (typeof value === "number") return numberText(value);
  if (typeof value === "string") return value;
  if (!Array.isArray(value)) return JSON.stringify(value);
  if (value.length <= MOST_SHOWN) return `[${value.map(valueText).join(", ")}]`;
  const numbers = value.filter((each) => typeof each === "number");
  const head = value.slice(0, 2).map(valueText).join(", ");
  if (numbers.length < value.length) return `${value.length}: ${head} ...`;
  let low = Infinity;
  let high = -Infinity;
  for (const each of numbers) {
    low = Math.min(low, each);
    high = Math.max(high, each);
  }
  return `${value.length}: ${numberText(low)} to ${numberText(high)}`;
}

/** The robots' devices; those that are open in the page show their values. */
export class Devices {
  private readonly details = element<HTMLDetailsElement>("devices");
  private readonly tree = element("device-tree");
  private readonly open = new Map<string, HTMLElement>(); // device -> where its values go
  private readonly silent = new Map<string, string>(); // devices without data -> their type
  private robots: HTMLDetailsElement[] = [];

  constructor(private readonly ask: Ask) {
    whileOpen(this.details, PERIOD_MS, () => this.refresh());
  }

  setScene(scene: Scene): void {
    this.open.clear();
    this.silent.clear();
    this.tree.replaceChildren();
    this.robots = scene.robots.map((robot) => {
      const branch = document.createElement("details");
      const name = document.createElement("summary");
      name.textContent = robot.name;
      branch.append(name);
      for (const device of robot.devices) branch.append(this.leaf(robot.name, device));
      return branch;
    });
    const byName = new Intl.Collator(undefined, { numeric: true }).compare;
    this.tree.append(...[...this.robots].sort((a, b) =>
      byName(a.firstChild?.textContent ?? "", b.firstChild?.textContent ?? "")));
    this.choose(0);
  }

  /** The chosen robot's devices are to be seen. */
  choose(robot: number): void {
    const branch = this.robots[robot];
    if (branch !== undefined) branch.open = true;
  }

  private leaf(robot: string, device: { name: string; type: string }): HTMLDetailsElement {
    const leaf = document.createElement("details");
    const name = document.createElement("summary");
    name.textContent = device.name.slice(robot.length + 1);
    const type = document.createElement("span");
    type.textContent = device.type;
    name.append(type);
    const values = document.createElement("dl");
    leaf.append(name, values);
    leaf.addEventListener("toggle", () => {
      if (!leaf.open) return void this.open.delete(device.name);
      this.open.set(device.name, values);
      void this.read(device.name, values);
    });
    return leaf;
  }

  private refresh(): void {
    for (const [device, values] of this.open) {
      if (!this.silent.has(device)) void this.read(device, values);
    }
  }

  private async read(device: string, values: HTMLElement): Promise<void> {
    let data: unknown;
    try {
      data = await this.ask(device, "get_local_data");
    } catch (error) {
      if (String(error).includes("connect")) return; // for the next time
      // An actuator has no data, but it is set up somehow.
      this.silent.set(device, device);
      data = await this.ask(device, "get_configurations").catch(() => ({}));
      const inner = (data as { configurations?: unknown }).configurations;
      if (inner !== undefined) data = inner;
    }
    const rows = Object.entries(data as Record<string, unknown>).flatMap(([key, value]) => {
      const term = document.createElement("dt");
      term.textContent = key;
      const text = document.createElement("dd");
      text.textContent = valueText(value);
      text.title = text.textContent;
      return [term, text];
    });
    values.replaceChildren(...rows);
    if (rows.length === 0) values.textContent = "It has no values.";
  }
}
