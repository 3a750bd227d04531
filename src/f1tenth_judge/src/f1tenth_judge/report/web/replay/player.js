// The time that is shown, and how it goes on.

export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8];

const SLOW = 0.25; // of the speed, in slow motion

export class Player {
  // `slow`: stretches of time {from, to}, s, that are played in slow motion.
  constructor(end, slow, onChange) {
    this.end = end;
    this.slow = slow;
    this.inSlowMotion = true;
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

  // Seconds per second at this moment.
  get pace() {
    const slow = this.inSlowMotion && this.slow.some(({ from, to }) => this.time >= from && this.time < to);
    return this.speed * (slow ? SLOW : 1);
  }

  advance(now) {
    if (!this.playing) return;
    const elapsed = Math.max(now - this.lastFrame, 0) / 1000;
    this.lastFrame = now;
    this.time = Math.min(this.time + elapsed * this.pace, this.end);
    if (this.time >= this.end) this.playing = false;
    else this.frame = requestAnimationFrame((next) => this.advance(next));
    this.onChange();
  }
}
