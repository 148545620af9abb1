import { element } from "./page";

/** A stick for a finger: up is forwards, left turns left. */
export class Pad {
  private readonly pad = element("pad");
  private readonly stick = element("stick");
  private pointer = -1;
  private wanted = false;
  private allowed = true;

  /** `moved` is told of parts of the highest speeds, -1 to 1; 0, 0 when it is let go. */
  constructor(private readonly moved: (v: number, w: number) => void) {
    const coarse = matchMedia("(pointer: coarse)");
    const show = () => {
      this.wanted = coarse.matches;
      this.update();
    };
    coarse.addEventListener("change", show);
    show();
    // A laptop may have both.
    addEventListener("touchstart", () => {
      this.wanted = true;
      this.update();
    }, { once: true, passive: true });
    this.pad.onpointerdown = (event) => {
      this.pointer = event.pointerId;
      this.pad.setPointerCapture(event.pointerId);
      this.follow(event);
    };
    this.pad.onpointermove = (event) => {
      if (event.pointerId === this.pointer) this.follow(event);
    };
    this.pad.onpointerup = this.pad.onpointercancel = (event) => {
      if (event.pointerId !== this.pointer) return;
      this.release();
    };
  }

  allow(allowed: boolean): void {
    this.allowed = allowed;
    this.update();
  }

  release(): void {
    if (this.pointer < 0) return;
    this.pointer = -1;
    this.stick.style.transform = "";
    this.moved(0, 0);
  }

  private update(): void {
    this.pad.hidden = !(this.wanted && this.allowed);
  }

  private follow(event: PointerEvent): void {
    const box = this.pad.getBoundingClientRect();
    const reach = 0.36 * box.width;
    const x = (event.clientX - box.left - box.width / 2) / reach;
    const y = (event.clientY - box.top - box.height / 2) / reach;
    const cut = Math.max(1, Math.hypot(x, y));
    this.stick.style.transform = `translate(${(x / cut) * reach}px, ${(y / cut) * reach}px)`;
    this.moved(-y / cut, -x / cut);
  }
}
