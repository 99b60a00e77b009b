#include "files/normals/fitted_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/utf8.h"
#include "earth/nearest/in_space.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/normals/elevation_lattice.h"
#include "rainfall/normals/elevation_normals.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

/// How many nodes of the lattice there are in the gauges' spacing.
constexpr double nodes_in_spacing = 3;
/// At how many points of a basin the variance is looked at.
constexpr std::size_t points_of_variance = 16;
/// How many points of a basin tell its normal where only its mean elevation is known, and how many
/// there are in the gauges' spacing.
constexpr double fewest_points = 4;
constexpr double most_points = 16;
constexpr double points_in_spacing = 1.5;
/// How many elevations are read and normals are computed at a time.
constexpr std::size_t values_at_a_time = std::size_t{1} << 20U;
/// How many blocks of pixels there are at least between two nodes of the lattice.
constexpr double blocks_between_nodes = 24;
/// The share of a block whose elevation has to be known for it to have a normal.
constexpr double least_known = 0.5;

std::string held_text(double share, const std::string& where) {
  return "normals fitted by elevation are held within a quarter and four times the nearest "
         "gauge's, which they exceed on " +
         percent_of_ground(share) + " of " + where;
}

/// Makes the normals of the basins' windows.
class GroundFiller {
 public:
  GroundFiller(const ElevationFit& fit, const RasterGround& ground, double scale,
               const Study& study, unsigned threads)
      : ground_(ground),
        scale_(scale),
        study_(study),
        months_(fit.months()),
        references_(normals_at_stations(fit, study.network()).front()),
        columns_apart_(pixels_apart(fit, {1, 0})),
        rows_apart_(pixels_apart(fit, {0, 1})),
        lattice_(
            fit, [&ground](std::vector<Point> nodes) { return ground.to_study(std::move(nodes)); },
            columns_apart_, rows_apart_, threads),
        threads_(threads) {}

  /// Makes the window of a basin, and tells the variance of its normals.
  NormalWindow window(std::size_t basin, RasterFrame frame, std::vector<double>& variances) {
    ground_.set_blocks(frame, static_cast<double>(columns_apart_) / blocks_between_nodes,
                       static_cast<double>(rows_apart_) / blocks_between_nodes);
    const std::size_t columns = frame.window_columns();
    const std::size_t rows = frame.window_rows();
    const ElevationPatch patch =
        lattice_.over({static_cast<std::int64_t>(frame.columns.first),
                       static_cast<std::int64_t>(frame.rows.first)},
                      columns * frame.block_columns, rows * frame.block_rows);
    WindowValues normals(columns, rows, months_, false);
    std::optional<WindowValues> held;
    std::vector<Sight> sights = sights_of(basin, frame);
    const std::size_t at_a_time = std::max<std::size_t>(
        1,
        values_at_a_time / (columns * std::max(months_, frame.block_columns * frame.block_rows)));
    for (std::size_t row = 0; row < rows; row += at_a_time) {
      throw_if_interrupted();
      fill(frame, patch, row, std::min(at_a_time, rows - row), normals, held, sights);
    }
    if (held) note_held(basin, frame, std::move(*held));
    variances = variances_of(frame, patch, sights);
    return ground_.window(basin, frame, std::move(normals), references_);
  }

  /// Says where normals are held, if anywhere.
  void tell_held(Warnings& warnings) const {
    if (most_held_ == 0) return;
    warnings.add_notice(
        {ground_.source().file(), 0, held_text(most_held_, ground_.place_of(worst_)), ""});
  }

 private:
  /// A block of the window in which the variance is looked at.
  struct Sight {
    std::size_t row;
    std::size_t column;
    double elevation;
  };

  /// How many pixels there are between two nodes along a side of the raster.
  std::size_t pixels_apart(const ElevationFit& fit, Point way) const {
    const Metric metric = study_.weighing().yardstick().metric;
    const Point here = fit.first_gauge();
    const Point pixel = ground_.to_pixels({here}).front();
    const std::vector<Point> both = ground_.to_study({pixel, {pixel.x + way.x, pixel.y + way.y}});
    const double side = length(in_space(both[1], metric) - in_space(both[0], metric));
    const double apart = fit.spacing() / nodes_in_spacing / side;
    constexpr double farthest = 1e6;
    return apart > 1 ? static_cast<std::size_t>(std::min(apart, farthest)) : 1;
  }

  std::vector<Sight> sights_of(std::size_t b, const RasterFrame& frame) const {
    const Basin& basin = study_.basins()[b];
    const auto mapping = ground_.mapping_of(basin, frame);
    std::vector<Sight> sights;
    for (const Point p : basin_points(basin, study_.weighing().yardstick(), points_of_variance)) {
      const Point at = mapping->to_pixels(p);
      if (!(at.x >= 0 && at.x < static_cast<double>(frame.window_columns()) && at.y >= 0 &&
            at.y < static_cast<double>(frame.window_rows())))
        continue;
      sights.push_back({static_cast<std::size_t>(at.y), static_cast<std::size_t>(at.x),
                        std::numeric_limits<double>::quiet_NaN()});
    }
    return sights;
  }

