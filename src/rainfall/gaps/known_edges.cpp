#include "rainfall/gaps/known_edges.h"

#include <algorithm>

namespace thiessen {
namespace {

/// How many edges on the next one is looked for: edges without a length come in no piece.
constexpr std::size_t farthest_ahead = 4;

template <typename Take>
void for_each_edge(const Basin& ground, const Take& take) {
  std::size_t ring_number = 0;
  const auto visit = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double bulge = ground.bulges.empty() ? 0 : ground.bulges[ring_number][i];
      take(ring[i], ring[(i + 1) % ring.size()], bulge);
    }
    ++ring_number;
  };
  for (const Polygon& part : ground.shape) {
    visit(part.outer);
    for (const Ring& hole : part.holes) visit(hole);
  }
}

}  // namespace

std::vector<double> figures_of_edges(const Basin& ground, const GroundMeasure& measure) {
  std::vector<double> figures;
  for_each_edge(ground, [&](Point from, Point to, double bulge) {
    figures.resize(figures.size() + measure.figures());
    if (from != to) measure.add(from, to, bulge, std::span(figures).last(measure.figures()));
  });
  return figures;
}

KnownEdges::KnownEdges(const Basin& ground, std::span<const double> known,
                       const GroundMeasure& measure)
    : known_(known), measure_(measure) {
  edges_.reserve(known.size() / measure.figures());
  for_each_edge(ground, [&](Point from, Point to, double) { edges_.push_back({from, to}); });
}

/// Whether a piece is the whole of an edge, and goes to that.
bool KnownEdges::find(Point from, Point to) const {
  const std::size_t end = std::min(at_ + farthest_ahead, edges_.size());
  for (std::size_t edge = at_; edge < end; ++edge) {
    if (edges_[edge].from != from) continue;
    at_ = edge;
    if (edges_[edge].to == to) return true;
  }
  return false;
}

void KnownEdges::add(Point from, Point to, double bulge, std::span<double> figures) const {
  if (!find(from, to)) return measure_.add(from, to, bulge, figures);
  const double* const known = &known_[at_ * figures.size()];
  for (std::size_t f = 0; f < figures.size(); ++f) figures[f] += known[f];
}

}  // namespace thiessen
