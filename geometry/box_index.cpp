#include <taut/geometry/box_index.h>

#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <utility>

namespace taut {

namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostBox = bg::model::box<BoostPoint>;
using Entry = std::pair<BoostBox, std::uint32_t>;

constexpr std::size_t kFew = 16;

BoostBox boost_box(const Box& b) { return {{b.min.x, b.min.y}, {b.max.x, b.max.y}}; }

bool meet(const Box& s, const Box& t) {
  return s.min.x <= t.max.x && t.min.x <= s.max.x && s.min.y <= t.max.y && t.min.y <= s.max.y;
}

}  // namespace

struct BoxIndex::Tree {
  bg::index::rtree<Entry, bg::index::linear<16>> boxes;
};

BoxIndex::BoxIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.size() <= kFew) return;
  std::vector<Entry> entries;
  entries.reserve(boxes_.size());
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) entries.emplace_back(boost_box(boxes_[i]), i);
  tree_ = std::make_unique<Tree>(Tree{decltype(Tree::boxes)(entries)});
}

BoxIndex::~BoxIndex() = default;
BoxIndex::BoxIndex(BoxIndex&&) noexcept = default;
BoxIndex& BoxIndex::operator=(BoxIndex&&) noexcept = default;

void BoxIndex::query(const Box& box, void* to, void (*call)(void*, std::uint32_t)) const {
  if (tree_) {
    const auto visit = [&](const Entry& entry) { call(to, entry.second); };
    tree_->boxes.query(bg::index::intersects(boost_box(box)), boost::make_function_output_iterator(visit));
    return;
  }
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    if (meet(boxes_[i], box)) call(to, i);
}

}  // namespace taut
