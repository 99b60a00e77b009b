#include "basin/cell_clipper.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/interrupt.h"
#include "basin/ring_linking.h"

namespace thiessen {
namespace {

constexpr double rounding_share = 1e-14;

Box box_of_basin(const Basin& basin) {
  Box box;
  for (const Polygon& part : basin.shape) {
    for (const Point p : part.outer) box.take_in(p);
  }
  return box;
}

bool is_reverse(const BoundaryPiece& a, const BoundaryPiece& b) {
  return a.from == b.to && a.to == b.from;
}

auto undirected(const BoundaryPiece& piece) {
  return std::tuple(piece.place, std::min(piece.from, piece.to), std::max(piece.from, piece.to));
}

// Takes out the pieces of one cell that lie on each other in opposite directions, because they
// enclose nothing.
void cancel_opposite_pieces(std::vector<BoundaryPiece>& pieces) {
  std::stable_sort(
      pieces.begin(), pieces.end(),
      [](const BoundaryPiece& a, const BoundaryPiece& b) { return undirected(a) < undirected(b); });
  std::vector<BoundaryPiece> kept;
  kept.reserve(pieces.size());
  for (const BoundaryPiece& piece : pieces) {
    if (!kept.empty() && kept.back().place == piece.place && is_reverse(kept.back(), piece)) {
      kept.pop_back();
    } else {
      kept.push_back(piece);
    }
  }
  pieces = std::move(kept);
}

/// The bulges of a shape's edges, ring by ring, each from the piece that the edge came from.
std::vector<std::vector<double>> bulges_of(const MultiPolygon& shape,
                                           std::span<const BoundaryPiece> pieces) {
  std::map<std::pair<Point, Point>, double> bulge;
  for (const BoundaryPiece& piece : pieces) {
    if (piece.bulge != 0) bulge[{piece.from, piece.to}] = piece.bulge;
  }
  std::vector<std::vector<double>> bulges;
  const auto add = [&](const Ring& ring) {
    std::vector<double>& of_ring = bulges.emplace_back(ring.size(), 0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto found = bulge.find({ring[i], ring[(i + 1) % ring.size()]});
      if (found != bulge.end()) of_ring[i] = found->second;
    }
  };
  for (const Polygon& part : shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return bulges;
}

/// Throws std::logic_error where the pieces of a cell's boundary do not close. At every point as
/// many have to begin as end, so any figure of the points cancels.
void require_closed(std::span<const BoundaryPiece> pieces) {
  std::size_t open = 0;
  const auto figure = [](Point p) {
    const std::hash<double> hash;
    return (hash(p.x) * 0x9E3779B97F4A7C15ull ^ hash(p.y)) * 0xD6E8FEB86659FD93ull;
  };
  for (const BoundaryPiece& piece : pieces) open += figure(piece.from) - figure(piece.to);
  if (open != 0) throw std::logic_error("the boundary of a cell in a basin does not close");
}

}  // namespace

CellClipper::CellClipper(const Diagram& diagram, const Surface& surface)
    : surface_(surface),
      overlay_(diagram),
      area_(diagram.places.size()),
      is_touched_(diagram.places.size(), false),
      order_(diagram.places.size(), 0) {}

double area_of(const Basin& basin, const Surface& surface) {
  const double reference = box_of_basin(basin).centre().y;
  LongSum area;
  std::size_t ring_number = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      area.add(-surface.under(ring[i], ring[(i + 1) % ring.size()], reference));
      if (!basin.bulges.empty()) area.add(basin.bulges[ring_number][i]);
    }
    ++ring_number;
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return area.value();
}

LongSum& CellClipper::area_at(PlaceIndex place) {
  if (!is_touched_[index(place)]) {
    is_touched_[index(place)] = true;
    touched_.push_back(place);
  }
  return area_[index(place)];
}

void CellClipper::measure(const CutBasin& cut, double reference) {
  for (const PlaceIndex place : touched_) {
    area_[index(place)] = {};
    is_touched_[index(place)] = false;
  }
  touched_.clear();
  double under = 0;
  bool has_bulges = false;
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    throw_if_interrupted();
    const BoundaryPiece& piece = cut.pieces[i];
    const bool known = i > 0 && is_reverse(cut.pieces[i - 1], piece);
    under = known ? -under : surface_.under(piece.from, piece.to, reference);
    LongSum& area = area_at(piece.place);
    area.add(-under);
    if (piece.bulge != 0) {
      area.add(piece.bulge);
      has_bulges = true;
    }
  }
  std::sort(touched_.begin(), touched_.end());
  if (has_bulges) settle_bulges();
}

// Without this the others would add up to more than the basin.
void CellClipper::settle_bulges() {
  double less_than_nothing = 0;
  double positive = 0;
  for (const PlaceIndex place : touched_) {
    const double area = area_[index(place)].value();
    (area < 0 ? less_than_nothing : positive) += area;
  }
  if (less_than_nothing == 0 || !(positive > -less_than_nothing)) return;
  for (const PlaceIndex place : touched_) {
    LongSum& area = area_[index(place)];
    const double before = area.value();
    if (before < 0)
      area = {};
    else
      area.add(before / positive * less_than_nothing);
  }
}

