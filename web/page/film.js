"use strict";
// A film in the place of a world: an SVG whose parts move by SMIL, with its clock in the reader's hands.

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 8];
const kMoving = "animate, animateMotion, animateTransform, set";
const secondsOf = (text) => parseFloat(text ?? "") || 0;

// How far along each corner of a line is, as a part of the whole; null: it has curves.
function cornersOf(path) {
  const words = path.match(/[a-zA-Z]|-?[\d.]+(?:e-?\d+)?/g) ?? [], along = [];
  let x = 0, y = 0, length = 0, does = "M";
  for (let i = 0; i < words.length;) {
    if (/[a-zA-Z]/.test(words[i])) does = words[i++];
    const is = does.toLowerCase(), own = does === is, before = [x, y];
    if (!"mlhv".includes(is)) return null;
    if (is !== "v") x = Number(words[i++]) + (own ? x : 0);
    if (is !== "h") y = Number(words[i++]) + (own ? y : 0);
    if (is !== "m" || !along.length) length += along.length ? Math.hypot(x - before[0], y - before[1]) : 0;
    along.push(length);
    if (is === "m") does = own ? "l" : "L";
  }
  return length > 0 ? along.map((v) => v / length) : null;
}

// When something of this element begins or turns, as parts of its duration.
function turns(element) {
  const keys = element.getAttribute("keyTimes");
  if (keys) return keys.split(";").map(Number);
  const line = element.getAttribute("path");
  if (line) return cornersOf(line) ?? Array.from({length: 51}, (_, i) => i / 50);
  const values = (element.getAttribute("values") ?? "").split(";").length;
  return Array.from({length: Math.max(values, 2)}, (_, i) => i / Math.max(values - 1, 1));
}

class Film {
  constructor(svg) {
    this.svg = svg;
    this.clocks = [svg, ...svg.querySelectorAll("svg")];  // in some browsers a drawing within has one of its own
    const all = [...svg.querySelectorAll(kMoving)], moments = new Set([0]);
    this.repeats = all.some((e) => e.getAttribute("repeatCount") === "indefinite");
    this.lasts = 0;
    for (const element of all) {
      const begin = secondsOf(element.getAttribute("begin")), lasts = secondsOf(element.getAttribute("dur"));
      this.lasts = Math.max(this.lasts, begin + lasts);
      for (const part of lasts ? turns(element) : [0]) moments.add(Math.round((begin + part * lasts) * 1000) / 1000);
    }
    if (this.repeats) moments.delete(Math.round(this.lasts * 1000) / 1000);  // there it is at its beginning again
    this.moments = [...moments].sort((a, b) => a - b);
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    for (const clock of this.clocks) clock.pauseAnimations();
  }
  get moves() { return this.lasts > 0; }
  get last() { return this.repeats ? this.lasts - 0.001 : this.lasts; }
  // Which moment it is: the last that has come.
  step() {
    let low = 0, high = this.moments.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.moments[middle] <= this.time + 1e-6) low = middle; else high = middle;
    }
    return low;
  }
  seek(time) {
    this.time = Math.max(0, Math.min(time, this.last));
    this.svg.classList.add("plays");  // who moves it wants to see it, also where motion is reduced
    for (const clock of this.clocks) clock.setCurrentTime(this.time);
  }
  // Back from between two moments is to the earlier of them.
  by(steps) {
    const here = this.step(), between = this.time > this.moments[here] + 1e-6 && steps < 0 ? 1 : 0;
    this.seek(this.moments[Math.max(0, Math.min(here + steps + between, this.moments.length - 1))]);
  }
  // So much time has gone by.
  tick(seconds) {
    const to = this.time + seconds * this.speed;
    if (to < this.lasts) this.seek(to);
    else if (this.repeats) this.seek(to % this.lasts);
    else { this.seek(this.lasts); this.playing = false; }
  }
}

