"use strict";
// The page: what is shown where, and what is asked when.

const by = (id) => document.getElementById(id);
const kPage = JSON.parse(by("taut-page").textContent);
const short = (v) => String(Number(v.toPrecision(6)));

class App {
  constructor(ask, world) {
    this.planner = ask;
    this.world = world;
    this.model = new Model(world);
    this.sheet = new Sheet(by("ground"), by("front"));
    this.sheet.yDown = world.y_down;
    this.layers = {};
    this.shown = new Set(["walls"]);
    this.paths = new Newest((request) => this.path(request));
    this.regions = new Newest((request) => this.region(request));
    this.tools = new Tools(this);
    this.panel();
    this.sheet.resize();
    this.sheet.fit(world.box);
  }

  // ---- numbers ----------------------------------------------------------------------------------------------------
  step() {
    const size = 10 ** Math.floor(Math.log10(Math.max(this.sheet.pixels(24), 1e-300)));
    return this.sheet.pixels(24) / size > 5 ? 5 * size : this.sheet.pixels(24) / size > 2 ? 2 * size : size;
  }
  // Numbers as people write them: no more digits than a pixel shows.
  rounded(p) {
    const places = Math.max(0, Math.min(15, Math.ceil(-Math.log10(this.sheet.pixels(1)))));
    return p.map((v) => Number(v.toFixed(places)));
  }
  tidy(numbers) { return numbers.map((v) => Number(v.toPrecision(12))); }
  snapped(p) {
    if (!by("snap").checked) return this.rounded(p);
    const near = this.nearEnd(p);
    if (near) return near;
    const step = this.step() / 2;
    return this.tidy(p.map((v) => Math.round(v / step) * step));
  }
  nearEnd(p) {
    const walls = this.model.walls;
    let best = null, least = this.sheet.pixels(12);
    for (let i = 0; i < walls.length; i += 5) for (const k of [0, 2]) {
      const d = Math.hypot(walls[i + k] - p[0], walls[i + k + 1] - p[1]);
      if (d < least) [least, best] = [d, [walls[i + k], walls[i + k + 1]]];
    }
    return best;
  }
  words(p) { return `(${p.map(short).join(", ")})`; }
  thickness() { return this.model.walls.length ? this.model.walls[this.model.walls.length - 1] : 0; }

  // ---- asking -----------------------------------------------------------------------------------------------------
  request(what, more = {}) { return {do: what, ...this.model.query(), ...more}; }
  askPath() {
    const radius = this.model.radius;
    this.paths.ask(this.request("path", radius ? {radius} : {digits: this.digits()}));
    if (this.shown.has("region")) this.regions.ask(this.request("layer", {name: "region"}));
  }
  digits() { return Math.max(0, Math.min(1000, Math.floor(Number(by("digits").value) || 0))); }
  async path(request) {
    const begun = performance.now(), answer = await this.planner.ask(request);
    this.answer = answer;
    this.took = performance.now() - begun;
    this.drawFront();
    this.tell(answer, request);
  }
  async region(request) {
    this.layers.region = await this.planner.ask(request);
    this.drawGround();
  }
  async askWidest() {
    const answer = await this.planner.ask(this.request("widest"));
    this.widest = answer.status === "found" ? answer.radius ?? Infinity : 0;
    const why = (answer.limit === "gate" ? "narrowest: " : "") + (answer.text ?? "");
    by("widest").textContent = answer.status !== "found" ? "" : `At most ${short(this.widest)} passes; ${why}`;
    by("set-widest").disabled = !(this.widest > 0 && Number.isFinite(this.widest));
    const box = this.world.box, most = Math.min(this.widest * 1.25, (box[2] - box[0] + box[3] - box[1]) / 4);
    by("radius").max = String(most || 1);
    by("radius").step = String((most || 1) / 250);
    by("radius").value = String(this.model.radius);
  }
  async askLayer(name) {
    if (name === "walls" || this.layers[name]) return;
    const answer = await this.planner.ask(this.request("layer", {name}));
    if (answer.error) by("layer-note").textContent = answer.error; else this.layers[name] = answer;
    this.drawGround();
  }
  async askLayers() {
    by("layer-note").textContent = "";
    await Promise.all([...this.shown].map((name) => this.askLayer(name)));
  }

