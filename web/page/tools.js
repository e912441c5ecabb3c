"use strict";
// Fingers, mouse and keys on the map. `app` is what main.js makes.

const kNear = 10;  // pixels

class Tools {
  constructor(app) {
    this.app = app;
    this.tool = "look";
    this.pointers = new Map();
    this.draft = null;
    const front = app.sheet.front;
    front.addEventListener("pointerdown", (e) => this.down(e));
    front.addEventListener("pointermove", (e) => this.moved(e));
    for (const end of ["pointerup", "pointercancel"]) front.addEventListener(end, (e) => this.up(e));
    front.addEventListener("wheel", (e) => {
      e.preventDefault();
      app.sheet.zoom(Math.exp(-e.deltaY * (e.deltaMode ? 0.05 : e.ctrlKey ? 0.01 : 0.0016)), ...this.place(e));
      app.viewChanged();
    }, {passive: false});
    front.addEventListener("keydown", (e) => this.key(e));
    for (const which of ["start", "goal"]) this.handle(which);
    for (const button of document.querySelectorAll("[data-tool]")) {
      button.addEventListener("click", () => this.choose(button.dataset.tool));
      button.addEventListener("keydown", (e) => this.radioKey(e, button));
    }
    this.choose("look");
  }
  radioKey(e, button) {
    const step = {ArrowRight: "nextElementSibling", ArrowDown: "nextElementSibling", ArrowLeft: "previousElementSibling", ArrowUp: "previousElementSibling"}[e.key];
    const to = step && button[step];
    if (!to) return;
    e.preventDefault();
    this.choose(to.dataset.tool);
    to.focus();
  }
  choose(tool) {
    this.tool = tool;
    this.drop();
    for (const button of document.querySelectorAll("[data-tool]")) {
      button.setAttribute("aria-checked", String(button.dataset.tool === tool));
      button.tabIndex = button.dataset.tool === tool ? 0 : -1;
    }
    this.app.sheet.front.className = tool;
    const hint = {draw: "Drag to draw a wall", move: "Drag a wall or one of its ends", erase: "Click a wall to remove it"}[tool];
    this.app.hint(hint ?? "");
  }
  drop() {
    this.draft = null;
    this.app.drawFront();
  }
  place(e) {
    const box = this.app.sheet.front.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }

