import { element } from "./page";
import { BOX_UP, BOX_WAITING, type Frame, type Scene } from "./protocol";
import { save } from "./save";
import type { Stage } from "./stage";

type Call = (service: string, args: unknown[]) => Promise<unknown>;
type Presets = Record<string, number[]>;

const CLICK = 5; // px that a click may move

interface Gesture {
  kind: "box" | "band";
  box: number; // its place in the scene, of "box"
  fromX: number; // px
  fromY: number;
  offsetX: number; // m, from the pointer on the floor to the box's middle
  offsetY: number;
  moved: boolean;
  shift: boolean;
}

/**
 * Raises, lowers and moves the dynamic boxes: in its mode by click, rubber band and drag, from a list,
 * and by presets. There is nothing of it where nothing may be changed.
 */
export class Obstacles {
  private readonly section = element("obstacles");
  private readonly modeButton = element<HTMLButtonElement>("obstacles-mode");
  private readonly list = element("obstacle-boxes");
  private readonly presetList = element<HTMLSelectElement>("preset");
  private readonly nameField = element<HTMLInputElement>("preset-name");
  private readonly band = element("band");
  private scene: Scene | null = null;
  private frame: Frame | null = null;
  private boxes: number[] = []; // the dynamic ones, places in the scene
  private checks: HTMLInputElement[] = []; // of the same
  private presets: Presets = {};
  private gesture: Gesture | null = null;
  private on = false;

  constructor(
    private readonly stage: Stage,
    private readonly call: Call,
    private readonly notice: (text: string) => void,
    /** Shift + click on the floor. */
    private readonly clickedFloor: (x: number, y: number) => void,
  ) {
    this.modeButton.onclick = () => this.toggle();
    element<HTMLFormElement>("preset-load").onsubmit = (event) => {
      event.preventDefault();
      if (this.presetList.value !== "") this.change("load_preset", [this.presetList.value]);
    };
    element<HTMLFormElement>("preset-save").onsubmit = (event) => {
      event.preventDefault();
      void this.savePreset(this.nameField.value.trim());
    };
    element("preset-download").onclick = () => {
      save(new Blob([JSON.stringify({ presets: this.presets }, null, 2) + "\n"],
        { type: "application/json" }), `${this.scene?.scene ?? "ccmorse"}-obstacles.json`);
    };
  }

  setScene(scene: Scene): void {
    this.scene = scene;
    this.frame = null;
    this.cancel();
    const mayChange = !scene.read_only && scene.record === null;
    this.boxes = mayChange ? scene.boxes.flatMap((box, i) => (box.dynamic ? [i] : [])) : [];
    this.section.hidden = this.boxes.length === 0;
    this.setMode(this.on && this.boxes.length > 0);
    this.checks = this.boxes.map((i) => this.makeCheck(scene.boxes[i]?.id ?? 0));
    this.list.replaceChildren(...this.checks.map((check) => check.parentElement ?? ""));
    if (this.boxes.length > 0) void this.loadPresets();
  }

  showFrame(frame: Frame): void {
    this.frame = frame;
    this.boxes.forEach((box, i) => {
      const check = this.checks[i];
      if (check === undefined) return;
      const flags = frame.boxes[box] ?? 0;
      check.checked = (flags & (BOX_UP | BOX_WAITING)) !== 0;
      check.indeterminate = (flags & BOX_WAITING) !== 0;
    });
  }

  /** Switches the mode; it says why where there is nothing to change. */
  toggle(): void {
    if (this.scene === null) return;
    if (this.boxes.length === 0) {
      this.notice(
        this.scene.record !== null ? "This is a record: it can only be watched."
          : this.scene.read_only ? "This view is read-only."
            : "This world has no obstacles that move.");
      return;
    }
    this.setMode(!this.on);
    if (this.on) void this.loadPresets();
  }

  /** Ends what goes on, or else the mode; false when there is neither. */
  escape(): boolean {
    if (this.gesture !== null) this.cancel();
    else if (this.on) this.setMode(false);
    else return false;
    return true;
  }

  // --- The pointer. Each gives true when it was for the obstacles.

  down(event: PointerEvent): boolean {
    if (this.boxes.length === 0 || (!this.on && !event.shiftKey)) return false;
    const box = this.on ? this.stage.boxAt(event.clientX, event.clientY) : -1;
    const middle = this.stage.boxPlace(box);
    const floor = this.stage.floorAt(event.clientX, event.clientY);
    this.gesture = {
      kind: middle === null || event.shiftKey ? "band" : "box",
      box,
      fromX: event.clientX,
      fromY: event.clientY,
      offsetX: (middle?.x ?? 0) - (floor?.x ?? 0),
      offsetY: (middle?.y ?? 0) - (floor?.y ?? 0),
      moved: false,
      shift: event.shiftKey,
    };
    this.stage.setControls(false);
    return true;
  }

