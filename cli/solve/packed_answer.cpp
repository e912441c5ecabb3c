#include <taut/cli/solve/packed_answer.h>

namespace taut::cli {

namespace {

void pack(const FreePlace& place, Packer& packer) {
  packer.put(place.point).put(place.distance).put(place.rounding).put(std::uint64_t{place.constraint});
}

FreePlace unpacked_place(Unpacker& unpacker) {
  FreePlace place;
  place.point = unpacker.point();
  place.distance = unpacker.real();
  place.rounding = unpacker.real();
  place.constraint = static_cast<std::uint32_t>(unpacker.number());
  return place;
}

/// The words for an end, which live for ever.
const char* role_of(std::uint64_t number) { return number == 0 ? "" : number == 1 ? "start" : "goal"; }

std::uint64_t number_of_role(std::string_view role) { return role.empty() ? 0U : role == "start" ? 1U : 2U; }

}  // namespace

std::string text_of(std::span<const QueryLine> queries) {
  Packer packer;
  for (const QueryLine& query : queries) {
    packer.put(query.from).put(query.to).put(query.map).put(query.tolerance);
    packer.put(static_cast<std::uint64_t>(query.line)).put(std::uint64_t{query.expects});
    packer.put(std::uint64_t{query.expected.has_value()}).put(query.expected.value_or(0));
  }
  return std::move(packer).bytes();
}

void pack(const QueryAnswer& answer, Packer& packer) {
  packer.put(static_cast<std::uint64_t>(answer.status)).put(answer.length).put(answer.cpu);
  packer.put(number_of_role(answer.blocked)).put(std::uint64_t{answer.nearest.has_value()});
  if (answer.nearest) pack(*answer.nearest, packer);
  packer.put(std::uint64_t{answer.moves.size()});
  for (const EndMove& move : answer.moves) {
    packer.put(number_of_role(move.role)).put(move.given);
    pack(move.place, packer);
  }
  packer.put(std::uint64_t{answer.points.size()});
  for (const Point p : answer.points) packer.put(p);
}

QueryAnswer unpacked_answer(Unpacker& unpacker) {
  QueryAnswer answer;
  answer.status = static_cast<QueryAnswer::Status>(unpacker.number() % 4);
  answer.length = unpacker.real();
  answer.cpu = unpacker.real();
  answer.blocked = role_of(unpacker.number());
  if (unpacker.number() != 0) answer.nearest = unpacked_place(unpacker);
  for (std::uint64_t left = unpacker.number(); left > 0; --left) {
    const char* const role = role_of(unpacker.number());
    const Point given = unpacker.point();
    answer.moves.push_back({role, given, unpacked_place(unpacker)});
  }
  for (std::uint64_t left = unpacker.number(); left > 0; --left) answer.points.push_back(unpacker.point());
  return answer;
}

}  // namespace taut::cli
