// The stretch of time or road that is to be seen.

const LEAST_PART = 0.001; // of the whole

export class Span {
  constructor(onChange) {
    this.onChange = onChange;
    /** @type {{from: number, to: number} | null} */
    this.part = null; // all of it
    this.setWhole(0, 0);
  }

  // What there is to be seen; a part of it that is shown stays.
  setWhole(begins, ends) {
    this.begins = begins;
    this.ends = Math.max(ends, begins + 0.001);
  }

  get from() {
    return this.part?.from ?? this.begins;
  }

  get to() {
    return this.part?.to ?? this.ends;
  }

  get length() {
    return this.to - this.from;
  }

  // A place keeps where it is on the screen.
  zoom(factor, place) {
    const whole = this.ends - this.begins;
    const length = Math.min(Math.max(this.length / factor, LEAST_PART * whole), whole);
    if (length === whole) this.show(null);
    else this.show(place - (place - this.from) * (length / this.length), length);
  }

  pan(by) {
    if (this.part) this.show(this.from + by, this.length);
  }

  // Goes on to a place that is outside.
  follow(place) {
    if (this.part && (place < this.from || place > this.to)) this.show(place - 0.1 * this.length, this.length);
  }

  // null: all.
  show(from, length = 0) {
    const first = Math.max(Math.min(from, this.ends - length), this.begins);
    this.part = from === null ? null : { from: first, to: first + length };
    this.onChange();
  }
}
