#include <taut/cli/solve/batch_proofs.h>

#include <array>

#include <taut/geometry/errors.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/search/disc_certificate.h>
#include <taut/search/disc_passage.h>
#include <taut/search/disc_worlds.h>
#include <taut/search/path_certificate.h>

namespace taut::cli {

namespace {

void append(std::string& list, int line, const std::string& text) {
  list += list.empty() ? "" : ",\n";
  list += "{\n\"line\": " + std::to_string(line) + "," + text.substr(1, text.size() - 2);
}

std::string list_of(const std::string& certificates) { return "[\n" + certificates + "\n]\n"; }

}  // namespace

BatchProofs::BatchProofs(const FreeSpace& space)
    : plain_(is_plain(space.world(), space.footprint()) ? space : FreeSpace(plain_world(space))),
      graph_(plain_),
      world_(write_plain_integers(plain_.world())) {}

void BatchProofs::add(int line, const std::optional<Path>& path, Point from, Point to) {
  std::optional<PathCertificate> proof;
  try {
    const Goal goal{to, {}};
    proof = path ? shortest_certificate(graph_, *path, goal) : none_certificate(graph_, from, goal);
  } catch (const InputError&) {  // ends too fine for the world's lattice
  }
  missing_ += !proof;
  if (proof) append(proofs_, line, certificate_text(*proof, world_));
}

std::string BatchProofs::text() const { return list_of(proofs_); }

void DiscProofs::add(int line, const std::string& text) {
  missing_ += text.empty();
  if (!text.empty()) append(proofs_, line, text);
}

void DiscProofs::add_arcs(int line, const ArcPath& path) try {
  const std::array ends{path.start, path.goal};
  if (!texts_ || path.radius != radius_ || !is_plain(world_)) {
    prover_.emplace(disc_ground(world_, path.start, path.goal), path.radius);
    texts_ = arc_texts(world_, path.radius, ends);
    radius_ = path.radius;
  }
  const auto proof = prover_->certificate(path);
  add(line, proof ? certificate_text(*proof, *texts_) : "");
} catch (const InputError&) {  // numbers too fine for the world's lattice
  texts_.reset();
  add(line, "");
}

void DiscProofs::add_none(int line, Point from, Point to, double radius) try {
  const Gates gates(FreeSpace(walled_world(world_, {from, to})));
  const DiscPassage passage = disc_passage(gates, from, to, radius);
  const auto proof = passage.status == DiscStatus::none ? narrow_certificate(gates, passage, from, to, radius)
                                                        : std::optional<DiscCertificate>();
  const std::string text = write_plain_integers(plain_world(gates.space()));
  add(line, proof ? certificate_text(*proof, text, {from, to}) : "");
} catch (const InputError&) {
  add(line, "");
}

std::string DiscProofs::text() const { return list_of(proofs_); }

}  // namespace taut::cli
