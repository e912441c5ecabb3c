#include <taut/io/results/path_certificate_text.h>

#include <cstdint>
#include <span>

namespace taut {

namespace {

// FNV-1a with 64 bits, of all lines but those of the ends.
std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n') + 1);
    text.remove_prefix(line.size());
    if (line.starts_with("start ") || line.starts_with("goal ")) continue;
    for (const char c : line) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(hash >> shift) & 15];
  return digits;
}

std::string row(std::span<const std::int64_t> numbers) {
  std::string out = "[";
  for (const std::int64_t n : numbers) {
    if (out.size() > 1) out += ", ";
    out += std::to_string(n);
  }
  return out + "]";
}

template <class Rows>
void append(std::string& out, const char* name, const Rows& rows) {
  out.append(",\n\"").append(name).append("\": [");
  const char* comma = "\n";
  for (const auto& numbers : rows) {
    out.append(comma).append(row(numbers));
    comma = ",\n";
  }
  out += "]";
}

}  // namespace

std::string certificate_text(const PathCertificate& certificate, std::string_view world_text) {
  std::string out = "{\n\"format\": \"taut certificate 1\",\n\"kind\": ";
  out += certificate.is_found ? "\"shortest\"" : "\"none\"";
  out += ",\n\"world\": \"" + fingerprint(world_text) + "\"";
  out += ",\n\"scale\": " + std::to_string(certificate.scale);
  out += ",\n\"fraction_bits\": " + std::to_string(certificate.fraction_bits);
  out += ",\n\"horizon\": " + std::to_string(certificate.horizon);
  append(out, "path", certificate.path);
  append(out, "potentials", certificate.potentials);
  return out + "\n}\n";
}

}  // namespace taut
