#include "tessellation/tessellation.h"

#include <stdexcept>
#include <string>

#include "geometry/insertion_order.h"
#include "tessellation/audit.h"
#include "tessellation/change_of_dimension.h"
#include "tessellation/location.h"

namespace thiessen {
namespace {

// Enough for queries; where points keep coming without a hint, there are more signposts.
constexpr std::size_t points_a_signpost_at_first = 32;
constexpr std::size_t points_a_signpost = 8;

}  // namespace

template <int Dimension>
std::vector<PointId> Tessellation<Dimension>::add_all(std::span<const Position> points) {
  structure_.reserve(points.size());
  const std::vector<std::uint32_t> order = insertion_order(points);
  std::vector<PointId> numbers(points.size());
  constexpr std::size_t ahead = 16;  // the order goes across the input: fetch before it is needed
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k + ahead < order.size()) __builtin_prefetch(&points[order[k + ahead]]);
    numbers[order[k]] = insert(points[order[k]], last_);
  }
  if (2 * points.size() < count()) {
    renew_signposts();
    return numbers;
  }
  // The first points in order are a random choice of all.
  std::vector<PointId> sample;
  for (std::size_t k = 0; k < order.size() / points_a_signpost_at_first; ++k) {
    sample.push_back(numbers[order[k]]);
  }
  put_up_signposts(sample);
  return numbers;
}

template <int Dimension>
PointId Tessellation<Dimension>::add(const Position& position, std::optional<PointId> hint) {
  if (!hint) renew_signposts();
  const PointId p = insert(position, start(position, hint));
  expect_sound();
  return p;
}

template <int Dimension>
void Tessellation<Dimension>::remove(PointId p) {
  last_ = deletion_.remove(structure_, p);
  expect_sound();
}

template <int Dimension>
void Tessellation<Dimension>::expect_sound() {
#ifdef THIESSEN_AUDIT
  constexpr std::size_t points_a_change = 200;
  if (++changes_since_audit_ * points_a_change < count()) return;
  changes_since_audit_ = 0;
  for (const auto& finding : audit(*this)) {
    throw std::logic_error("the tessellation is broken: " + std::string(name_of(finding.fault)) +
                           " at vertex " + std::to_string(index(finding.vertex)));
  }
#endif
}

template <int Dimension>
PointId Tessellation<Dimension>::insert(const Position& position, VertexId hint) {
  if (!spans_all() && (empty() || structure_.is_off(position))) {
    const PointId p = structure_.add_point(position);
    raise_dimension(structure_, p);
    last_ = topology().vertex_of(p);
    return p;
  }
  if (topology().dimension() == 0) return topology().forming(structure_.finite_vertex())[0];
  const VertexId first = locate_from(standing(hint), position);
  const PointId there = corner_at(first, position);
  if (there != no_point) {
    last_ = first;
    return there;
  }
  const PointId p = structure_.add_point(position);
  last_ = insertion_.insert(structure_, p, first);
  return p;
}

/// A vertex to walk from: the hint's, a signpost's, or any.
template <int Dimension>
VertexId Tessellation<Dimension>::start(const Position& position,
                                        std::optional<PointId> hint) const {
  if (hint && topology().is_there(*hint)) return topology().vertex_of(*hint);
  if (const auto signpost = signposts_.near(position)) {
    if (topology().is_there(PointId{*signpost})) return topology().vertex_of(PointId{*signpost});
  }
  return standing(last_);
}

/// The vertex, or another where it is gone.
template <int Dimension>
VertexId Tessellation<Dimension>::standing(VertexId v) const {
  const bool stands = index(v) < topology().size() && !topology().is_free(v);
  return stands ? v : topology().vertex_of(infinite_point);
}

template <int Dimension>
VertexId Tessellation<Dimension>::locate_from(VertexId hint, const Position& position) const {
  return at_dimension<Dimension>(topology().dimension(), [&](auto d) {
    return thiessen::locate<d>(structure_, position, hint);
  });
}

template <int Dimension>
PointId Tessellation<Dimension>::corner_at(VertexId v, const Position& position) const {
  for (const PointId p : topology().forming(v)) {
    if (p != no_point && p != infinite_point && structure_.position(p) == position) return p;
  }
  return no_point;
}

template <int Dimension>
VertexId Tessellation<Dimension>::locate(const Position& position,
                                         std::optional<PointId> hint) const {
  return locate_from(start(position, hint), position);
}

template <int Dimension>
std::optional<PointId> Tessellation<Dimension>::find(const Position& position,
                                                     std::optional<PointId> hint) const {
  if (empty() || (!spans_all() && structure_.is_off(position))) return {};
  if (topology().dimension() == 0) return topology().forming(structure_.finite_vertex())[0];
  const PointId there = corner_at(locate(position, hint), position);
  if (there == no_point) return {};
  return there;
}

template <int Dimension>
bool Tessellation<Dimension>::find_conflict_zone(const Position& position,
                                                 std::optional<PointId> hint,
                                                 ConflictZone<Dimension>& zone) const {
  const VertexId first = locate(position, hint);
  if (corner_at(first, position) != no_point) return false;
  at_dimension<Dimension>(topology().dimension(),
                          [&](auto d) { zone.template find<d>(structure_, first, position); });
  return true;
}

template <int Dimension>
std::vector<PointId> Tessellation<Dimension>::along_line() const {
  std::vector<PointId> points;
  if (topology().dimension() == 0)
    points.push_back(topology().forming(structure_.finite_vertex())[0]);
  if (topology().dimension() != 1) return points;
  // The ring begins behind the infinite point.
  VertexId v = topology().vertex_of(infinite_point);
  if (topology().forming(v)[0] != infinite_point) v = topology().neighbour(v, 0);
  while (topology().forming(v)[1] != infinite_point) {
    points.push_back(topology().forming(v)[1]);
    v = topology().neighbour(v, 0);
  }
  return points;
}

template <int Dimension>
void Tessellation<Dimension>::put_up_signposts(std::span<const PointId> sample) {
  std::vector<typename Signposts<Dimension>::Signpost> signposts;
  signposts.reserve(sample.size());
  for (const PointId p : sample) {
    signposts.push_back({structure_.position(p), static_cast<std::uint32_t>(p)});
  }
  signposts_.set(std::move(signposts));
}

// Whenever the points have become many times as many.
template <int Dimension>
void Tessellation<Dimension>::renew_signposts() {
  constexpr std::size_t few = 256;
  if (count() < few || count() < points_a_signpost_at_first * signposts_.size()) return;
  std::vector<PointId> sample;
  std::size_t k = 0;
  for_each_point([&](PointId p) {
    if (k++ % points_a_signpost == 0) sample.push_back(p);
  });
  put_up_signposts(sample);
}

template class Tessellation<2>;
template class Tessellation<3>;

}  // namespace thiessen
