// The page of `taut view`: one file that needs nothing else.
#pragma once

#include <string>
#include <string_view>

namespace taut::web {

/// web/page/ in one, with `@taut_page@`, `@taut_glue@` and `@taut_wasm@` where something goes in.
std::string_view page_template();

/// The planner as WebAssembly, for use in a browser; empty where the program was built without.
struct Wasm {
  /// JavaScript, evaluated in a worker: defines `self.tautReady(bytes)`, a promise of the function that answers as
  /// Session does, text in, text out.
  std::string_view glue;
  std::string_view bytes;  ///< of taut.wasm, packed by gzip
};

Wasm embedded_wasm();

/// The page with this in it: JSON with `name`, `load` (the request that loads the world), and what of these there is:
/// `still` (answers of a Session: `world`, `path`, `widest`, and in `layers` by name), `server` (where to ask instead).
/// With the planner `wasm` where it has bytes. Or JSON with `name` and `film`, an SVG: the page plays it.
std::string page(std::string_view json, const Wasm& wasm);

}  // namespace taut::web
