#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "basin/ground_measure.h"
#include "basin/overlay.h"
#include "basin/ring_linking.h"
#include "diagram/surface.h"
#include "geometry/long_sum.h"

namespace thiessen {

/// How much of a basin lies in the cell of a place.
struct CellShare {
  PlaceIndex place;
  double area;  ///< square metres (in a plane of unknown unit, the unit squared)
};

/// The part of a place's cell within a basin.
struct ClippedCell {
  PlaceIndex place;
  double area;
  MultiPolygon shape;
  std::vector<std::vector<double>>
      bulges;  ///< of its edges: see Basin::bulges; empty where all are straight
};

class CellClipper;

/// The cells that have a share in one basin, made one at a time, so that nobody has to hold all
/// shapes: those of a million cells take a hundred times as much memory as this. It stands until
/// its clipper is given another basin.
class CellsInBasin {
 public:
  /// The cells' areas, in the order of their places.
  const std::vector<CellShare>& shares() const { return shares_; }
  /// The cell whose area stands there. Throws std::logic_error where an edge of the diagram ends
  /// within the basin, so that the cell's boundary does not close. Cost: linear in its edges.
  ClippedCell cell(std::size_t i);
  /// Tells that this cell is soon asked for, so that what it is made of comes from memory
  /// meanwhile: first that it is far off, by some tens of cells, and then that it is near.
  void expect_far(std::size_t i) const;
  void expect_near(std::size_t i) const;

 private:
  friend class CellClipper;
  /// `begins` tells where each share's pieces are to begin, and the end; `order` tells for the
  /// place of each piece which of the shares is its own, if one is.
  CellsInBasin(const Diagram& diagram, const CutBasin& cut, std::vector<CellShare> shares,
               std::vector<std::uint32_t> begins, const std::vector<std::uint32_t>& order);

  const Diagram& diagram_;
  const CutBasin& cut_;
  std::vector<CellShare> shares_;
  /// Of the pieces of each share: where they begin in `numbers_`, and the end.
  std::vector<std::uint32_t> begins_;
  /// Pieces by share, in their order in each: those of the cut basin, and after them the two of
  /// each whole chord.
  std::vector<std::uint32_t> numbers_;
  bool has_bulges_ = false;
  std::vector<BoundaryPiece> pieces_;  // of the cell at hand
  std::vector<DirectedEdge> edges_;
};

/// The basin's area on a surface. Requires a basin whose rings run as Polygon says.
double area_of(const Basin& basin, const Surface& surface);

/// Clips the cells of a diagram to basins. The diagram and the surface must outlive it. Each thread
/// needs one of its own.
class CellClipper {
 public:
  /// `searches` are few where all basins together have but a few edges.
  CellClipper(const Diagram& diagram, const Surface& surface, Searches searches = Searches::many);

  /// The cells that have a share in the basin, in the order of their places. The areas add up to
  /// the basin's within 1e-13 of it plus 2^-52 of its largest coordinate times its perimeter, which
  /// is how far the rounding of crossings to doubles may move the cells' edges. A share below 1e-14
  /// of the basin is rounding, not ground, and is left out. So is a cell that meets the chord of a
  /// basin's edge and not the edge itself, whose bulges leave it less than nothing: the others bear
  /// that in proportion to their areas. Requires a valid basin inside the diagram's frame. Cost: as
  /// Overlay::cut.
  std::vector<CellShare> shares(const Basin& basin);
  /// The same, and in `figures` what `measure` says of each share's ground, one share after the
  /// other.
  std::vector<CellShare> shares(const Basin& basin, const GroundMeasure& measure,
                                std::vector<double>& figures);

  /// The cells that have a share in the basin, with their shapes, in the order of their places.
  /// Cells side by side share their edge vertex for vertex. Requirements and accuracy are those of
  /// shares. Throws std::logic_error as CellsInBasin does.
  std::vector<ClippedCell> cells(const Basin& basin);
  /// The same, one at a time.
  CellsInBasin cells_in(const Basin& basin);
  /// The same, and in `figures` what `measure` says of each cell's ground, one cell after the
  /// other.
  std::vector<ClippedCell> cells(const Basin& basin, const GroundMeasure& measure,
                                 std::vector<double>& figures);

 private:
  CutBasin& cut_and_measure(const Basin& basin);
  std::vector<CellShare> shares_of_cut() const;
  CellsInBasin cells_of(const CutBasin& cut);
  std::vector<double> figures_of(const CutBasin& cut, const GroundMeasure& measure);
  void measure(const CutBasin& cut, double reference);
  /// A place's part in the basin of that number.
  struct Part {
    LongSum area;
    std::uint32_t pieces = 0;  ///< of its boundary
    std::uint32_t basin = 0;
  };
  void add(PlaceIndex place, double under, double bulge);
  void sort_touched();
  void settle_bulges();
  /// The smallest area that counts in the basin that was measured last; less is rounding.
  double smallest_area() const;

  const Diagram& diagram_;
  const Surface& surface_;
  Overlay overlay_;
  std::vector<Part> parts_;  // by place
  std::uint32_t basin_number_ = 0;
  std::vector<PlaceIndex> touched_;   // those with pieces in the basin at hand
  std::vector<std::uint32_t> order_;  // by place: where it stands among these, or the shares
  std::vector<Segment> segments_;     // of a block, and the areas under them
  std::vector<double> areas_;
};

}  // namespace thiessen