  // ---- changing ---------------------------------------------------------------------------------------------------
  endOf(which) {
    if (this.model[which]) return this.model[which];
    const room = this.world.room[0];
    return which === "goal" && room ? [(room[0] + room[2]) / 2, (room[1] + room[3]) / 2] : [0, 0];
  }
  moveEnd(which, p) {
    this.model[which] = p;
    this.drawHandles();
    this.askPath();
  }
  settled() {
    this.remember();
    this.askWidest();
    this.buttons();
  }
  async setWalls(walls, marked = false) {
    if (!marked) this.model.mark();
    const answer = await this.planner.ask({do: "edit", walls});
    if (answer.error) { this.complain(answer.error); return false; }
    this.model.walls = walls;
    this.took_in(answer);
    return true;
  }
  took_in(world) {
    this.world = {...world, ends: this.model.first.ends};
    this.layers = {};
    this.askPath();
    this.askLayers().then(() => this.drawGround());
    this.drawGround();
    this.settled();
    this.describe();
    this.formats();
  }
  async travel(step) {
    const walls = this.model.walls;
    if (!this.model[step]()) return;
    if (this.model.walls !== walls) await this.setWalls(this.model.walls, true);
    this.showRadius();
    this.drawGround();
    this.drawHandles();
    this.askPath();
    this.settled();
    this.say(step === "undo" ? "undone" : "redone");
  }
  setRadius(radius) {
    if (!(radius >= 0) || !Number.isFinite(radius)) return;
    this.model.radius = radius;
    this.showRadius();
    this.drawGround();
    this.askPath();
  }
  showRadius() {
    by("radius").value = String(this.model.radius);
    by("radius-number").value = String(Number(this.model.radius.toPrecision(6)));
  }

  // ---- showing ----------------------------------------------------------------------------------------------------
  drawGround() {
    this.groundWanted ??= requestAnimationFrame(() => {
      this.groundWanted = null;
      this.sheet.drawGround(this.model, this.world, this.layers, this.shown);
    });
  }
  drawFront() {
    this.frontWanted ??= requestAnimationFrame(() => {
      this.frontWanted = null;
      this.sheet.drawFront(this.model, this.answer, this.tools.draft);
    });
  }
  drawHandles() {
    for (const which of ["start", "goal"]) {
      const [x, y] = this.sheet.toScreen(this.endOf(which)), handle = by(which);
      handle.style.transform = `translate(${x}px, ${y}px)`;
      handle.setAttribute("aria-label", `${which === "start" ? "Start" : "Goal"} at ${this.words(this.endOf(which))}; arrow keys move it`);
      handle.classList.toggle("blocked", this.answer?.status === "blocked" && this.answer.end === which);
      handle.hidden = which === "start" ? !this.model.start : !this.model.goal && !this.world.room.length;
    }
  }
  viewChanged() {
    this.drawGround();
    this.drawFront();
    this.drawHandles();
    this.moved = true;
    clearTimeout(this.rememberLater);
    this.rememberLater = setTimeout(() => this.remember(), 250);
  }
  tell(answer, request) {
    const none = answer.status !== "found";
    by("answer").classList.toggle("none", none);
    const heading = by("length"), head = {none: "No path", blocked: "No place for it", unproven: "Not proven"};
    heading.textContent = none ? head[answer.status] ?? "No answer" : answer.digits ?? answer.length.toFixed(Math.min(this.digits(), 12));
    heading.classList.toggle("long", heading.textContent.length > 16);
    by("more").textContent = none ? this.reason(answer) : this.claim(answer, request);
    this.drawHandles();
    clearTimeout(this.sayLater);
    this.sayLater = setTimeout(() => this.say(`${none ? head[answer.status] ?? "No answer" : "Length " + heading.textContent}. ${by("more").textContent}`), 400);
  }
  reason(answer) {
    const text = answer.reason ?? answer.error ?? "";
    return text.charAt(0).toUpperCase() + text.slice(1) + (text ? "." : "");
  }
  claim(answer, request) {
    const corners = `${answer.corners} ${answer.corners === 1 ? "corner" : "corners"}`;
    if (request.radius) return `${corners}. Shortest for the disc; its length is known to within ${answer.width.toPrecision(1)}.`;
    if (answer.within) return `${corners}. Shortest to within ${answer.within.toPrecision(2)}: crossings of walls were rounded.`;
    return `${corners}. Proven shortest; every digit is exact, the last one rounded.`;
  }
  say(text) { by("said").textContent = text; }
  hint(text) {
    by("hint").hidden = !text;
    by("hint").textContent = text;
  }
  complain(text) {
    this.hint(text);
    this.say(text);
    clearTimeout(this.hintLater);
    this.hintLater = setTimeout(() => this.tools.choose(this.tools.tool), 4000);
  }
  describe() {
    const name = (kPage.name || "world").split("/").pop(), walls = this.model.wallCount(), solids = this.world.solids.length;
    document.title = name + " – taut";
    by("title").textContent = name;
    const box = this.world.box, facts = [`${short(box[2] - box[0])} × ${short(box[3] - box[1])}`];
    if (walls || !solids) facts.push(`${walls.toLocaleString("en")} ${walls === 1 ? "wall" : "walls"}`);
    if (solids) facts.push(`${solids.toLocaleString("en")} ${solids === 1 ? "solid" : "solids"}`);
    by("facts").textContent = facts.join(", ") + (this.model.edited ? ", edited" : "");
    by("front").setAttribute("aria-label", `Map of ${name}: ${by("facts").textContent}`);
  }
  buttons() {
    by("undo").disabled = !this.model.past.length;
    by("redo").disabled = !this.model.future.length;
  }
  remember() {
    const view = this.moved ? [...this.sheet.centre, this.sheet.scale] : null;
    try { history.replaceState(null, "", addressOf(this.model, [...this.shown], view, this.digits())); } catch { /* too long, or a page without address */ }
  }
  async recall() {
    const found = readAddress();
    this.model.start = pointOf(found.s) ?? this.model.start;
    this.model.goal = pointOf(found.g) ?? this.model.goal;
    this.model.radius = Math.max(0, Number(found.r) || 0);
    if (found.d) by("digits").value = String(Math.floor(Number(found.d)) || 6);
    if (found.l !== undefined) this.shown = new Set(found.l.split(".").filter(Boolean));
    for (const box of document.querySelectorAll("[data-layer]")) box.checked = this.shown.has(box.dataset.layer);
    const view = (found.v ?? "").split(",").map(Number);
    if (view.length === 3 && view.every(Number.isFinite) && view[2] > 0) {
      this.sheet.centre = view.slice(0, 2);
      this.sheet.scale = view[2];
      this.moved = true;
    }
    if (found.w) await this.setWalls(this.model.applied(found.w.split(";")), true);
    this.showRadius();
  }