double CellClipper::smallest_area() const {
  double whole = 0;
  for (const PlaceIndex place : touched_) whole += area_[index(place)].value();
  return rounding_share * whole;
}

CutBasin& CellClipper::cut_and_measure(const Basin& basin) {
  CutBasin& cut = overlay_.cut(basin);
  if (cut.touching) cancel_opposite_pieces(cut.pieces);
  measure(cut, box_of_basin(basin).centre().y);
  return cut;
}

std::vector<CellShare> CellClipper::shares_of_cut() const {
  const double smallest = smallest_area();
  std::vector<CellShare> shares;
  for (const PlaceIndex place : touched_) {
    const double area = area_[index(place)].value();
    if (area > smallest) shares.push_back({place, area});
  }
  return shares;
}

std::vector<CellShare> CellClipper::shares(const Basin& basin) {
  cut_and_measure(basin);
  return shares_of_cut();
}

std::vector<CellShare> CellClipper::shares(const Basin& basin, const GroundMeasure& measure,
                                           std::vector<double>& figures) {
  figures = figures_of(cut_and_measure(basin), measure);
  return shares_of_cut();
}

// The figures of the cells that count, in the order of their places.
std::vector<double> CellClipper::figures_of(const CutBasin& cut, const GroundMeasure& measure) {
  const std::size_t count = measure.figures();
  for (std::size_t i = 0; i < touched_.size(); ++i) order_[index(touched_[i])] = i;
  std::vector<LongSum> sums(touched_.size() * count);
  std::vector<double> edge(count);
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    throw_if_interrupted();
    const BoundaryPiece& piece = cut.pieces[i];
    const bool known = i > 0 && is_reverse(cut.pieces[i - 1], piece);
    if (known) {
      for (double& figure : edge) figure = -figure;
    } else {
      std::fill(edge.begin(), edge.end(), 0);
      measure.add(piece.from, piece.to, piece.bulge, edge);
    }
    LongSum* const sum = &sums[order_[index(piece.place)] * count];
    for (std::size_t f = 0; f < count; ++f) sum[f].add(edge[f]);
  }
  const double smallest = smallest_area();
  std::vector<double> figures;
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    if (area_[index(touched_[i])].value() <= smallest) continue;
    for (std::size_t f = 0; f < count; ++f) figures.push_back(sums[i * count + f].value());
  }
  return figures;
}

// There are millions of pieces in a basin as large as a continent: they stay where they are, and no
// step takes long between two looks for Ctrl-C.
CellClipper::PiecesByCell CellClipper::pieces_by_cell(const CutBasin& cut) {
  PiecesByCell sorted;
  sorted.begins.assign(touched_.size() + 1, 0);
  for (std::size_t i = 0; i < touched_.size(); ++i) order_[index(touched_[i])] = i;
  for (const BoundaryPiece& piece : cut.pieces) {
    throw_if_interrupted();
    ++sorted.begins[order_[index(piece.place)] + 1];
  }
  std::partial_sum(sorted.begins.begin(), sorted.begins.end(), sorted.begins.begin());
  std::vector<std::size_t> next(sorted.begins.begin(), sorted.begins.end() - 1);
  sorted.numbers.resize(cut.pieces.size());
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    throw_if_interrupted();
    sorted.numbers[next[order_[index(cut.pieces[i].place)]]++] = i;
  }
  return sorted;
}

std::vector<ClippedCell> CellClipper::cells(const Basin& basin) {
  return cells_of(cut_and_measure(basin));
}

std::vector<ClippedCell> CellClipper::cells(const Basin& basin, const GroundMeasure& measure,
                                            std::vector<double>& figures) {
  const CutBasin& cut = cut_and_measure(basin);
  figures = figures_of(cut, measure);
  return cells_of(cut);
}

std::vector<ClippedCell> CellClipper::cells_of(const CutBasin& cut) {
  const double smallest = smallest_area();
  const PiecesByCell sorted = pieces_by_cell(cut);
  const bool has_bulges = std::any_of(cut.pieces.begin(), cut.pieces.end(),
                                      [](const BoundaryPiece& piece) { return piece.bulge != 0; });
  std::vector<ClippedCell> cells;
  std::vector<BoundaryPiece> pieces;
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    throw_if_interrupted();
    const double area = area_[index(touched_[i])].value();
    if (area <= smallest) continue;
    pieces.clear();
    std::vector<DirectedEdge> edges;
    for (std::size_t n = sorted.begins[i]; n < sorted.begins[i + 1]; ++n) {
      pieces.push_back(cut.pieces[sorted.numbers[n]]);
      edges.push_back({pieces.back().from, pieces.back().to});
    }
    require_closed(pieces);
    cells.push_back({touched_[i], area, link_rings(std::move(edges)), {}});
    if (has_bulges) cells.back().bulges = bulges_of(cells.back().shape, pieces);
  }
  return cells;
}

}  // namespace thiessen