  // ---- start and goal ---------------------------------------------------------------------------------------------
  handle(which) {
    const button = document.getElementById(which), app = this.app;
    let grip = null;
    button.addEventListener("pointerdown", (e) => {
      button.setPointerCapture(e.pointerId);
      const [x, y] = app.sheet.toScreen(app.endOf(which)), [px, py] = this.place(e);
      grip = [px - x, py - y];
      app.model.mark();
    });
    button.addEventListener("pointermove", (e) => {
      if (!grip) return;
      const [px, py] = this.place(e);
      app.moveEnd(which, app.rounded(app.sheet.toWorld(px - grip[0], py - grip[1])));
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(end, () => {
      if (grip) app.settled();
      grip = null;
    });
    button.addEventListener("keydown", (e) => {
      const step = this.arrow(e);
      if (!step) return;
      e.preventDefault();
      const size = app.step() * (e.shiftKey ? 0.1 : 1), [x, y] = app.endOf(which);
      app.model.mark();
      app.moveEnd(which, app.tidy([x + step[0] * size, y - app.sheet.up * -step[1] * size]));
      app.settled();
    });
  }
  // To the right, and up on the screen.
  arrow(e) {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key];
    return step && [step[0], -this.app.sheet.up * step[1]];
  }

  // ---- the map ----------------------------------------------------------------------------------------------------
  down(e) {
    this.app.sheet.front.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, this.place(e));
    if (this.pointers.size > 1) { this.drop(); return; }
    const p = this.app.sheet.toWorld(...this.place(e));
    if (this.tool === "draw") this.draft = {wall: [...this.app.snapped(p), ...this.app.snapped(p)]};
    if (this.tool === "move") this.draft = this.grab(p);
    if (this.tool === "erase") this.erase(p);
    this.app.sheet.front.classList.add("dragging");
  }
  moved(e) {
    if (!this.pointers.has(e.pointerId)) return;
    const old = this.pointers.get(e.pointerId), now = this.place(e);
    if (this.pointers.size === 2) { this.pinch(e.pointerId, old, now); return; }
    this.pointers.set(e.pointerId, now);
    const p = this.app.sheet.toWorld(...now);
    if (this.tool === "look" || (this.tool === "move" && !this.draft)) {
      this.app.sheet.pan(now[0] - old[0], now[1] - old[1]);
      this.app.viewChanged();
    } else if (this.tool === "draw" && this.draft) {
      this.draft.wall.splice(2, 2, ...this.app.snapped(p));
      this.app.drawFront();
    } else if (this.tool === "move" && this.draft) this.drag(p);
  }
  pinch(id, old, now) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const before = Math.hypot(old[0] - other[0], old[1] - other[1]), after = Math.hypot(now[0] - other[0], now[1] - other[1]);
    this.pointers.set(id, now);
    this.app.sheet.pan((now[0] - old[0]) / 2, (now[1] - old[1]) / 2);
    if (before > 0) this.app.sheet.zoom(after / before, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    this.app.viewChanged();
  }
  up(e) {
    if (!this.pointers.delete(e.pointerId)) return;
    this.app.sheet.front.classList.remove("dragging");
    const draft = this.draft;
    this.draft = null;
    if (this.tool === "draw" && draft) this.finish(draft.wall);
    if (this.tool === "move" && draft) this.app.setWalls(this.app.model.withMovedWall(draft.index, this.movedWall(draft)));
    this.app.drawFront();
  }
  finish(wall) {
    if (wall[0] === wall[2] && wall[1] === wall[3]) return;
    this.app.setWalls(this.app.model.withWall([...wall, this.app.thickness()]));
  }
  // The wall nearest to p, and which end of it: 0, 1, or 2 for its middle.
  nearest(p) {
    const walls = this.app.model.walls;
    let best = null, least = this.app.sheet.pixels(kNear);
    for (let i = 0; i < walls.length; i += 5) {
      const ax = walls[i], ay = walls[i + 1], bx = walls[i + 2], by = walls[i + 3], t = walls[i + 4], dx = bx - ax, dy = by - ay;
      const share = Math.max(0, Math.min(1, ((p[0] - ax) * dx + (p[1] - ay) * dy) / (dx * dx + dy * dy || 1)));
      const d = Math.hypot(p[0] - ax - share * dx, p[1] - ay - share * dy) - t / 2;
      if (d < least) [least, best] = [d, {index: i / 5, wall: [ax, ay, bx, by]}];
    }
    if (!best) return null;
    const [ax, ay, bx, by] = best.wall, near = this.app.sheet.pixels(kNear);
    best.part = Math.hypot(p[0] - ax, p[1] - ay) < near ? 0 : Math.hypot(p[0] - bx, p[1] - by) < near ? 1 : 2;
    return best;
  }
  grab(p) {
    const found = this.nearest(p);
    return found && {...found, from: p, old: [...found.wall]};
  }
  drag(p) {
    const d = this.draft;
    if (d.part < 2) d.wall.splice(2 * d.part, 2, ...this.app.snapped(p));
    else {
      const a = this.app.snapped([d.old[0] + p[0] - d.from[0], d.old[1] + p[1] - d.from[1]]);
      d.wall = this.app.tidy([...a, d.old[2] + a[0] - d.old[0], d.old[3] + a[1] - d.old[1]]);
    }
    this.app.drawFront();
  }
  movedWall(d) { return [...d.wall, this.app.model.walls[5 * d.index + 4]]; }
  erase(p) {
    const found = this.nearest(p);
    if (found) this.app.setWalls(this.app.model.withoutWall(found.index));
  }

  // ---- keys -------------------------------------------------------------------------------------------------------
  key(e) {
    const step = this.arrow(e);
    if (step) {
      e.preventDefault();
      if (this.tool === "look") this.app.sheet.pan(-60 * step[0], -60 * this.app.sheet.up * step[1]);
      else this.cross(step, e.shiftKey);
      this.app.viewChanged();
    } else if ((e.key === "Enter" || e.key === " ") && this.tool !== "look") {
      e.preventDefault();
      this.set();
    }
  }
  cross(step, finely) {
    const size = this.app.step() * (finely ? 0.1 : 1);
    this.draft ??= {at: this.app.snapped(this.app.sheet.centre)};
    this.draft.at = this.app.tidy([(this.draft.at ?? this.app.sheet.centre)[0] + step[0] * size, (this.draft.at ?? this.app.sheet.centre)[1] + step[1] * size]);
    if (this.draft.wall && this.tool === "draw") this.draft.wall.splice(2, 2, ...this.draft.at);
    if (this.draft.wall && this.tool === "move") this.drag(this.draft.at);
    this.app.say(`crosshair at ${this.app.words(this.draft.at)}`);
  }
  gripOrDrop(at) {
    const held = this.draft.wall && this.draft;
    this.draft = held ? {at} : {...this.grab(at), at};
    if (held) this.app.setWalls(this.app.model.withMovedWall(held.index, this.movedWall(held)));
    this.app.say(held ? "wall dropped" : this.draft.wall ? `wall held by ${["its first end", "its second end", "its middle"][this.draft.part]}` : "no wall here");
  }
  set() {
    const at = this.draft?.at;
    if (!at) return;
    if (this.tool === "erase") this.erase(at);
    else if (this.tool === "move") this.gripOrDrop(at);
    else if (this.tool === "draw" && this.draft.wall) {
      this.finish(this.draft.wall);
      this.draft = {at};
    } else if (this.tool === "draw") this.draft.wall = [...at, ...at];
    this.app.drawFront();
  }
}
