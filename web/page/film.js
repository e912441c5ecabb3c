"use strict";
// Plays what a robot or a search did, step by step: `frames`, each with what changed. A frame may hold
//   points (flat: a trail that grows), at (where the robot is), cells ([colour, x, y, w, h ...], flat boxes), text.

class Film {
  constructor(app, film) {
    this.app = app;
    this.film = film;
    this.step = 0;
    this.playing = null;
    const by = (id) => document.getElementById(id);
    this.slider = by("film-at");
    this.button = by("film-play");
    by("film").hidden = false;
    by("film-title").textContent = film.title;
    this.slider.max = String(film.frames.length - 1);
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    by("film-back").addEventListener("click", () => this.show(this.step - 1));
    by("film-next").addEventListener("click", () => this.show(this.step + 1));
    this.button.addEventListener("click", () => this.toggle());
    this.speed = by("film-speed");
    this.show(0);
  }
  show(step) {
    this.step = Math.max(0, Math.min(this.film.frames.length - 1, step));
    this.slider.value = String(this.step);
    const text = this.film.frames[this.step].text ?? "";
    document.getElementById("film-text").textContent = `${this.step} of ${this.film.frames.length - 1}${text ? ": " + text : ""}`;
    this.slider.setAttribute("aria-valuetext", document.getElementById("film-text").textContent);
    this.app.drawFront();
  }
  toggle() {
    if (this.playing) { this.pause(); return; }
    if (this.step === this.film.frames.length - 1) this.show(0);
    this.button.textContent = "Pause";
    let last = performance.now(), due = 0;
    const tick = (now) => {
      due += (now - last) * 0.01 * Number(this.speed.value) * (this.film.rate ?? 1);
      last = now;
      const whole = Math.floor(due);
      due -= whole;
      if (whole) this.show(this.step + whole);
      if (this.step < this.film.frames.length - 1) this.playing = requestAnimationFrame(tick); else this.pause();
    };
    this.playing = requestAnimationFrame(tick);
  }
  pause() {
    cancelAnimationFrame(this.playing);
    this.playing = null;
    this.button.textContent = "Play";
  }
  draw(context, sheet) {
    for (let i = 0; i <= this.step; ++i) this.cells(context, sheet, this.film.frames[i].cells ?? []);
    this.film.actors.forEach((actor, k) => {
      const trail = [];
      for (let i = 0; i <= this.step; ++i) trail.push(...(this.film.frames[i].trails?.[k] ?? []));
      sheet.ink(context, k ? "accent" : "path", 2.5);
      sheet.line(context, trail);
      context.stroke();
      if (trail.length) this.actor(context, sheet, trail.slice(-2), k);
    });
  }
  cells(context, sheet, flat) {
    context.globalAlpha = 0.35;
    for (let i = 0; i < flat.length; i += 5) {
      context.fillStyle = sheet.colour[["mesh", "voronoi", "gate", "path"][flat[i]] ?? "mesh"];
      context.fillRect(...sheet.at(flat[i + 1], flat[i + 2]), flat[i + 3], flat[i + 4]);
    }
    context.globalAlpha = 1;
  }
  actor(context, sheet, at, k) {
    context.beginPath();
    context.arc(...sheet.at(...at), Math.max(sheet.pixels(6), 0), 0, 2 * Math.PI);
    context.fillStyle = sheet.colour[k ? "accent" : "path"];
    context.fill();
  }
}
