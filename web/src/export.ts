import { element } from "./page";
import { save } from "./save";

const FRAMES_PER_SECOND = 30;
const FILMS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** Saves what is shown as a picture (PNG) or films it (WebM). */
export class Export {
  private readonly filmButton = element<HTMLButtonElement>("film");
  private recorder: MediaRecorder | null = null;
  private timer = 0;

  /** `shown`: the canvas that is seen; `name`: of a file, without its ending. */
  constructor(
    private readonly shown: () => HTMLCanvasElement,
    private readonly name: () => string,
    private readonly failed: (text: string) => void,
  ) {
    element("picture").onclick = () => this.picture();
    this.filmButton.onclick = () => this.film();
  }

  picture(): void {
    this.shown().toBlob((blob) => {
      if (blob === null) return this.failed("This browser gives no picture.");
      save(blob, `${this.name()}.png`);
    }, "image/png");
  }

  /** Begins a film, or ends and saves it. */
  film(): void {
    if (this.recorder !== null) return this.recorder.stop();
    const type = FILMS.find((each) => window.MediaRecorder?.isTypeSupported(each));
    if (type === undefined) return this.failed("This browser cannot film.");
    const recorder = new MediaRecorder(this.shown().captureStream(FRAMES_PER_SECOND), {
      mimeType: type, videoBitsPerSecond: 8_000_000,
    });
    const parts: Blob[] = [];
    const name = this.name();
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      clearInterval(this.timer);
      this.recorder = null;
      this.label("Film", false);
      for (const track of recorder.stream.getTracks()) track.stop();
      save(new Blob(parts, { type }), `${name}.${type.startsWith("video/mp4") ? "mp4" : "webm"}`);
    };
    recorder.start(1000);
    this.recorder = recorder;
    const start = performance.now();
    const tell = () =>
      this.label(`Stop (${Math.floor((performance.now() - start) / 1000)} s)`, true);
    tell();
    this.timer = window.setInterval(tell, 500);
  }

  private label(text: string, on: boolean): void {
    this.filmButton.textContent = text;
    this.filmButton.setAttribute("aria-pressed", String(on));
  }
}
