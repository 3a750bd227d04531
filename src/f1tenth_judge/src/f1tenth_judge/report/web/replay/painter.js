// Draws the parts of a run into a context that measures in metres, y upwards; widths are given in pixels.

const LEAST_CAR = 16; // px, of a car's length: a smaller one is drawn larger than it is
const FINE_GRID = 15; // pixels per metre from which on each metre has a line
const WHEEL = { diameter: 0.1, width: 0.05 }; // m

export class Painter {
  constructor(context, scale, colours) {
    this.context = context;
    this.scale = scale;
    this.colours = colours;
  }

  width(pixels) {
    this.context.lineWidth = pixels / this.scale;
  }

  grid({ left, right, bottom, top }) {
    const { context } = this;
    context.beginPath();
    const step = this.scale < FINE_GRID ? 10 : 1; // m
    for (let x = Math.ceil(left / step) * step; x <= right; x += step) this.line(x, bottom, x, top);
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) this.line(left, y, right, y);
    context.strokeStyle = this.colours.grid;
    this.width(0.5);
    context.stroke();
  }

  line(fromX, fromY, toX, toY) {
    this.context.moveTo(fromX, fromY);
    this.context.lineTo(toX, toY);
  }

  shape(shape, fill, stroke = fill) {
    const { context } = this;
    context.beginPath();
    for (const outline of shape.outlines) {
      this.polyline(outline);
      context.closePath();
    }
    for (const { x, y, radius } of shape.circles) {
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fillStyle = fill;
    context.strokeStyle = stroke;
    this.width(1);
    context.fill();
    context.stroke();
  }

  polyline({ x, y }, first = 0, last = x.length) {
    if (first >= last) return;
    this.context.moveTo(x[first], y[first]);
    for (let index = first + 1; index < last; ++index) this.context.lineTo(x[index], y[index]);
  }

  strokeLine(line, colour, pixels, first = 0, last = line.x.length) {
    const { context } = this;
    context.beginPath();
    this.polyline(line, first, last);
    context.strokeStyle = colour;
    context.lineJoin = "round";
    context.lineCap = "round";
    this.width(pixels);
    context.stroke();
  }

  // The path in the colours of its moments' shades: one stroke a colour, not one a period.
  path(track, { shades, colours }, pixels, first, last) {
    const { context } = this;
    context.lineCap = "round";
    this.width(pixels);
    colours.forEach((colour, shade) => {
      context.beginPath();
      for (let index = first + 1; index < last; ++index) {
        if (shades[index] === shade) {
          this.line(track.x[index - 1], track.y[index - 1], track.x[index], track.y[index]);
        }
      }
      context.strokeStyle = colour;
      context.stroke();
    });
  }

  scan({ origin, points }) {
    const { context } = this;
    context.beginPath();
    context.moveTo(origin.x, origin.y);
    for (const point of points) context.lineTo(point.x, point.y);
    context.closePath();
    context.fillStyle = this.colours.scan;
    context.fill();
    context.fillStyle = this.colours.scanEdge;
    const radius = 1.6 / this.scale;
    context.beginPath();
    for (const { x, y, hit } of points) {
      if (hit) context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
    }
    context.fill();
  }

  car(state, body, colour, alpha = 1) {
    const { context } = this;
    const enlarged = Math.max(1, LEAST_CAR / ((body.front - body.rear) * this.scale));
    this.inFrame(state, () => {
      context.scale(enlarged, enlarged);
      context.globalAlpha = alpha;
      for (const [x, turn] of [[0, 0], [body.wheelbase, state.steering || 0]]) {
        for (const side of [-1, 1]) this.wheel(x, (side * (body.track + 0.04)) / 2, turn);
      }
      this.body(body, colour);
      context.globalAlpha = 1;
    });
  }

  wheel(x, y, turn) {
    this.inFrame({ x, y, yaw: turn }, () => {
      this.context.fillStyle = this.colours.text;
      this.context.fillRect(-WHEEL.diameter / 2, -WHEEL.width / 2, WHEEL.diameter, WHEEL.width);
    });
  }

  body({ rear, front, right, left, wheelbase }, colour) {
    const { context } = this;
    context.beginPath();
    context.roundRect(rear, right, front - rear, left - right, [0.04, 0.09, 0.09, 0.04]);
    context.fillStyle = colour;
    context.strokeStyle = this.colours.surface;
    this.width(1.5);
    context.fill();
    context.stroke();
    context.beginPath();
    context.roundRect(0.36 * wheelbase, right + 0.04, 0.4 * wheelbase, left - right - 0.08, 0.03);
    context.fillStyle = this.colours.surface;
    context.globalAlpha *= 0.75;
    context.fill();
  }

  // What a planner draws, in its colour.
  drawing({ colour, lines, dots, texts }) {
    const { context } = this;
    const shown = colour || this.colours.drawing;
    for (const line of lines) this.strokeLine(line, shown, 2);
    context.beginPath();
    for (const { x, y, radius } of dots) {
      const large = Math.max(radius, 1.5 / this.scale);
      context.moveTo(x + large, y);
      context.arc(x, y, large, 0, 2 * Math.PI);
    }
    context.fillStyle = shown;
    context.fill();
    for (const { x, y, text } of texts) this.label(x, y, text, shown, 11, 0, this.colours.road);
  }

  marker(x, y, pixels, fill, text = "") {
    const { context } = this;
    context.beginPath();
    context.arc(x, y, pixels / this.scale, 0, 2 * Math.PI);
    context.fillStyle = fill;
    context.strokeStyle = this.colours.surface;
    this.width(1.5);
    context.fill();
    context.stroke();
    this.label(x, y, text, this.colours.surface, 10);
  }

  tag(x, y, text) {
    this.context.globalAlpha = 0.8;
    this.marker(x, y, 9, this.colours.surface);
    this.context.globalAlpha = 1;
    this.label(x, y, text, this.colours.muted, 10);
  }

  cross(x, y, pixels) {
    const { context } = this;
    const arm = pixels / this.scale;
    for (const [colour, width] of [[this.colours.surface, 6], [this.colours.bad, 3]]) {
      context.beginPath();
      this.line(x - arm, y - arm, x + arm, y + arm);
      this.line(x - arm, y + arm, x + arm, y - arm);
      context.strokeStyle = colour;
      context.lineCap = "round";
      this.width(width);
      context.stroke();
    }
  }

  // `halo`: a colour that parts the text from what is below it.
  label(x, y, text, colour, pixels, dy = 0, halo = "") {
    const { context } = this;
    context.save();
    context.translate(x, y);
    context.scale(1 / this.scale, -1 / this.scale);
    context.font = `600 ${pixels}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    if (halo) Object.assign(context, { strokeStyle: halo, lineWidth: 3, lineJoin: "round" }).strokeText(text, 0, dy);
    context.fillStyle = colour;
    context.fillText(text, 0, dy);
    context.restore();
  }

  inFrame({ x, y, yaw }, draw) {
    const { context } = this;
    context.save();
    context.translate(x, y);
    context.rotate(yaw);
    draw();
    context.restore();
  }
}
