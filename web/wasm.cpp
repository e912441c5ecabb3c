#include <taut/web/page.h>

// The linker takes the files as they are: a compiler would need minutes for them as literals.
#ifdef TAUT_WASM_FOLDER
asm(R"(
  .section .rodata
  .global taut_wasm_glue, taut_wasm_glue_end, taut_wasm_bytes, taut_wasm_bytes_end
taut_wasm_glue: .incbin ")" TAUT_WASM_FOLDER R"(/taut.js"
taut_wasm_glue_end:
taut_wasm_bytes: .incbin ")" TAUT_WASM_FOLDER R"(/taut.wasm.gz"
taut_wasm_bytes_end:
  .previous
)");
extern "C" const char taut_wasm_glue[], taut_wasm_glue_end[], taut_wasm_bytes[], taut_wasm_bytes_end[];
#endif

namespace taut::web {

Wasm embedded_wasm() {
#ifdef TAUT_WASM_FOLDER
  return {{taut_wasm_glue, taut_wasm_glue_end}, {taut_wasm_bytes, taut_wasm_bytes_end}};
#else
  return {};
#endif
}

}  // namespace taut::web
