import { element } from "./page";
import type { Frame, Scene } from "./protocol";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, Infinity];
const SEEK_PERIOD_MS = 80; // while the time line is dragged
const SETTLE_MS = 500; // how long the time line is left where the user has put it

const nameOf = (speed: number) => (speed === Infinity ? "max" : `${Number(speed.toPrecision(3))} x`);

/** Pause, step, speed and, for a record, the time line. */
export class TimeBar {
  private readonly play = element<HTMLButtonElement>("play");
  private readonly stepButton = element<HTMLButtonElement>("step");
  private readonly speed = element<HTMLSelectElement>("speed");
  private readonly line = element<HTMLInputElement>("timeline");
  private paused = false;
  private wanted = NaN;
  private record: Scene["record"] = null;
  private allowed = true;
  private touched = -Infinity; // when the user last moved the time line, ms
  private sought: number | null = null; // not yet sent, s
  private seekTimer = 0;

  /** `call`: of a service of `ccmorse`. */
  constructor(private readonly call: (service: string, args: unknown[]) => void) {
    this.play.onclick = () => this.toggle();
    this.stepButton.onclick = () => this.step();
    for (const speed of SPEEDS) this.speed.append(new Option(nameOf(speed), String(speed)));
    this.speed.onchange = () => this.setSpeed(Number(this.speed.value));
    this.line.oninput = () => this.seek(Number(this.line.value));
  }

  setScene(scene: Scene): void {
    this.record = scene.record;
    this.allowed = !scene.read_only;
    element("record").hidden = scene.record === null;
    element("record-name").textContent = scene.record?.file.split("/").at(-1) ?? "";
    element("record-name").title = scene.record?.file ?? "";
    this.line.max = String(scene.record?.seconds ?? 0);
    element("record-end").textContent = `${(scene.record?.seconds ?? 0).toFixed(1)} s`;
    element("reset").hidden = scene.record !== null;
    element("time").hidden = scene.read_only;
    for (const control of [this.play, this.stepButton, this.speed, this.line]) {
      control.disabled = !this.allowed;
    }
  }

  show(frame: Frame): void {
    if (frame.paused !== this.paused || this.play.dataset["state"] === undefined) {
      this.paused = frame.paused;
      this.play.dataset["state"] = this.paused ? "paused" : "running";
      this.play.title = this.paused ? "Go on (K)" : "Pause (K)";
      this.play.setAttribute("aria-label", this.paused ? "Go on" : "Pause");
    }
    if (frame.speed !== this.wanted) {
      this.wanted = frame.speed;
      const known = [...this.speed.options].some((option) => Number(option.value) === this.wanted);
      if (!known) this.speed.append(new Option(nameOf(this.wanted), String(this.wanted)));
      this.speed.value = String(this.wanted);
    }
    if (this.record !== null && performance.now() - this.touched > SETTLE_MS) {
      this.line.value = String(frame.time);
      this.line.setAttribute("aria-valuetext", `${frame.time.toFixed(1)} seconds`);
    }
  }

  toggle(): void {
    this.ask(this.paused ? "resume" : "pause", []);
  }

  step(): void {
    this.ask("step", []);
  }

  /** To the next speed of the list, +1 or -1. */
  changeSpeed(by: number): void {
    const next = by > 0 ? SPEEDS.find((speed) => speed > this.wanted)
      : SPEEDS.filter((speed) => speed < this.wanted).at(-1);
    if (next !== undefined) this.setSpeed(next);
  }

  seekBy(seconds: number): void {
    if (this.record === null) return;
    const to = Number(this.line.value) + seconds;
    this.line.value = String(Math.min(this.record.seconds, Math.max(0, to)));
    this.seek(Number(this.line.value));
  }

  private setSpeed(speed: number): void {
    this.ask("set_speed", [speed === Infinity ? "max" : speed]);
  }

  // A drag asks for places faster than they can be simulated: the newest counts.
  private seek(seconds: number): void {
    this.touched = performance.now();
    this.sought = seconds;
    if (this.seekTimer !== 0) return;
    const send = () => {
      this.seekTimer = 0;
      if (this.sought === null) return;
      this.ask("seek", [this.sought]);
      this.sought = null;
      this.seekTimer = window.setTimeout(send, SEEK_PERIOD_MS);
    };
    send();
  }

  private ask(service: string, args: unknown[]): void {
    if (this.allowed) this.call(service, args);
  }
}
