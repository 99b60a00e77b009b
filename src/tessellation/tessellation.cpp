#include "tessellation/tessellation.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "base/interrupt.h"
#include "geometry/coordinates.h"
#include "geometry/insertion_order.h"
#include "tessellation/audit.h"
#include "tessellation/change_of_dimension.h"
#include "tessellation/location.h"

namespace thiessen {
namespace {

// One signpost for 32 points is enough for queries. Where points keep coming without a hint, walks
// are more frequent and there is one for 8.
constexpr std::size_t points_a_signpost_at_first = 32;
constexpr std::size_t points_a_signpost = 8;

}  // namespace

template <int Dimension>
std::vector<PointId> Tessellation<Dimension>::add_all(std::span<const Position> points) {
  const bool few = 2 * points.size() < count();
  structure_.reserve(points.size());
  const std::vector<std::uint32_t> order = insertion_order(points);
  std::vector<PointId> numbers(points.size());
  // The order jumps about in the input, and a jump in many megabytes costs as much as a half of
  // what is done with a point, unless nothing else is done until many have been asked for.
  constexpr std::size_t batch = 512;
  std::array<Position, batch> positions;
  std::array<PointId, batch> given;
  for (std::size_t k = 0; k < order.size(); k += batch) {
    const std::span<const std::uint32_t> places =
        std::span(order).subspan(k, std::min(batch, order.size() - k));
    for (std::size_t i = 0; i < places.size(); ++i) positions[i] = points[places[i]];
    for (std::size_t i = 0; i < places.size(); ++i) {
      throw_if_interrupted();
      given[i] = insert(positions[i], few ? start(positions[i], {}) : last_);
    }
    for (std::size_t i = 0; i < places.size(); ++i) numbers[places[i]] = given[i];
  }
  note_changes(points.size());
  if (few) {
    renew_signposts(points_a_signpost);
  } else if (!is_tried()) {
    // The points inserted first are a random sample of all, so they make good signposts.
    std::vector<PointId> sample;
    for (std::size_t k = 0; k < order.size() / points_a_signpost_at_first; ++k) {
      sample.push_back(numbers[order[k]]);
    }
    put_up_signposts(sample);
  }
  return numbers;
}

template <int Dimension>
PointId Tessellation<Dimension>::add(const Position& position, std::optional<PointId> hint) {
  if (!hint) renew_signposts(points_a_signpost);
  const PointId p = insert(position, start(position, hint));
  note_changes(1);
  renew_signposts(points_a_signpost_at_first);
  return p;
}

template <int Dimension>
void Tessellation<Dimension>::remove(PointId p) {
  if (!is_there(p)) throw std::logic_error("a point is deleted that is not there");
  last_ = deletion_.remove(structure_, p);
  note_changes(1);
  renew_signposts(points_a_signpost_at_first);
}

template <int Dimension>
void Tessellation<Dimension>::exchange(Changes& changes,
                                       const typename Structure<Dimension>::Extent& first,
                                       const typename Structure<Dimension>::Extent& end,
                                       Moment& then, bool backward) {
  structure_.exchange(changes, first, end, then.state, backward);
  std::swap(last_, then.last);
  note_changes(1);
}

template <int Dimension>
std::optional<std::size_t> Tessellation<Dimension>::arrange(
    std::span<const ArrangedVertex<Dimension>> vertices) {
  const auto unfit = arrange_vertices<Dimension>(structure_, vertices);
  last_ = no_vertex;
  note_changes(count());
  return unfit;
}

template <int Dimension>
void Tessellation<Dimension>::note_changes(std::size_t changes) {
  if (!is_tried()) changes_since_signposts_ += changes;
#ifdef THIESSEN_AUDIT
  constexpr std::size_t points_a_change = 200;
  changes_since_audit_ += changes;
  if (changes_since_audit_ * points_a_change < count()) return;
  changes_since_audit_ = 0;
  try {
    for (const auto& finding : audit(*this)) {
      throw std::logic_error("the tessellation is broken: " + std::string(name_of(finding.fault)) +
                             " at vertex " + std::to_string(index(finding.vertex)));
    }
  } catch (const Interrupted&) {
    // What is changed here may be a change that is taken back because of Ctrl-C, which has to go on
    // to its end; whoever does long work hears the signal himself.
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

/// Chooses the vertex that a walk starts from: the hint's, or without a hint the nearer of a
/// signpost's and the vertex of the last change, because points often come in order.
template <int Dimension>
VertexId Tessellation<Dimension>::start(const Position& position,
                                        std::optional<PointId> hint) const {
  if (hint && topology().is_there(*hint)) return topology().vertex_of(*hint);
  const VertexId last = standing(last_);
  // A signpost's point may have been deleted since, and its number given to a point elsewhere.
  const auto signpost = signposts_.near(position, [&](const auto& post) {
    return topology().is_there(PointId{post.number}) &&
           structure_.position(PointId{post.number}) == post.position;
  });
  if (!signpost) return last;
  const auto& forming = topology().forming(last);
  const PointId at_last = forming[0] == infinite_point ? forming[1] : forming[0];
  const auto from_here = [&](PointId p) {
    return square_distance(coordinates(structure_.position(p)), coordinates(position));
  };
  const bool last_is_nearer = from_here(at_last) < from_here(PointId{*signpost});
  return last_is_nearer ? last : topology().vertex_of(PointId{*signpost});
}

/// Returns v where it is still in use, and another vertex where it is gone.
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
  // The points of a line and the infinite point form a ring, so the line begins after the infinite
  // point.
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
  changes_since_signposts_ = 0;
}

// Renews the signposts once half of the points have changed, or there are many times more points
// than when they were put up. A trial does not renew them, because it leaves nothing behind.
template <int Dimension>
void Tessellation<Dimension>::renew_signposts(std::size_t points_each) {
  constexpr std::size_t few = 256;
  const bool too_few = points_a_signpost_at_first * signposts_.size() < count() &&
                       4 * points_each * signposts_.size() < count();
  if (count() < few || is_tried()) return;
  if (!too_few && 2 * changes_since_signposts_ < count()) return;
  std::vector<PointId> sample;
  std::size_t k = 0;
  for_each_point([&](PointId p) {
    if (k++ % points_each == 0) sample.push_back(p);
  });
  put_up_signposts(sample);
}

template class Tessellation<2>;
template class Tessellation<3>;

}  // namespace thiessen
