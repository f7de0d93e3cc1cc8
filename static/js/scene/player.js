/** Runs motions: calls back with a phase that goes round, unless motion is unwelcome. */
export class Player {
  #frame = 0;
  #phase = 0;
  #last = 0;

  /** @param {(phase: number) => void} step phase in [0, 1) @param {number} period seconds a round */
  constructor(step, period = 9) {
    this.step = step;
    this.period = period;
  }

  get playing() {
    return this.#frame !== 0;
  }

  play() {
    if (this.playing) return;
    this.#last = performance.now();
    /** @param {any} now */
    const tick = (now) => {
      this.#phase = (this.#phase + (now - this.#last) / 1000 / this.period) % 1;
      this.#last = now;
      this.step(this.#phase);
      this.#frame = requestAnimationFrame(tick);
    };
    this.#frame = requestAnimationFrame(tick);
  }

  pause() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }
}
