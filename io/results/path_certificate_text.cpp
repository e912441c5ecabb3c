#include <taut/io/results/path_certificate_text.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include <taut/geometry/text.h>

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

std::string heading(const char* kind, std::string_view world_text, std::int64_t scale) {
  std::string out = "{\n\"format\": \"taut certificate 1\",\n\"kind\": \"";
  out.append(kind).append("\",\n\"world\": \"").append(fingerprint(world_text)).append("\"");
  return out + ",\n\"scale\": " + std::to_string(scale);
}

}  // namespace

std::string certificate_text(const DiscCertificate& certificate, std::string_view world_text,
                             const std::array<Point, 2>& ends) {
  std::string out = heading(certificate.is_found ? "widest" : "none", world_text, certificate.scale);
  out += ",\n\"ends\": [[";
  append(out, ends[0].x);
  append(out += ", ", ends[0].y);
  append(out += "], [", ends[1].x);
  append(out += ", ", ends[1].y);
  out += "]],\n\"width\": " + std::to_string(certificate.width);
  if (certificate.is_found) out += ",\n\"keeps\": " + std::to_string(certificate.keeps);
  const std::span path(certificate.path);
  append(out, "goal", path.last(std::min<std::size_t>(1, path.size())));
  append(out, "path", path);
  append(out, "chain", certificate.chain);
  return out + "\n}\n";
}

std::vector<std::string> certificates_in(std::string_view bytes) {
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  if (!json.is_array()) return {std::string(bytes)};
  std::vector<std::string> texts;
  for (const auto& item : json) texts.push_back(item.dump());
  return texts;
}

std::optional<std::array<Point, 2>> disc_ends(std::string_view certificate) {
  const auto json = nlohmann::json::parse(certificate, nullptr, false);
  if (!json.is_object() || !json.contains("chain") || !json.contains("ends")) return std::nullopt;
  try {
    const auto ends = json["ends"].get<std::array<std::array<double, 2>, 2>>();
    return std::array{Point{ends[0][0], ends[0][1]}, Point{ends[1][0], ends[1][1]}};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::string certificate_text(const PathCertificate& certificate, std::string_view world_text) {
  std::string out = heading(certificate.is_found ? "shortest" : "none", world_text, certificate.scale);
  out += ",\n\"fraction_bits\": " + std::to_string(certificate.fraction_bits);
  out += ",\n\"horizon\": " + std::to_string(certificate.horizon);
  if (certificate.is_found) out += ",\n\"reach\": " + std::to_string(certificate.reach);
  append(out, "goal", certificate.goal);
  append(out, "path", certificate.path);
  append(out, "potentials", certificate.potentials);
  return out + "\n}\n";
}

}  // namespace taut
