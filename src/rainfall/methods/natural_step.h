#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/methods/natural_workplace.h"

namespace thiessen {

/// Finds the sums of blocks of points at a step: those of the full network, remembered ones, and
/// the others gauge by gauge, so that each gauge is deleted once for all blocks.
class NaturalNeighbours::AtStep {
 public:
  /// All of them must outlive this object.
  AtStep(const NaturalNeighbours& all, const ReportingPlaces& reports, std::size_t month,
         Workplace& workplace)
      : all_(all),
        reports_(reports),
        month_(month),
        workplace_(workplace),
        sums_(all.points_.size()) {}

  /// Has a basin's weights found.
  void take_up(std::uint32_t basin);
  void find_all();
  std::vector<PlaceWeight> weights_of(std::uint32_t basin);

 private:
  /// A block, and the silent gauges that it is known to depend on, in rising order.
  struct Waiting {
    std::vector<PlaceIndex> silent;
    std::uint32_t basin;
    std::uint32_t block;
  };

  std::span<const PlaceSum> full_sums(std::uint32_t basin, const PointBlock& block) const {
    return all_.points_[basin].blocks.sums_of(block, month_);
  }
  bool add_silent(std::span<const PlaceSum> sums, std::vector<PlaceIndex>& silent) const;
  void look_up(Waiting block);
  void settle(Waiting block, std::shared_ptr<const Sums> sums);
  void find_without(std::span<Waiting> blocks);
  std::shared_ptr<const Sums> remembered(const Waiting& block);
  std::shared_ptr<const Sums> kept(const Waiting& block, Sums sums);
  std::size_t single(const Waiting& block) const;
  void set_key(const Waiting& block);

  const NaturalNeighbours& all_;
  const ReportingPlaces& reports_;
  std::size_t month_;
  Workplace& workplace_;
  std::vector<std::vector<std::shared_ptr<const Sums>>> sums_;  // by basin and block; null: full
  std::vector<Waiting> waiting_;
  std::vector<Waiting> by_all_;  // those that are found without all silent gauges
  std::vector<std::uint32_t> key_;
};

}  // namespace thiessen