  // ---- the panel --------------------------------------------------------------------------------------------------
  panel() {
    for (const begin of ["pointerdown", "keydown"]) by("radius").addEventListener(begin, () => this.model.mark());
    by("set-widest").addEventListener("click", () => {
      this.model.mark();
      this.setRadius(this.widest);
      this.settled();
    });
    by("radius").addEventListener("input", () => this.setRadius(Number(by("radius").value)));
    by("radius").addEventListener("change", () => this.settled());
    by("radius-number").addEventListener("change", () => {
      this.model.mark();
      this.setRadius(Number(by("radius-number").value));
      this.settled();
    });
    by("digits").addEventListener("input", () => { this.askPath(); this.remember(); });
    for (const box of document.querySelectorAll("[data-layer]")) box.addEventListener("change", () => {
      if (box.checked) this.shown.add(box.dataset.layer); else this.shown.delete(box.dataset.layer);
      this.askLayers().then(() => this.drawGround());
      this.drawGround();
      this.remember();
    });
    by("undo").addEventListener("click", () => this.travel("undo"));
    by("redo").addEventListener("click", () => this.travel("redo"));
    by("save").addEventListener("click", () => this.save());
    by("link").addEventListener("click", () => { this.remember(); this.copy(location.href, by("link")); });
    by("copy-length").addEventListener("click", () => this.copy(by("length").textContent, by("copy-length")));
    by("zoom-in").addEventListener("click", () => { this.sheet.zoom(1.5); this.viewChanged(); });
    by("zoom-out").addEventListener("click", () => { this.sheet.zoom(1 / 1.5); this.viewChanged(); });
    by("zoom-fit").addEventListener("click", () => this.fit());
    document.addEventListener("keydown", (e) => this.key(e));
    window.addEventListener("resize", () => { this.sheet.resize(); this.viewChangedQuietly(); });
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { this.sheet.readColours(); this.viewChangedQuietly(); });
    window.addEventListener("beforeprint", () => this.print());
  }
  // What is seen, in the colours of paper, at once: no frame is drawn before the printer's.
  print() {
    const paper = new Sheet(by("paper"), document.createElement("canvas"));
    paper.showLike(this.sheet, 3);
    paper.drawGround(this.model, this.world, this.layers, this.shown);
    paper.drawFront(this.model, this.answer, null);
    const context = paper.ground.getContext("2d");
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(paper.front, 0, 0);
    context.restore();
    paper.drawEnds(this.model.start, this.model.goal ?? (this.world.room.length ? this.endOf("goal") : null));
  }
  viewChangedQuietly() {
    if (!this.moved) this.sheet.fit(this.world.box);
    this.drawGround();
    this.drawFront();
    this.drawHandles();
  }
  fit() {
    this.sheet.fit(this.world.box);
    this.viewChanged();
    this.moved = false;
  }
  key(e) {
    if (/INPUT|SELECT|TEXTAREA/.test(e.target.tagName) && e.target.type !== "checkbox" && e.target.type !== "range") return;
    const tools = {v: "look", w: "draw", m: "move", x: "erase"}, key = e.key.toLowerCase();
    if ((e.ctrlKey || e.metaKey) && key === "z") { e.preventDefault(); this.travel(e.shiftKey ? "redo" : "undo"); return; }
    if ((e.ctrlKey || e.metaKey) && key === "y") { e.preventDefault(); this.travel("redo"); return; }
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (tools[key] && this.planner.name !== "still") this.tools.choose(tools[key]);
    else if (key === "escape") this.tools.drop();
    else if (key === "+" || key === "=") { this.sheet.zoom(1.25); this.viewChanged(); }
    else if (key === "-") { this.sheet.zoom(0.8); this.viewChanged(); }
    else if (key === "0") this.fit();
  }
  async copy(text, button) {
    const label = button.textContent;
    try { await navigator.clipboard.writeText(text); button.textContent = "Copied"; }
    catch { button.textContent = "No clipboard"; }
    setTimeout(() => { button.textContent = label; }, 1200);
  }
  async formats() {
    const answer = await this.planner.ask({do: "formats"}), chosen = by("format").value;
    by("format").replaceChildren(...[...(answer.formats ?? []), "png"].map((name) => new Option(name, name, false, name === chosen)));
  }
  async save() {
    const as = by("format").value;
    if (as === "png") {
      this.print();
      by("paper").toBlob((bytes) => this.download(bytes, "png"));
      return;
    }
    const answer = await this.planner.ask(this.request("save", {as}));
    if (answer.error) { this.complain(answer.error); return; }
    const ending = {segments: "txt", drawing: "txt", cells: "cells", blocks: "txt", movingai: "map", integers: "json"}[as] ?? as;
    this.download(new Blob([answer.base64 ? bytesOf(answer.base64) : answer.text]), ending);
  }
  download(bytes, ending) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(bytes);
    link.download = `${by("title").textContent.replace(/\.[a-z]+$/i, "")}.${ending}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
  introduce() {
    const who = {wasm: "The planner runs in this page, as WebAssembly; it passed its exactness test. Nothing leaves this machine.",
      server: "The program taut answers, on this machine.",
      still: this.planner.why ? "A picture of what the program found: the planner in this page does not run here." : "A picture: this page was written without the planner, so it shows what the program found and nothing more. <code>taut view --serve</code> answers live."};
    by("planner").innerHTML = who[this.planner.name];
    if (this.planner.why) by("planner").append(" (" + this.planner.why + ")");
    document.body.classList.toggle("still", this.planner.name === "still");
    if (this.planner.name !== "still") return;
    for (const box of document.querySelectorAll("[data-layer]")) box.disabled = box.dataset.layer !== "walls" && !this.planner.still.layers?.[box.dataset.layer];
  }
}

async function begin() {
  window.addEventListener("hashchange", () => location.reload());  // a link was put in the place of this one
  if (kPage.film) { beginFilm(kPage); return; }
  const ask = await planner(kPage), world = await ask.ask(kPage.load);
  if (world.error) {
    by("length").textContent = "Cannot be read";
    by("more").textContent = world.error;
    return;
  }
  const app = new App(ask, world);
  window.tautApp = app;
  app.introduce();
  await app.recall();
  app.describe();
  app.buttons();
  app.viewChangedQuietly();
  app.askPath();
  if (ask.name === "still") { app.askLayers(); } else { app.formats(); app.askWidest(); app.askLayers().then(() => app.drawGround()); }
  document.body.dataset.ready = ask.name;
}

begin();
