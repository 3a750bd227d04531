// The time that is shown, and how it goes on.

export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8];

export class Player {
  constructor(end, onChange) {
    this.end = end;
    this.onChange = onChange;
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.lastFrame = 0;
    this.frame = 0;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.time >= this.end) this.time = 0;
    this.playing = true;
    this.lastFrame = performance.now();
    this.frame = requestAnimationFrame((now) => this.advance(now));
    this.onChange();
  }

  pause() {
    this.playing = false;
    cancelAnimationFrame(this.frame);
    this.onChange();
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    this.onChange();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.onChange();
  }

  changeSpeed(steps) {
    const index = SPEEDS.indexOf(this.speed) + steps;
    this.setSpeed(SPEEDS[Math.min(Math.max(index, 0), SPEEDS.length - 1)]);
  }

  advance(now) {
    if (!this.playing) return;
    const elapsed = Math.max(now - this.lastFrame, 0) / 1000;
    this.lastFrame = now;
    this.time = Math.min(this.time + elapsed * this.speed, this.end);
    if (this.time >= this.end) this.playing = false;
    else this.frame = requestAnimationFrame((next) => this.advance(next));
    this.onChange();
  }
}
