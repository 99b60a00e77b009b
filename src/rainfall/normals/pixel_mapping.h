#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"

namespace thiessen {

/// Takes points of the study to pixels of a raster's window: columns from its left edge, rows
/// downwards from its top. Safe for several threads at once.
class PixelMapping {
 public:
  virtual ~PixelMapping() = default;
  virtual Point to_pixels(Point ground) const = 0;
  /// Whether edges that are straight in the study are straight in the raster.
  virtual bool keeps_straight() const = 0;
};

/// The mapping of a raster in the coordinates of the study.
class AffineMapping : public PixelMapping {
 public:
  /// `origin` is where the study's point 0 0 lies; the others are how far a unit of x and of y go.
  AffineMapping(Point origin, Point along_x, Point along_y)
      : origin_(origin), along_x_(along_x), along_y_(along_y) {}
  Point to_pixels(Point ground) const override {
    return {origin_.x + ground.x * along_x_.x + ground.y * along_y_.x,
            origin_.y + ground.x * along_x_.y + ground.y * along_y_.y};
  }
  bool keeps_straight() const override { return true; }

 private:
  Point origin_;
  Point along_x_;
  Point along_y_;
};

/// A mapping that is asked for at nodes alone and is cubic between them, each way: it costs some
/// tens of nanoseconds, where a projection and a change of datum cost a microsecond and must not be
/// asked by two threads at once.
class SmoothMapping : public PixelMapping {
 public:
  /// The true mapping of many points at once; one that cannot be mapped becomes NaN.
  using Exact = std::function<std::vector<Point>(std::vector<Point>)>;

  /// The nodes lie over `frame`, so near each other that the mapping is right to `tolerance` pixels
  /// between them, where 256 each way are enough for that.
  SmoothMapping(const Exact& exact, const Box& frame, double tolerance);

  Point to_pixels(Point ground) const override;
  bool keeps_straight() const override { return false; }
  /// How far, in pixels, it is from the true mapping in the middles between nodes; NaN where some
  /// point of the frame cannot be mapped.
  double error() const { return error_; }

 private:
  void take_nodes(const Exact& exact);
  double error_between(const Exact& exact) const;

  Box frame_;
  std::size_t intervals_ = 4;  // each way
  std::vector<Point> nodes_;
  double error_ = 0;
};

}  // namespace thiessen