// Which part of the picture is seen.
class Lens {
  constructor(svg, stage) {
    const box = svg.viewBox.baseVal;
    this.svg = svg;
    this.stage = stage;
    this.whole = [box.x, box.y, box.width, box.height];
    this.pointers = new Map();
    this.fit();
    stage.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(-e.deltaY * (e.deltaMode ? 0.05 : e.ctrlKey ? 0.01 : 0.0016)), e.clientX, e.clientY);
    }, {passive: false});
    stage.addEventListener("pointerdown", (e) => {
      stage.setPointerCapture(e.pointerId);
      this.pointers.set(e.pointerId, [e.clientX, e.clientY]);
    });
    stage.addEventListener("pointermove", (e) => this.moved(e));
    for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, (e) => this.pointers.delete(e.pointerId));
  }
  show(part) {
    this.part = part;
    this.svg.setAttribute("viewBox", part.join(" "));
  }
  fit() { this.show(this.whole); }
  unit() {
    const box = this.stage.getBoundingClientRect();
    return Math.max(this.part[2] / box.width, this.part[3] / box.height);
  }
  pan(dx, dy) {
    const unit = this.unit(), [x, y, w, h] = this.part;
    this.show([x - dx * unit, y - dy * unit, w, h]);
  }
  // `factor` times as large, what is below that place of the screen staying there.
  zoom(factor, clientX, clientY) {
    const box = this.stage.getBoundingClientRect(), unit = this.unit(), [x, y, w, h] = this.part;
    const by = Math.min(Math.max(factor, this.part[2] / (4 * this.whole[2])), this.part[2] * 400 / this.whole[2]);
    const dx = ((clientX ?? box.x + box.width / 2) - box.x - box.width / 2) * unit, dy = ((clientY ?? box.y + box.height / 2) - box.y - box.height / 2) * unit;
    const at = [x + w / 2 + dx, y + h / 2 + dy];
    this.show([at[0] - dx / by - w / by / 2, at[1] - dy / by - h / by / 2, w / by, h / by]);
  }
  moved(e) {
    const old = this.pointers.get(e.pointerId);
    if (!old) return;
    const now = [e.clientX, e.clientY], other = [...this.pointers].find(([key]) => key !== e.pointerId)?.[1];
    this.pointers.set(e.pointerId, now);
    this.pan((now[0] - old[0]) / this.pointers.size, (now[1] - old[1]) / this.pointers.size);
    const before = other && Math.hypot(old[0] - other[0], old[1] - other[1]);
    if (before > 0) this.zoom(Math.hypot(now[0] - other[0], now[1] - other[1]) / before, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }
}