  /// The elevations of blocks: their means, and the variance of their pixels'.
  struct Heights {
    std::vector<double> means;
    std::vector<double> spreads;
  };

  /// The blocks of one row of the window; `row` counts those that were read.
  Heights heights_of(const RasterFrame& frame, const WindowValues& read, std::size_t row) const {
    const std::size_t columns = frame.window_columns();
    const std::size_t first = row * frame.block_rows;
    const std::size_t last = std::min(first + frame.block_rows, read.rows());
    Heights heights{std::vector<double>(columns, std::numeric_limits<double>::quiet_NaN()),
                    std::vector<double>(columns)};
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t left = c * frame.block_columns;
      const std::size_t right = std::min(left + frame.block_columns, read.columns());
      double sum = 0;
      double squares = 0;
      double known = 0;
      for (std::size_t r = first; r < last; ++r) {
        for (std::size_t p = left; p < right; ++p) {
          const double height = scale_ * read.at(0, r, p);
          if (std::isnan(height)) continue;
          sum += height;
          squares += height * height;
          ++known;
        }
      }
      if (!(known >= least_known * static_cast<double>((last - first) * (right - left)))) continue;
      heights.means[c] = sum / known;
      if (known > 1)
        heights.spreads[c] = std::max(0.0, squares / known - heights.means[c] * heights.means[c]);
    }
    return heights;
  }

  /// Where the blocks of a row of the window lie.
  static ElevationPatch::Row row_of(const RasterFrame& frame, std::size_t row) {
    const auto columns = static_cast<double>(frame.block_columns);
    const auto rows = static_cast<double>(frame.block_rows);
    return {{frame.columns.first + columns / 2,
             frame.rows.first + rows * (static_cast<double>(row) + 0.5)},
            columns};
  }

  void fill(const RasterFrame& frame, const ElevationPatch& patch, std::size_t row,
            std::size_t count, WindowValues& normals, std::optional<WindowValues>& held,
            std::vector<Sight>& sights) const {
    const std::size_t columns = normals.columns();
    const std::size_t first = row * frame.block_rows;
    const auto all = static_cast<std::size_t>(frame.rows.count());
    WindowValues read(static_cast<std::size_t>(frame.columns.count()),
                      std::min(count * frame.block_rows, all - first), 1, true);
    ground_.read(frame, first, read);
    std::vector<Heights> heights(count);
    std::vector<double> told(count * columns * months_);
    std::vector<char> is_held(count * columns);
    in_parallel(count, threads_, [&](std::size_t, std::size_t r) {
      heights[r] = heights_of(frame, read, r);
      patch.fill(row_of(frame, row + r), heights[r].means, heights[r].spreads,
                 std::span(told).subspan(r * columns * months_, columns * months_),
                 std::span(is_held).subspan(r * columns, columns));
    });
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t m = 0; m < months_; ++m) {
        const double* const of_row = told.data() + (r * months_ + m) * columns;
        for (std::size_t c = 0; c < columns; ++c) normals.set(m, row + r, c, of_row[c]);
      }
      for (std::size_t c = 0; c < columns; ++c) {
        if (is_held[r * columns + c] == 0) continue;
        if (!held) held.emplace(columns, normals.rows(), 1, false);
        held->set(0, row + r, c, 1);
      }
    }
    for (Sight& sight : sights) {
      if (sight.row >= row && sight.row < row + count)
        sight.elevation = heights[sight.row - row].means[sight.column];
    }
  }

  void note_held(std::size_t basin, const RasterFrame& frame, WindowValues held) {
    const double share = ground_.share_of(basin, frame, std::move(held));
    if (share <= most_held_) return;
    most_held_ = share;
    worst_ = basin;
  }

  std::vector<double> variances_of(const RasterFrame& frame, const ElevationPatch& patch,
                                   const std::vector<Sight>& sights) const {
    std::vector<double> variances(months_);
    for (std::size_t m = 0; m < months_; ++m) {
      double sum = 0;
      double count = 0;
      for (const Sight& sight : sights) {
        const ElevationPatch::Row row = row_of(frame, sight.row);
        const Point at{row.first.x + row.apart * static_cast<double>(sight.column), row.first.y};
        const double variance = patch.variance(at, sight.elevation, m);
        if (std::isnan(variance)) continue;
        sum += variance;
        ++count;
      }
      variances[m] = count > 0 ? sum / count : 0;
    }
    return variances;
  }

  const RasterGround& ground_;
  double scale_;
  const Study& study_;
  std::size_t months_;
  std::vector<double> references_;
  std::size_t columns_apart_;
  std::size_t rows_apart_;
  ElevationLattice lattice_;
  unsigned threads_;
  double most_held_ = 0;
  std::size_t worst_ = 0;
};

