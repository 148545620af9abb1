import { element } from "./page";
import type { Frame, Scene } from "./protocol";

type Layer = [name: string, priority: number, visible: boolean, shown: boolean];
type Call = (component: string, service: string, args: unknown[]) => Promise<unknown>;

/** The layers of which programs make the canvas, each with a switch; asked for when they change. */
export class CanvasLayers {
  private readonly list = element("canvas-layers");
  private readonly hint = element("canvas-layers-hint");
  private rows = new Map<string, { label: HTMLLabelElement; box: HTMLInputElement }>();
  private pen: string | undefined;
  private known = 0; // Frame.canvasLayers
  private fixed = true;

  constructor(
    private readonly call: Call,
    private readonly failed: (text: string) => void,
  ) {}

  setScene(scene: Scene): void {
    this.pen = scene.robots.flatMap(({ devices }) => devices).find(({ type }) => type === "Pen")?.name;
    this.fixed = scene.read_only || scene.record !== null;
    this.known = 0;
    this.show([]);
  }

  showFrame(frame: Frame): void {
    if (frame.canvasLayers === this.known) return;
    this.known = frame.canvasLayers;
    void this.refresh();
  }

  private async refresh(): Promise<void> {
    if (this.pen === undefined) return;
    const asked = this.known;
    try {
      const layers = (await this.call(this.pen, "get_layers", [])) as Layer[];
      if (asked === this.known) this.show(layers);
    } catch {
      // The connection was lost; with the next one comes a scene.
    }
  }

  private show(layers: Layer[]): void {
    const rows: typeof this.rows = new Map();
    for (const [name, , visible, shown] of [...layers].reverse()) { // the topmost first
      const row = this.rows.get(name) ?? this.makeRow(name);
      row.box.checked = shown;
      row.box.disabled = this.fixed;
      row.label.classList.toggle("soft", !visible);
      row.label.title = visible ? "" : "Hidden by the program that draws";
      rows.set(name, row);
    }
    // What has the focus keeps it where the names have stayed.
    const same = [...rows.keys()].join("\n") === [...this.rows.keys()].join("\n");
    this.rows = rows;
    if (!same) this.list.replaceChildren(...[...rows.values()].map(({ label }) => label));
    this.hint.hidden = rows.size === 0 || this.fixed;
  }

  private makeRow(name: string): { label: HTMLLabelElement; box: HTMLInputElement } {
    const label = document.createElement("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.onchange = () => {
      if (this.pen === undefined) return;
      this.call(this.pen, "show_layer", [name, box.checked]).catch((error: Error) => {
        this.failed(error.message);
        void this.refresh();
      });
    };
    const text = document.createElement("span");
    text.textContent = name;
    label.append(box, text);
    return { label, box };
  }
}
