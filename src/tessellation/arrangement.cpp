#include "tessellation/arrangement.h"

#include <algorithm>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

template <int Dimension>
class Arrangement {
 public:
  using Forming = typename Topology<Dimension>::Forming;

  Arrangement(Structure<Dimension>& structure, std::span<const ArrangedVertex<Dimension>> vertices)
      : topology_(structure.topology()), vertices_(vertices) {}

  std::optional<std::size_t> arrange() {
    to_.assign(topology_.size(), no_vertex);
    if (const auto unfit = find_vertices()) return unfit;
    number_infinite_ones();
    topology_.renumber(to_, rows_);
    for (const ArrangedVertex<Dimension>& wanted : vertices_) put_in_order(wanted);
    return std::nullopt;
  }

 private:
  /// The forming points of a vertex in rising order, by which it is known, and where it stands.
  template <typename Where>
  using Known = std::pair<Forming, Where>;

  static Forming sorted(Forming forming) {
    std::sort(forming.begin(), forming.end());
    return forming;
  }

  // Finds the vertex of the structure that each wanted one is, by merging both lists in the order
  // of their forming points.
  std::optional<std::size_t> find_vertices() {
    std::vector<Known<VertexId>> there;
    topology_.for_each_vertex([&](VertexId v) {
      if (!topology_.is_infinite(v)) there.emplace_back(sorted(topology_.forming(v)), v);
    });
    std::vector<Known<std::size_t>> wanted;
    wanted.reserve(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      wanted.emplace_back(sorted(vertices_[i].forming), i);
    throw_if_interrupted();
    std::sort(there.begin(), there.end());
    std::sort(wanted.begin(), wanted.end());
    throw_if_interrupted();
    std::vector<bool> taken;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::size_t place = wanted[i].second;
      const bool is_there = i < there.size() && there[i].first == wanted[i].first;
      if (!is_there) return missing(there, wanted, i);
      const VertexId v = there[i].second;
      const VertexId number = vertices_[place].vertex;
      if (is_turned_over(topology_.forming(v), vertices_[place].forming)) return place;
      if (index(number) >= taken.size()) taken.resize(index(number) + 1, false);
      if (taken[index(number)]) return place;
      taken[index(number)] = true;
      to_[index(v)] = number;
    }
    if (there.size() > wanted.size()) return vertices_.size();
    rows_ = static_cast<std::uint32_t>(taken.size());
    taken_ = std::move(taken);
    return std::nullopt;
  }
  // The two lists part at i: either the wanted one is no vertex, or one of the structure's is not
  // wanted.
  std::size_t missing(const std::vector<Known<VertexId>>& there,
                      const std::vector<Known<std::size_t>>& wanted, std::size_t i) const {
    const bool lacks_one = i < there.size() && there[i].first < wanted[i].first;
    return lacks_one ? vertices_.size() : wanted[i].second;
  }

  // Whether one order of the same points is an odd permutation of the other.
  static bool is_turned_over(Forming from, const Forming& to) {
    bool odd = false;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] == to[i]) continue;
      std::swap(from[i],
                *std::find(from.begin() + static_cast<std::ptrdiff_t>(i), from.end(), to[i]));
      odd = !odd;
    }
    return odd;
  }

  void number_infinite_ones() {
    std::uint32_t next = 0;
    topology_.for_each_vertex([&](VertexId v) {
      if (!topology_.is_infinite(v)) return;
      while (next < taken_.size() && taken_[next]) ++next;
      to_[index(v)] = VertexId{next++};
    });
    rows_ = std::max(rows_, next);
  }

  void put_in_order(const ArrangedVertex<Dimension>& wanted) {
    auto& row = topology_.fill(wanted.vertex);
    const auto before = row;
    for (std::size_t i = 0; i < wanted.forming.size(); ++i) {
      const auto at = std::find(before.forming.begin(), before.forming.end(), wanted.forming[i]);
      row.forming[i] = wanted.forming[i];
      row.neighbours[i] = before.neighbours[static_cast<std::size_t>(at - before.forming.begin())];
    }
  }

  Topology<Dimension>& topology_;
  std::span<const ArrangedVertex<Dimension>> vertices_;
  std::vector<VertexId> to_;  // by vertex of the structure, the number that it gets
  std::vector<bool> taken_;   // by number, whether a finite vertex has it
  std::uint32_t rows_ = 0;
};

}  // namespace

template <int Dimension>
std::optional<std::size_t> arrange_vertices(Structure<Dimension>& structure,
                                            std::span<const ArrangedVertex<Dimension>> vertices) {
  return Arrangement<Dimension>(structure, vertices).arrange();
}

template std::optional<std::size_t> arrange_vertices(Structure<2>&,
                                                     std::span<const ArrangedVertex<2>>);
template std::optional<std::size_t> arrange_vertices(Structure<3>&,
                                                     std::span<const ArrangedVertex<3>>);

}  // namespace thiessen