/// The mean elevations of the basins.
std::vector<double> mean_elevations(const Study& study, const StudyFiles& files) {
  std::vector<double> elevations;
  Complaints complaints;
  for (const Basin& basin : study.basins()) {
    const auto found = files.basin_elevations.find(basin.id);
    const bool is_known = found != files.basin_elevations.end() && !std::isnan(found->second);
    elevations.push_back(is_known ? found->second : 0);
    if (is_known) continue;
    complaints.add({files.basins_file, 0, "basin " + quoted(basin.id, 80) + " has no elevation",
                    setting("elevation") + " has the ground's; " + setting("basins_where") +
                        " leaves basins out"});
  }
  complaints.throw_if_any();
  return elevations;
}

/// The means over a basin of what a fit tells at one elevation, month by month.
struct BasinMeans {
  std::vector<double> normals;
  std::vector<double> variances;
  double held = 0;  ///< the share of points at which some month's normal is held
};

BasinMeans means_of(const ElevationFit& fit, const std::vector<Point>& points, double elevation,
                    unsigned threads) {
  const std::size_t months = fit.months();
  std::vector<ToldNormal> told(points.size() * months);
  in_parallel(points.size(), threads, [&](std::size_t, std::size_t p) {
    fit.at(points[p], std::span(told).subspan(p * months, months));
  });
  BasinMeans means{std::vector<double>(months), std::vector<double>(months), 0};
  const double share = 1 / static_cast<double>(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    bool is_held = false;
    for (std::size_t m = 0; m < months; ++m) {
      const ToldNormal& here = told[p * months + m];
      const double logarithm = here.line.value(elevation);
      const double kept = held_logarithm(logarithm, here.nearest);
      is_held = is_held || kept != logarithm;
      means.normals[m] += share * std::exp(kept);
      means.variances[m] += share * here.line.variance(elevation);
    }
    if (is_held) means.held += share;
  }
  return means;
}

}  // namespace

FittedGround normals_of_elevations(const ElevationFit& fit, const RasterGround& ground,
                                   double scale, const Study& study, unsigned threads,
                                   Warnings& warnings) {
  FittedGround fitted;
  GroundFiller filler(fit, ground, scale, study, threads);
  std::vector<NormalWindow> windows;
  std::vector<double> areas;
  Complaints complaints;
  for (std::size_t b = 0; b < study.basins().size(); ++b) {
    areas.push_back(study.weighing().basin_area(b));
    const std::optional<RasterFrame> frame = ground.frame_of(b, complaints);
    if (!frame) continue;
    windows.push_back(filler.window(b, *frame, fitted.log_variances.emplace_back()));
  }
  complaints.throw_if_any();
  fitted.normals = std::make_shared<const RasterNormals>(normals_at_stations(fit, study.network()),
                                                         std::move(windows), study.basins(), areas);
  ground.judge_cover(*fitted.normals, "elevations", warnings);
  filler.tell_held(warnings);
  return fitted;
}

FittedGround normals_of_mean_elevations(const ElevationFit& fit, const Study& study,
                                        const StudyFiles& files, unsigned threads,
                                        Warnings& warnings) {
  FittedGround fitted;
  const std::vector<double> elevations = mean_elevations(study, files);
  const Yardstick& yardstick = study.weighing().yardstick();
  const double apart = fit.spacing() / points_in_spacing;
  std::vector<std::vector<double>> normals;
  double most_held = 0;
  std::size_t worst = 0;
  for (std::size_t b = 0; b < study.basins().size(); ++b) {
    throw_if_interrupted();
    const double area = study.weighing().basin_area(b) / yardstick.unit_area;
    const double count = std::clamp(std::ceil(area / (apart * apart)), fewest_points, most_points);
    const std::vector<Point> points =
        basin_points(study.basins()[b], yardstick, static_cast<std::size_t>(count));
    BasinMeans means = means_of(fit, points, elevations[b], threads);
    normals.push_back(std::move(means.normals));
    fitted.log_variances.push_back(std::move(means.variances));
    if (means.held <= most_held) continue;
    most_held = means.held;
    worst = b;
  }
  fitted.normals =
      std::make_shared<const UniformNormals>(normals_at_stations(fit, study.network()), normals);
  if (most_held > 0) {
    warnings.add_notice({files.basins_file, 0,
                         held_text(most_held, "basin " + quoted(study.basins()[worst].id, 80)),
                         ""});
  }
  return fitted;
}

}  // namespace thiessen
