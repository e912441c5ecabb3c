"use strict";
// Two sheets: the ground (world and layers, drawn when they or the view change) and the front (path, drawn on a drag).

const kColours = ["paper", "outside", "floor", "wall", "solid", "path", "start", "goal", "accent", "bad", "tri", "mesh", "graph", "voronoi", "gate", "region", "robot", "ink"];

const kMargin = 28, kButtons = 36;  // pixels around the world, and for the buttons that zoom

// The walls, four numbers each, those of thickness apart; kept as long as the walls are the same.
const kSorted = new WeakMap();
function byThickness(walls) {
  if (kSorted.has(walls)) return kSorted.get(walls);
  const sorted = {thin: [], thick: new Map()};
  for (let i = 0; i < walls.length; i += 5) {
    const t = walls[i + 4];
    if (t !== 0 && !sorted.thick.has(t)) sorted.thick.set(t, []);
    (t === 0 ? sorted.thin : sorted.thick.get(t)).push(walls[i], walls[i + 1], walls[i + 2], walls[i + 3]);
  }
  kSorted.set(walls, sorted);
  return sorted;
}

class Sheet {
  constructor(ground, front) {
    this.ground = ground;
    this.front = front;
    this.scale = 1;       // pixels a unit
    this.centre = [0, 0];
    this.readColours();
  }
  readColours() {
    const style = getComputedStyle(this.ground);
    this.colour = Object.fromEntries(kColours.map((name) => [name, style.getPropertyValue("--" + name).trim()]));
  }
  resize() {
    const box = this.front.getBoundingClientRect();
    this.measure(box.width, box.height, window.devicePixelRatio || 1);
  }
  measure(width, height, ratio) {
    Object.assign(this, {width, height, ratio});
    for (const canvas of [this.ground, this.front]) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
  }
  // What `other` shows, on this one's canvases.
  showLike(other, ratio) {
    const {centre, scale, yDown} = other;
    Object.assign(this, {centre, scale, yDown});
    this.measure(other.width, other.height, ratio);
  }
  fit(box) {
    const w = Math.max(box[2] - box[0], 1e-9), h = Math.max(box[3] - box[1], 1e-9);
    this.scale = Math.min((this.width - 2 * kMargin - kButtons) / w, (this.height - 2 * kMargin) / h);
    this.least = this.scale / 20;
    this.most = this.scale * 1e6;
    this.centre = [(box[0] + box[2]) / 2 + kButtons / 2 / this.scale, (box[1] + box[3]) / 2];
  }
  get up() { return this.yDown ? 1 : -1; }
  toScreen(p) {
    return [this.width / 2 + (p[0] - this.centre[0]) * this.scale, this.height / 2 + this.up * (p[1] - this.centre[1]) * this.scale];
  }
  toWorld(x, y) {
    return [this.centre[0] + (x - this.width / 2) / this.scale, this.centre[1] + this.up * (y - this.height / 2) / this.scale];
  }
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const before = this.toWorld(x, y);
    this.scale = Math.min(this.most, Math.max(this.least, this.scale * factor));
    const after = this.toWorld(x, y);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
  }
  pan(dx, dy) { this.centre = [this.centre[0] - dx / this.scale, this.centre[1] - this.up * dy / this.scale]; }

  begin(canvas) {
    const context = canvas.getContext("2d"), r = this.ratio, s = this.scale * r;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    // Counted from the centre, so that a float of the canvas is enough far from home.
    context.setTransform(s, 0, 0, this.up * s, canvas.width / 2, canvas.height / 2);
    context.lineCap = "round";
    context.lineJoin = "round";
    return context;
  }
  pixels(n) { return n / this.scale; }
  at(x, y) { return [x - this.centre[0], y - this.centre[1]]; }

  trace(context, ring) {
    for (let i = 0; i < ring.length; i += 2) {
      const x = ring[i] - this.centre[0], y = ring[i + 1] - this.centre[1];
      if (i) context.lineTo(x, y); else context.moveTo(x, y);
    }
    context.closePath();
  }
  polygons(context, list) {
    context.beginPath();
    for (const polygon of list) for (const ring of polygon) this.trace(context, ring);
  }
  segments(context, flat, step = 4) {
    const [cx, cy] = this.centre;
    context.beginPath();
    for (let i = 0; i < flat.length; i += step) {
      context.moveTo(flat[i] - cx, flat[i + 1] - cy);
      context.lineTo(flat[i + 2] - cx, flat[i + 3] - cy);
    }
    context.stroke();
  }
  line(context, flat) {
    context.beginPath();
    for (let i = 0; i < flat.length; i += 2) {
      if (i) context.lineTo(flat[i] - this.centre[0], flat[i + 1] - this.centre[1]);
      else context.moveTo(flat[i] - this.centre[0], flat[i + 1] - this.centre[1]);
    }
  }
  ink(context, colour, pixels) {
    context.strokeStyle = this.colour[colour];
    context.lineWidth = this.pixels(pixels);
  }

  drawGround(model, world, layers, shown) {
    const context = this.begin(this.ground);
    this.polygons(context, world.areas);
    context.fillStyle = this.colour.floor;
    context.fill();
    if (world.room.length && !model.goal) this.drawRoom(context, world.room);
    if (model.radius > 0) this.drawForbidden(context, model, world);
    if (shown.has("region") && layers.region?.ring) {
      context.beginPath();
      this.trace(context, layers.region.ring);
      context.fillStyle = this.colour.region;
      context.fill();
    }
    if (shown.has("triangulation") && layers.triangulation) this.layer(context, layers.triangulation.segments, "tri", 1);
    if (shown.has("visibility") && layers.visibility) this.layer(context, layers.visibility.segments, "graph", 0.8, 0.55);
    if (shown.has("mesh") && layers.mesh) this.layer(context, layers.mesh.segments, "mesh", 1.2);
    if (shown.has("voronoi") && layers.voronoi) this.drawCurves(context, layers.voronoi.curves);
    if (shown.has("gates") && layers.gates) this.drawGates(context, layers.gates, model.radius);
    if (shown.has("walls")) this.drawWalls(context, model, world);
  }
  layer(context, flat, colour, pixels, alpha = 1) {
    this.ink(context, colour, pixels);
    context.globalAlpha = alpha;
    this.segments(context, flat);
    context.globalAlpha = 1;
  }
  drawRoom(context, boxes) {
    context.beginPath();
    for (const b of boxes) context.rect(...this.at(b[0], b[1]), b[2] - b[0], b[3] - b[1]);
    context.fillStyle = this.colour.robot;
    context.fill();
  }
  // Where the disc's centre cannot be: everything nearer than its radius to a wall.
  drawForbidden(context, model, world) {
    const {thin, thick} = byThickness(model.walls);
    context.save();
    this.polygons(context, world.areas);
    context.clip("evenodd");
    context.strokeStyle = this.colour.outside;
    context.lineWidth = 2 * model.radius;
    this.segments(context, thin);
    for (const [t, flat] of thick) {
      context.lineWidth = 2 * model.radius + t;
      this.segments(context, flat);
    }
    context.lineWidth = 2 * model.radius;
    this.polygons(context, world.boundary === "walled" ? [...world.solids, ...world.areas] : world.solids);
    context.stroke();
    context.restore();
  }
  drawCurves(context, flat) {
    const [cx, cy] = this.centre;
    this.ink(context, "voronoi", 1.2);
    context.beginPath();
    for (let i = 0; i < flat.length; i += 6) {
      context.moveTo(flat[i] - cx, flat[i + 1] - cy);
      context.quadraticCurveTo(flat[i + 2] - cx, flat[i + 3] - cy, flat[i + 4] - cx, flat[i + 5] - cy);
    }
    context.stroke();
  }
  drawGates(context, gates, radius) {
    const open = [], closed = [];
    gates.widths.forEach((width, i) => (width < 2 * radius ? closed : open).push(...gates.segments.slice(4 * i, 4 * i + 4)));
    context.setLineDash([this.pixels(3), this.pixels(4)]);
    this.layer(context, open, "gate", 1.4);
    context.setLineDash([]);
    this.layer(context, closed, "bad", 1.6);
  }
  drawWalls(context, model, world) {
    context.fillStyle = this.colour.solid;
    this.polygons(context, world.solids);
    context.fill("evenodd");
    if (world.boundary === "walled") {
      this.ink(context, "wall", 1.6);
      this.polygons(context, world.areas);
      context.stroke();
    }
    const {thin, thick} = byThickness(model.walls);
    this.ink(context, "wall", Math.max(0.8, Math.min(2.2, this.scale / 8)));
    this.segments(context, thin);
    context.lineCap = "square";
    for (const [t, flat] of thick) {
      context.lineWidth = Math.max(t, this.pixels(1));
      this.segments(context, flat);
    }
  }

  drawFront(model, answer, draft) {
    const context = this.begin(this.front);
    if (answer?.status === "found") this.drawPath(context, model, answer);
    if (answer?.status === "none") this.drawReason(context, answer);
    if (draft) this.drawDraft(context, draft);
  }
  drawPath(context, model, answer) {
    this.tracePath(context, answer);
    if (model.radius > 0) {
      context.strokeStyle = this.colour.robot;
      context.lineWidth = 2 * model.radius;
      context.stroke();
    }
    this.ink(context, "floor", 6);
    context.stroke();
    this.ink(context, "path", 3);
    context.stroke();
  }
  tracePath(context, answer) {
    if (answer.points) { this.line(context, answer.points); return; }
    const p = answer.pieces;
    context.beginPath();
    for (let i = 0; i < p.length; i += 7) {
      if (i === 0) context.moveTo(...this.at(p[i], p[i + 1]));
      const to = this.at(p[i + 2], p[i + 3]);
      if (p[i + 4] === 0) { context.lineTo(...to); continue; }
      const centre = this.at(p[i + 5], p[i + 6]), from = this.at(p[i], p[i + 1]);
      const angle = (q) => Math.atan2(q[1] - centre[1], q[0] - centre[0]);
      context.arc(...centre, Math.hypot(from[0] - centre[0], from[1] - centre[1]), angle(from), angle(to), p[i + 4] < 0);
    }
  }
  drawReason(context, answer) {
    this.ink(context, "bad", 4);
    this.segments(context, answer.walls);
    context.setLineDash([this.pixels(2), this.pixels(6)]);
    this.ink(context, "bad", 3);
    this.segments(context, answer.gates);
    context.setLineDash([]);
  }
  // Start and goal, where no handles can be.
  drawEnds(start, goal) {
    const context = this.ground.getContext("2d"), r = this.pixels(7);
    const draw = (colour, trace) => {
      context.beginPath();
      trace();
      context.fillStyle = this.colour[colour];
      context.fill();
      this.ink(context, "floor", 2);
      context.stroke();
    };
    if (start) draw("start", () => context.arc(...this.at(...start), r, 0, 7));
    if (!goal) return;
    const [x, y] = this.at(...goal);
    draw("goal", () => this.trace(context, [x - r, y, x, y + r, x + r, y, x, y - r].map((v, i) => v + this.centre[i % 2])));
  }
  drawDraft(context, draft) {
    this.ink(context, "accent", 3);
    if (draft.wall) this.segments(context, draft.wall);
    if (!draft.at) return;
    const [x, y] = this.at(...draft.at), r = this.pixels(6);
    context.beginPath();
    context.moveTo(x - r, y);
    context.lineTo(x + r, y);
    context.moveTo(x, y - r);
    context.lineTo(x, y + r);
    this.ink(context, "accent", 1.5);
    context.stroke();
  }
}
