#include "basin/cell_clipper.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr double rounding_share = 1e-14;
constexpr std::uint32_t no_share = std::numeric_limits<std::uint32_t>::max();

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

std::vector<ClippedCell> all_of(CellsInBasin in_basin) {
  std::vector<ClippedCell> cells;
  cells.reserve(in_basin.shares().size());
  for (std::size_t i = 0; i < in_basin.shares().size(); ++i) {
    throw_if_interrupted();
    cells.push_back(in_basin.cell(i));
  }
  return cells;
}

}  // namespace

CellClipper::CellClipper(const Diagram& diagram, const Surface& surface, Searches searches)
    : diagram_(diagram),
      surface_(surface),
      overlay_(diagram, searches),
      parts_(diagram.places.size()),
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

// Adds what a piece of the place's boundary encloses.
void CellClipper::add(PlaceIndex place, double under, double bulge) {
  Part& part = parts_[index(place)];
  if (part.basin != basin_number_) {
    part = {{}, 0, basin_number_};
    touched_.push_back(place);
  }
  ++part.pieces;
  part.area.add(-under);
  if (bulge != 0) part.area.add(bulge);
}

// Areas are asked for in blocks, between which Ctrl-C is looked for.
void CellClipper::measure(const CutBasin& cut, double reference) {
  constexpr std::size_t block = 512;
  ++basin_number_;
  touched_.clear();
  bool has_bulges = false;
  const auto in_blocks = [&](std::size_t count, auto&& ask, auto&& take) {
    for (std::size_t first = 0; first < count; first += block) {
      throw_if_interrupted();
      const std::size_t end = std::min(count, first + block);
      segments_.clear();
      for (std::size_t i = first; i < end; ++i) ask(i);
      surface_.under_each(segments_, reference, areas_);
      std::size_t next = 0;
      for (std::size_t i = first; i < end; ++i) take(i, next);
    }
  };
  const auto is_known = [&](std::size_t i) {
    return i > 0 && is_reverse(cut.pieces[i - 1], cut.pieces[i]);
  };
  double under = 0;
  in_blocks(
      cut.pieces.size(),
      [&](std::size_t i) {
        if (!is_known(i)) segments_.push_back({cut.pieces[i].from, cut.pieces[i].to});
      },
      [&](std::size_t i, std::size_t& next) {
        under = is_known(i) ? -under : areas_[next++];
        add(cut.pieces[i].place, under, cut.pieces[i].bulge);
        has_bulges = has_bulges || cut.pieces[i].bulge != 0;
      });
  in_blocks(
      cut.whole_chords.size(),
      [&](std::size_t i) {
        const Chord& chord = diagram_.chords[cut.whole_chords[i]];
        __builtin_prefetch(&parts_[index(chord.left)]);
        __builtin_prefetch(&parts_[index(chord.right)]);
        segments_.push_back({diagram_.nodes[chord.from], diagram_.nodes[chord.to]});
      },
      [&](std::size_t i, std::size_t& next) {
        const std::uint32_t number = cut.whole_chords[i];
        const Chord& chord = diagram_.chords[number];
        const double bulge = diagram_.bulges.empty() ? 0 : diagram_.bulges[number];
        under = areas_[next++];
        add(chord.left, under, bulge);
        add(chord.right, -under, -bulge);
        has_bulges = has_bulges || bulge != 0;
      });
  sort_touched();
  if (has_bulges) settle_bulges();
}

// Where many places have a part it takes less time to look at all.
void CellClipper::sort_touched() {
  constexpr std::size_t few = 16;
  if (touched_.size() < parts_.size() / few) {
    std::sort(touched_.begin(), touched_.end());
    return;
  }
  touched_.clear();
  for (std::uint32_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].basin == basin_number_) touched_.push_back(PlaceIndex{i});
  }
}

// Without this the others would add up to more than the basin.
void CellClipper::settle_bulges() {
  double less_than_nothing = 0;
  double positive = 0;
  for (const PlaceIndex place : touched_) {
    const double area = parts_[index(place)].area.value();
    (area < 0 ? less_than_nothing : positive) += area;
  }
  if (less_than_nothing == 0 || !(positive > -less_than_nothing)) return;
  for (const PlaceIndex place : touched_) {
    LongSum& area = parts_[index(place)].area;
    const double before = area.value();
    if (before < 0)
      area = {};
    else
      area.add(before / positive * less_than_nothing);
  }
}

double CellClipper::smallest_area() const {
  double whole = 0;
  for (const PlaceIndex place : touched_) whole += parts_[index(place)].area.value();
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
    const double area = parts_[index(place)].area.value();
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
  for (std::uint32_t i = 0; i < touched_.size(); ++i) order_[index(touched_[i])] = i;
  std::vector<LongSum> sums(touched_.size() * count);
  std::vector<double> edge(count);
  const auto add = [&](PlaceIndex place) {
    LongSum* const sum = &sums[order_[index(place)] * count];
    for (std::size_t f = 0; f < count; ++f) sum[f].add(edge[f]);
  };
  const auto find = [&](const BoundaryPiece& piece) {
    std::fill(edge.begin(), edge.end(), 0);
    measure.add(piece.from, piece.to, piece.bulge, edge);
  };
  const auto reverse = [&] {
    for (double& figure : edge) figure = -figure;
  };
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    throw_if_interrupted();
    const BoundaryPiece& piece = cut.pieces[i];
    const bool known = i > 0 && is_reverse(cut.pieces[i - 1], piece);
    known ? reverse() : find(piece);
    add(piece.place);
  }
  for (const std::uint32_t chord : cut.whole_chords) {
    throw_if_interrupted();
    const auto [left, right] = pieces_of(diagram_, chord);
    find(left);
    add(left.place);
    reverse();
    add(right.place);
  }
  const double smallest = smallest_area();
  std::vector<double> figures;
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    if (parts_[index(touched_[i])].area.value() <= smallest) continue;
    for (std::size_t f = 0; f < count; ++f) figures.push_back(sums[i * count + f].value());
  }
  return figures;
}