class Player {
  constructor(svg) {
    this.film = new Film(svg);
    this.lens = new Lens(svg, by("film"));
    const {film} = this, slider = by("time");
    slider.max = String(Math.floor(film.last * 1000) / 1000);
    by("player").hidden = !film.moves;
    by("speed").replaceChildren(...kSpeeds.map((v) => new Option(v + "×", String(v), v === 1, v === 1)));
    by("play").addEventListener("click", () => this.play(!film.playing));
    by("back").addEventListener("click", () => this.step(-1));
    by("forward").addEventListener("click", () => this.step(1));
    by("speed").addEventListener("change", () => this.setSpeed(Number(by("speed").value)));
    slider.addEventListener("input", () => this.go(Number(slider.value)));
    slider.addEventListener("change", () => this.remember());
    by("zoom-in").addEventListener("click", () => this.lens.zoom(1.5));
    by("zoom-out").addEventListener("click", () => this.lens.zoom(1 / 1.5));
    by("zoom-fit").addEventListener("click", () => this.lens.fit());
    document.addEventListener("keydown", (e) => this.key(e));
    const kept = readAddress();
    if (kSpeeds.includes(Number(kept.x))) this.setSpeed(Number(kept.x));
    if (kept.t !== undefined) this.go(secondsOf(kept.t));
    else if (film.moves && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.play(true);
    this.tell();
  }
  play(on) {
    const {film} = this;
    if (on && film.time >= film.last) film.seek(0);
    film.playing = on;
    this.before = null;
    if (on) requestAnimationFrame((now) => this.frame(now));
    this.tell();
    if (!on) this.remember();
  }
  frame(now) {
    if (!this.film.playing) return;
    if (this.before !== null) this.film.tick((now - this.before) / 1000);
    this.before = now;
    this.tell();
    if (this.film.playing) requestAnimationFrame((next) => this.frame(next));
  }
  go(time) {
    this.film.playing = false;
    this.film.seek(time);
    this.tell();
  }
  step(count) {
    this.film.playing = false;
    this.film.by(count);
    this.tell();
    this.remember();
    clearTimeout(this.sayLater);
    this.sayLater = setTimeout(() => { by("film-said").textContent = by("time").getAttribute("aria-valuetext"); }, 300);
  }
  setSpeed(speed) {
    this.film.speed = speed;
    by("speed").value = String(speed);
    this.remember();
  }
  faster(steps) {
    this.setSpeed(kSpeeds[Math.max(0, Math.min(kSpeeds.length - 1, kSpeeds.indexOf(this.film.speed) + steps))]);
  }
  tell() {
    const {film} = this, seconds = (v) => v.toFixed(1);
    by("time").value = String(film.time);
    by("clock").textContent = `${seconds(film.time)} of ${seconds(film.lasts)} s`;
    by("time").setAttribute("aria-valuetext", `${seconds(film.time)} of ${seconds(film.lasts)} seconds, step ${film.step() + 1} of ${film.moments.length}`);
    by("step").textContent = `step ${film.step() + 1} of ${film.moments.length}`;
    by("play").setAttribute("aria-label", film.playing ? "Pause" : "Play");
    document.body.classList.toggle("playing", film.playing);
  }
  // t=seconds&x=speed
  remember() {
    const parts = ["t=" + Math.round(this.film.time * 1000) / 1000];
    if (this.film.speed !== 1) parts.push("x=" + this.film.speed);
    try { history.replaceState(null, "", "#" + parts.join("&")); } catch { /* a page without address */ }
  }
  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey || e.target.tagName === "SELECT") return;
    const onButton = e.target.tagName === "BUTTON", many = e.shiftKey ? 10 : 1;
    const does = {ArrowLeft: () => this.step(-many), ArrowRight: () => this.step(many), ArrowUp: () => this.faster(1), ArrowDown: () => this.faster(-1),
      Home: () => this.go(0), End: () => this.go(this.film.last), "+": () => this.lens.zoom(1.25), "=": () => this.lens.zoom(1.25),
      "-": () => this.lens.zoom(0.8), a: () => this.lens.pan(60, 0), d: () => this.lens.pan(-60, 0), w: () => this.lens.pan(0, 60), s: () => this.lens.pan(0, -60),
      0: () => this.lens.fit(), ...(onButton ? {} : {" ": () => this.play(!this.film.playing)})}[e.key];
    if (!does || (!this.film.moves && !"+=-0wasd".includes(e.key))) return;
    e.preventDefault();
    does();
  }
}

// The page as a player: its other parts go.
function beginFilm(page) {
  const read = new DOMParser().parseFromString(page.film, "image/svg+xml"), svg = document.importNode(read.documentElement, true);
  for (const own of svg.querySelectorAll("script, .pause")) own.remove();  // the button that it has where it stands alone
  for (const style of svg.querySelectorAll("style"))  // paper is bright
    style.textContent = style.textContent.replace(/@media *\(prefers-color-scheme: *dark/g, "@media screen and (prefers-color-scheme:dark");
  const title = svg.querySelector("title")?.textContent ?? page.name;
  document.title = title + " – taut";
  by("film-title").textContent = title;
  by("film-title").hidden = false;
  by("film").append(svg);
  by("film").hidden = false;
  for (const id of ["ground", "front", "start", "goal", "panel"]) by(id).remove();
  document.body.classList.add("film");
  window.tautFilm = new Player(svg);
  document.body.dataset.ready = "film";
}
