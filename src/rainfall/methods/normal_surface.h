#pragma once

#include <memory>
#include <utility>

#include "rainfall/methods/rain_surface.h"
#include "rainfall/normals/normals_at_points.h"

namespace thiessen {

/// A surface of readings relative to their gauges' normals, times the normal at each point.
class NormalSurface : public RainSurface {
 public:
  NormalSurface(std::unique_ptr<RainSurface> relative,
                std::shared_ptr<const NormalsAtPoints> normals)
      : relative_(std::move(relative)), normals_(std::move(normals)) {}

  Value at(Point position) override { return times_normal(relative_->at(position), position); }
  Value continued(Point position) override {
    return times_normal(relative_->continued(position), position);
  }
  void begin_anew() override { relative_->begin_anew(); }

 private:
  Value times_normal(Value value, Point position) const {
    value.rainfall *= normals_->at(position);
    return value;
  }

  std::unique_ptr<RainSurface> relative_;
  std::shared_ptr<const NormalsAtPoints> normals_;
};

}  // namespace thiessen
