#include <taut/web/page.h>

#include <taut/web/detail/request.h>

namespace taut::web {

namespace {

/// Where HTML is concerned a script ends at the next `</`, and is hidden by a `<!--`.
std::string in_script(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) out += c == '<' ? "\\u003c" : std::string(1, c);
  return out;
}

}  // namespace

std::string page(std::string_view json, const Wasm& wasm) {
  std::string text;
  std::string_view rest = page_template();
  const auto fill = [&](std::string_view mark, const std::string& with) {
    const std::size_t at = rest.find(mark);
    text.append(rest.substr(0, at)).append(with);
    rest.remove_prefix(at + mark.size());
  };
  fill("@taut_page@", in_script(json));
  fill("@taut_glue@", std::string(wasm.glue));
  fill("@taut_wasm@", to_base64(wasm.bytes));
  return text.append(rest);
}

}  // namespace taut::web