  move(event: PointerEvent): boolean {
    const gesture = this.gesture;
    if (gesture === null) return false;
    gesture.moved ||= Math.hypot(event.clientX - gesture.fromX, event.clientY - gesture.fromY) > CLICK;
    if (!gesture.moved) return true;
    if (gesture.kind === "band") {
      this.showBand(gesture, event);
      return true;
    }
    const floor = this.stage.floorAt(event.clientX, event.clientY);
    if (floor !== null) {
      this.stage.holdBox(gesture.box, floor.x + gesture.offsetX, floor.y + gesture.offsetY);
    }
    return true;
  }

  up(event: PointerEvent): boolean {
    const gesture = this.gesture;
    if (gesture === null) return false;
    this.move(event);
    this.gesture = null;
    this.band.hidden = true;
    this.stage.setControls(true);
    if (gesture.kind === "band") {
      if (gesture.moved) this.changeBand(gesture, event);
      else if (gesture.shift) this.clickedFloor(event.clientX, event.clientY);
    } else if (gesture.moved) {
      void this.moveBox(gesture.box);
    } else {
      this.change("toggle", [this.idOf(gesture.box)]);
    }
    return true;
  }

  /** Forgets what the pointer has begun. */
  cancel(): void {
    if (this.gesture === null) return;
    this.gesture = null;
    this.band.hidden = true;
    this.stage.letGoOfBox(true);
    this.stage.setControls(true);
  }

  private setMode(on: boolean): void {
    this.on = on;
    this.modeButton.setAttribute("aria-pressed", String(on));
    this.modeButton.textContent = on ? "Done" : "Change";
    document.documentElement.classList.toggle("changing", on);
    element("obstacles-hint").hidden = !on;
    this.stage.setEditing(on);
  }

  private idOf(box: number): number {
    return this.scene?.boxes[box]?.id ?? 0;
  }

  private change(service: string, args: unknown[]): void {
    this.call(service, args).then(
      (waiting) => {
        const ids = Array.isArray(waiting) ? waiting : [];
        if (service !== "lower" && ids.length > 0) {
          this.notice(`A robot stands where ${ids.join(", ")} would come up: it rises when the robot is gone.`);
        }
      },
      (error: Error) => {
        this.notice(error.message);
        if (this.frame !== null) this.showFrame(this.frame); // its check box is as it was
      });
  }

  private async moveBox(box: number): Promise<void> {
    const place = this.stage.boxPlace(box);
    if (place === null) return;
    try {
      await this.call("move", [this.idOf(box), place.x, place.y]);
      this.stage.letGoOfBox(false);
    } catch (error) {
      this.notice((error as Error).message);
      this.stage.letGoOfBox(true);
    }
  }

  // --- The rubber band

  private static edges(gesture: Gesture, event: PointerEvent): [number, number, number, number] {
    return [
      Math.min(gesture.fromX, event.clientX), Math.min(gesture.fromY, event.clientY),
      Math.max(gesture.fromX, event.clientX), Math.max(gesture.fromY, event.clientY),
    ];
  }

  private showBand(gesture: Gesture, event: PointerEvent): void {
    const [left, top, right, bottom] = Obstacles.edges(gesture, event);
    this.band.hidden = false;
    Object.assign(this.band.style, {
      left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px`,
    });
  }

  // All whose middles are in it come up, or go down where all of them are up.
  private changeBand(gesture: Gesture, event: PointerEvent): void {
    const [left, top, right, bottom] = Obstacles.edges(gesture, event);
    const inside = this.boxes.filter((box) => {
      const place = this.stage.boxPlace(box);
      if (place === null) return false;
      const { x, y } = this.stage.placeOf(place);
      return x >= left && x <= right && y >= top && y <= bottom;
    });
    if (inside.length === 0) return;
    const up = inside.every((box) => ((this.frame?.boxes[box] ?? 0) & (BOX_UP | BOX_WAITING)) !== 0);
    this.change(up ? "lower" : "raise", [inside.map((box) => this.idOf(box))]);
  }

  private makeCheck(id: number): HTMLInputElement {
    const label = document.createElement("label");
    const check = document.createElement("input");
    check.type = "checkbox";
    check.name = `obstacle-${id}`;
    check.onchange = () => this.change(check.checked ? "raise" : "lower", [id]);
    label.append(check, String(id));
    return check;
  }

  // --- Presets

  private async loadPresets(): Promise<void> {
    try {
      this.presets = (await this.call("get_presets", [])) as Presets;
    } catch {
      return; // the page says elsewhere that the connection was lost
    }
    const chosen = this.presetList.value;
    const names = Object.keys(this.presets);
    this.presetList.replaceChildren(...names.map((name) => new Option(name, name)));
    if (names.includes(chosen)) this.presetList.value = chosen;
    element("preset-load").hidden = names.length === 0;
    element<HTMLButtonElement>("preset-download").disabled = names.length === 0;
  }

  private async savePreset(name: string): Promise<void> {
    if (name === "") return this.notice("Give the preset a name.");
    try {
      const up = (await this.call("save_preset", [name])) as number[];
      await this.loadPresets();
      this.presetList.value = name;
      this.nameField.value = "";
      this.notice(`Preset ${name} has ${up.length} obstacles up.`);
    } catch (error) {
      this.notice((error as Error).message);
    }
  }
}