std::vector<ClippedCell> CellClipper::cells(const Basin& basin) {
  return all_of(cells_in(basin));
}

std::vector<ClippedCell> CellClipper::cells(const Basin& basin, const GroundMeasure& measure,
                                            std::vector<double>& figures) {
  const CutBasin& cut = cut_and_measure(basin);
  figures = figures_of(cut, measure);
  return all_of(cells_of(cut));
}

CellsInBasin CellClipper::cells_in(const Basin& basin) {
  return cells_of(cut_and_measure(basin));
}

CellsInBasin CellClipper::cells_of(const CutBasin& cut) {
  std::vector<CellShare> shares = shares_of_cut();
  for (const PlaceIndex place : touched_) order_[index(place)] = no_share;
  std::vector<std::uint32_t> begins;
  begins.reserve(shares.size() + 2);
  std::uint32_t begin = 0;
  for (std::uint32_t i = 0; i < shares.size(); ++i) {
    order_[index(shares[i].place)] = i;
    begins.push_back(begin);
    begin += parts_[index(shares[i].place)].pieces;
  }
  begins.push_back(begin);
  return {diagram_, cut, std::move(shares), std::move(begins), order_};
}

// There are millions of pieces in a basin as large as a continent: they stay where they are, and no
// step takes long between two looks for Ctrl-C.
CellsInBasin::CellsInBasin(const Diagram& diagram, const CutBasin& cut,
                           std::vector<CellShare> shares, std::vector<std::uint32_t> begins,
                           const std::vector<std::uint32_t>& order)
    : diagram_(diagram), cut_(cut), shares_(std::move(shares)), begins_(std::move(begins)) {
  const std::uint64_t numbers = cut.pieces.size() + 2 * std::uint64_t{diagram.chords.size()};
  if (numbers > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more than 2^32 pieces of cells");
  numbers_.resize(begins_.back());
  // Each share's pieces are put where its next one is to stand; in the end that is where the next
  // share's begin.
  const auto put = [&](PlaceIndex place, std::uint32_t number) {
    if (const std::uint32_t share = order[index(place)]; share != no_share)
      numbers_[begins_[share]++] = number;
  };
  for (std::uint32_t i = 0; i < cut.pieces.size(); ++i) {
    throw_if_interrupted();
    put(cut.pieces[i].place, i);
  }
  const auto first_chord = static_cast<std::uint32_t>(cut.pieces.size());
  for (const std::uint32_t chord : cut.whole_chords) {
    throw_if_interrupted();
    put(diagram.chords[chord].left, first_chord + 2 * chord);
    put(diagram.chords[chord].right, first_chord + 2 * chord + 1);
  }
  std::shift_right(begins_.begin(), begins_.end(), 1);
  begins_.front() = 0;
  has_bulges_ =
      std::ranges::any_of(cut.pieces,
                          [](const BoundaryPiece& piece) { return piece.bulge != 0; }) ||
      (!diagram.bulges.empty() && std::ranges::any_of(cut.whole_chords, [&](std::uint32_t chord) {
        return diagram.bulges[chord] != 0;
      }));
}

void CellsInBasin::expect_far(std::size_t i) const {
  for (std::uint32_t n = begins_[i]; n < begins_[i + 1]; ++n) {
    const std::size_t number = numbers_[n];
    if (number >= cut_.pieces.size())
      __builtin_prefetch(&diagram_.chords[(number - cut_.pieces.size()) / 2]);
    else
      __builtin_prefetch(&cut_.pieces[number]);
  }
}

void CellsInBasin::expect_near(std::size_t i) const {
  for (std::uint32_t n = begins_[i]; n < begins_[i + 1]; ++n) {
    const std::size_t number = numbers_[n];
    if (number < cut_.pieces.size()) continue;
    const Chord& chord = diagram_.chords[(number - cut_.pieces.size()) / 2];
    __builtin_prefetch(&diagram_.nodes[chord.from]);
    __builtin_prefetch(&diagram_.nodes[chord.to]);
  }
}

ClippedCell CellsInBasin::cell(std::size_t i) {
  pieces_.clear();
  edges_.clear();
  for (std::uint32_t n = begins_[i]; n < begins_[i + 1]; ++n) {
    const std::uint32_t number = numbers_[n];
    if (number < cut_.pieces.size()) {
      pieces_.push_back(cut_.pieces[number]);
    } else {
      const std::size_t side = number - cut_.pieces.size();
      const auto [left, right] = pieces_of(diagram_, static_cast<std::uint32_t>(side / 2));
      pieces_.push_back(side % 2 == 0 ? left : right);
    }
    edges_.push_back({pieces_.back().from, pieces_.back().to});
  }
  require_closed(pieces_);
  ClippedCell cell{shares_[i].place, shares_[i].area, link_rings(edges_), {}};
  if (has_bulges_) cell.bulges = bulges_of(cell.shape, pieces_);
  return cell;
}

}  // namespace thiessen
