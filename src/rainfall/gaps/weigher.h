#pragma once

#include <memory>
#include <vector>

#include "rainfall/gaps/retessellation.h"
#include "rainfall/network/network.h"
#include "rainfall/network/weights.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// Gives gauges their weights in the basins, by their cells or by another method. Gap policies are
/// made from a weigher; each takes the one answer that it needs, once.
class Weigher {
 public:
  Weigher() = default;
  Weigher(const Weigher&) = delete;
  Weigher& operator=(const Weigher&) = delete;
  virtual ~Weigher() = default;

  virtual const Network& network() const = 0;
  /// The normals; null without.
  virtual const NormalField* normals() const = 0;
  /// The weights by basin when every gauge reports, with the factors of a month or of the year.
  virtual std::vector<BasinWeights> full_weights(const NormalMonth& month) const = 0;
  /// Makes the policy that weighs the gauges of each step that report, whichever they are, for the
  /// steps of a month, or for all with the normals of the year. The weigher must outlive it.
  virtual std::unique_ptr<const Retessellation> retessellation(const NormalMonth& month) const = 0;

  std::vector<BasinWeights> full_weights() const { return full_weights({}); }
  std::unique_ptr<const Retessellation> retessellation() const { return retessellation({}); }
};

}  // namespace thiessen
