"use strict";
// What the user has made of the world: walls, ends, radius; undone and redone; kept in the address.

class Model {
  constructor(world) {
    this.first = world;                // as it was loaded
    this.walls = world.walls;          // five numbers each; never changed in place
    this.start = world.start ?? world.ends.start;
    this.goal = world.goal ?? (world.room.length ? null : world.ends.goal);  // null: the room
    this.radius = 0;
    this.past = [];
    this.future = [];
  }
  state() { return {walls: this.walls, start: this.start, goal: this.goal, radius: this.radius}; }
  // Before a change: what undo goes back to.
  mark() {
    const now = this.state(), last = this.past[this.past.length - 1];
    if (last && Object.keys(now).every((key) => last[key] === now[key])) return;
    this.past.push(now);
    this.future = [];
  }
  undo() { return this.go(this.past, this.future); }
  redo() { return this.go(this.future, this.past); }
  go(from, to) {
    let state = from.pop();
    while (state && Object.keys(state).every((key) => state[key] === this[key])) state = from.pop();
    if (!state) return false;
    to.push(this.state());
    Object.assign(this, state);
    return true;
  }
  get edited() { return this.walls !== this.first.walls; }
  query() {
    const query = {};
    if (this.start) query.start = this.start;
    if (this.goal) query.goal = this.goal;
    return query;
  }
  wallCount() { return this.walls.length / 5; }
  wall(i) { return this.walls.slice(5 * i, 5 * i + 5); }
  withWall(wall) { return [...this.walls, ...wall]; }
  withoutWall(i) { return [...this.walls.slice(0, 5 * i), ...this.walls.slice(5 * i + 5)]; }
  withMovedWall(i, wall) { return [...this.walls.slice(0, 5 * i), ...wall, ...this.walls.slice(5 * i + 5)]; }

  // -3 is the fourth wall of the file, gone; +x1,y1,x2,y2,t is a new one.
  difference() {
    const keyed = (walls) => {
      const keys = [];
      for (let i = 0; i < walls.length; i += 5) keys.push(walls.slice(i, i + 5).join(","));
      return keys;
    };
    const old = keyed(this.first.walls), now = keyed(this.walls);
    const counts = new Map();
    for (const key of now) counts.set(key, (counts.get(key) ?? 0) + 1);
    const words = [];
    old.forEach((key, i) => {
      const left = counts.get(key) ?? 0;
      if (left) counts.set(key, left - 1); else words.push("-" + i);
    });
    for (const [key, count] of counts) for (let i = 0; i < count; ++i) words.push("+" + key);
    return words;
  }
  applied(words) {
    const gone = new Set(words.filter((w) => w[0] === "-").map((w) => Number(w.slice(1))));
    const walls = [];
    for (let i = 0; i < this.first.walls.length / 5; ++i) if (!gone.has(i)) walls.push(...this.first.walls.slice(5 * i, 5 * i + 5));
    for (const word of words) {
      const wall = word[0] === "+" ? word.slice(1).split(",").map(Number) : [];
      if (wall.length === 5 && wall.every(Number.isFinite)) walls.push(...wall);
    }
    return walls;
  }
}

function pointOf(text) {
  const p = (text ?? "").split(",").map(Number);
  return p.length === 2 && p.every(Number.isFinite) ? p : null;
}

// s=1,2&g=3,4&r=0.1&w=-3;+0,0,1,1,0&d=6&l=mesh.gates&v=x,y,scale
function addressOf(model, layers, view, digits) {
  const parts = [];
  if (model.start) parts.push("s=" + model.start);
  if (model.goal) parts.push("g=" + model.goal);
  if (model.radius) parts.push("r=" + model.radius);
  if (model.edited) parts.push("w=" + model.difference().join(";"));
  if (digits !== 6) parts.push("d=" + digits);
  parts.push("l=" + layers.join("."));
  if (view) parts.push("v=" + view.map((v) => Number(v.toPrecision(8))));
  return "#" + parts.join("&");
}

function readAddress() {
  const found = {};
  for (const part of decodeURIComponent(location.hash.slice(1)).split("&")) {
    const at = part.indexOf("=");
    if (at > 0) found[part.slice(0, at)] = part.slice(at + 1);
  }
  return found;
}
