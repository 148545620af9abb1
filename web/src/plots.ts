import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { element, styled, whileOpen } from "./page";
import type { Frame, Scene } from "./protocol";

type Ask = (component: string, service: string) => Promise<unknown>;

const WINDOW = 30; // s, simulated
const POSE_PERIOD_MS = 200;
const STEPS = 65535; // of a range, protocol.ts
const HEIGHT = 108; // px

/** One value over time. */
class Plot {
  private readonly times: number[] = [];
  private readonly values: number[] = [];
  private readonly chart: uPlot;

  constructor(into: HTMLElement, private readonly name: string, unit: string, width: number) {
    const soft = styled("--soft");
    const grid = { stroke: styled("--line"), width: 1 };
    const font = "11px system-ui, sans-serif";
    const title = document.createElement("h3");
    title.textContent = `${name}, ${unit}`;
    this.value = document.createElement("output");
    title.append(this.value);
    into.append(title);
    this.chart = new uPlot(
      {
        width,
        height: HEIGHT,
        legend: { show: false },
        cursor: { show: false },
        padding: [8, 6, 0, 0],
        scales: {
          x: { time: false },
          // From 0, and never so narrow that noise fills the picture.
          y: { range: (_, low, high) => [Math.min(0, low ?? 0), Math.max(0.1, 1.08 * (high ?? 0))] },
        },
        axes: [
          { stroke: soft, grid, ticks: grid, font, size: 30, gap: 2, space: 60 },
          { stroke: soft, grid, ticks: grid, font, size: 44, gap: 2, space: 24 },
        ],
        series: [{}, { stroke: styled("--accent"), width: 1.6, points: { show: false } }],
      },
      [[], []], into);
  }
  private readonly value: HTMLOutputElement;

  add(time: number, value: number): void {
    const last = this.times.at(-1);
    if (last !== undefined && time < last) this.clear(); // a jump back in a record
    if (last === time) return;
    this.times.push(time);
    this.values.push(value);
    const from = this.times.findIndex((each) => each >= time - WINDOW);
    if (from > 200) {
      this.times.splice(0, from);
      this.values.splice(0, from);
    }
  }

  draw(): void {
    this.chart.setData([this.times, this.values], false);
    const now = this.times.at(-1) ?? 0;
    this.chart.setScale("x", { min: Math.max(0, now - WINDOW), max: Math.max(now, 1) });
    this.value.textContent = this.values.at(-1)?.toFixed(3) ?? "";
  }

  clear(): void {
    this.times.length = 0;
    this.values.length = 0;
  }

  /** What has been shown, for tests. */
  points(): { name: string; times: number[]; values: number[] } {
    return { name: this.name, times: this.times, values: this.values };
  }

  destroy(): void {
    this.chart.destroy();
  }
}

interface Pose { timestamp: number; x: number; y: number; yaw: number }

/** The chosen robot's speed, the error of its odometry and its nearest obstacle, over time. */
export class Plots {
  private readonly details = element<HTMLDetailsElement>("plots");
  private speed: Plot | null = null;
  private error: Plot | null = null;
  private near: Plot | null = null;
  private scene: Scene | null = null;
  private chosen = 0;
  private nearest = NaN;

  constructor(private readonly ask: Ask) {
    this.details.addEventListener("toggle", () => this.build());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.build());
    whileOpen(this.details, POSE_PERIOD_MS, () => void this.askPose());
  }

  choose(scene: Scene | null, robot: number): void {
    this.scene = scene;
    this.chosen = robot;
    this.nearest = NaN;
    for (const plot of this.all()) plot.clear();
  }

  show(frame: Frame): void {
    const scene = this.scene;
    const state = frame.robots[this.chosen];
    if (!this.details.open || scene === null || state === undefined) return;
    this.speed?.add(frame.time, state.v);
    for (const scan of frame.scans) {
      const sensor = scene.lasers[scan.sensor] ?? scene.rings[scan.sensor - scene.lasers.length];
      if (sensor === undefined || sensor.robot !== this.chosen || scan.ranges.length === 0) continue;
      let least = STEPS;
      for (const range of scan.ranges) least = Math.min(least, range);
      this.nearest = (least / STEPS) * sensor.range;
    }
    if (!Number.isNaN(this.nearest)) this.near?.add(frame.time, this.nearest);
    for (const plot of this.all()) plot.draw();
  }

  points(): { name: string; times: number[]; values: number[] }[] {
    return this.all().map((plot) => plot.points());
  }

  private all(): Plot[] {
    return [this.speed, this.error, this.near].filter((plot) => plot !== null);
  }

  private build(): void {
    for (const plot of this.all()) plot.destroy();
    this.speed = this.error = this.near = null;
    const into = element("plots-body");
    into.replaceChildren();
    if (!this.details.open) return;
    const width = into.clientWidth;
    this.speed = new Plot(into, "Speed", "m/s", width);
    this.error = new Plot(into, "Odometry off by", "m", width);
    this.near = new Plot(into, "Nearest range", "m", width);
    for (const plot of this.all()) plot.draw();
  }

  // Where the wheels say that the robot is, against where it is.
  private async askPose(): Promise<void> {
    const robot = this.scene?.robots[this.chosen];
    const device = (type: string) => robot?.devices.find((each) => each.type.endsWith(type))?.name;
    const pose = device("Pose");
    const odometry = device("Odometry");
    if (robot === undefined || pose === undefined || odometry === undefined) return;
    try {
      const [is, told] = (await Promise.all([
        this.ask(pose, "get_local_data"), this.ask(odometry, "get_local_data"),
      ])) as [Pose, Pose];
      if (is.timestamp !== told.timestamp) return; // a tick went by in between
      const [x, y, yaw] = robot.start;
      const off = Math.hypot(
        x + told.x * Math.cos(yaw) - told.y * Math.sin(yaw) - is.x,
        y + told.x * Math.sin(yaw) + told.y * Math.cos(yaw) - is.y);
      this.error?.add(is.timestamp, off);
    } catch {
      // The connection was lost; the page says so elsewhere.
    }
  }
}
