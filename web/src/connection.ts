import { type Frame, type Scene, readFrame } from "./protocol";

/** Ways in which the link to the simulator can be. */
export type LinkState = "connecting" | "connected" | "lost";

interface Handlers {
  scene(scene: Scene): void;
  frame(frame: Frame): void;
  state(state: LinkState): void;
}

const RETRY_MS = 1000;

/** The WebSocket to the simulator; it connects anew by itself until the page is closed. */
export class Connection {
  private socket: WebSocket | null = null;
  private nextId = 1;
  private readonly waiting = new Map<
    number,
    { done: (value: unknown) => void; failed: (error: Error) => void }
  >();

  constructor(private readonly handlers: Handlers) {
    this.connect();
  }

  /** Calls a service of the simulator and gives its answer; rejects with its reason. */
  call(component: string, service: string, args: unknown[] = []): Promise<unknown> {
    const socket = this.socket;
    if (socket === null || socket.readyState !== WebSocket.OPEN) {
      return Promise.reject(new Error("not connected"));
    }
    const id = this.nextId++;
    socket.send(JSON.stringify({ id, call: [component, service, args] }));
    return new Promise((done, failed) => this.waiting.set(id, { done, failed }));
  }

  private connect(): void {
    this.handlers.state("connecting");
    const socket = new WebSocket(`ws://${location.host}/view${location.search}`);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onopen = () => this.handlers.state("connected");
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => {
      if (typeof event.data === "string") {
        this.take(JSON.parse(event.data));
      } else {
        this.handlers.frame(readFrame(event.data));
        // Confirmed once it has been shown, so a page that cannot keep up gets fewer.
        requestAnimationFrame(() => {
          if (socket.readyState === WebSocket.OPEN) socket.send("k");
        });
      }
    };
    socket.onclose = () => {
      this.socket = null;
      for (const { failed } of this.waiting.values()) failed(new Error("the connection was lost"));
      this.waiting.clear();
      this.handlers.state("lost");
      setTimeout(() => this.connect(), RETRY_MS);
    };
  }

  private take(message: Scene | { id: number; ok: boolean; value: unknown }): void {
    if ("scene" in message) {
      this.handlers.scene(message);
      return;
    }
    const waiting = this.waiting.get(message.id);
    if (waiting === undefined) return;
    this.waiting.delete(message.id);
    if (message.ok) {
      waiting.done(message.value);
    } else {
      waiting.failed(new Error(String(message.value)));
    }
  }
}
