#include "rainfall/methods/natural_step.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

// What depends on so many silent gauges at most is remembered.
constexpr std::size_t few_silent = 2;

}  // namespace

// The sums of a block are taken without those of its neighbours that are silent. Where these sums
// weigh no silent gauge they are right: the point's cell, and what it takes from others, are those
// among all that report.
void NaturalNeighbours::AtStep::take_up(std::uint32_t basin) {
  const std::vector<PointBlock>& blocks = all_.points_[basin].blocks.all;
  sums_[basin].resize(blocks.size());
  std::vector<PlaceIndex> silent;
  for (std::uint32_t i = 0; i < blocks.size(); ++i) {
    if (add_silent(full_sums(basin, blocks[i]), silent)) look_up({silent, basin, i});
    silent.clear();
  }
}

// Adds the silent gauges among those that weigh, and tells whether there are any that were not
// known.
bool NaturalNeighbours::AtStep::add_silent(std::span<const PlaceSum> sums,
                                           std::vector<PlaceIndex>& silent) const {
  const std::size_t known = silent.size();
  for (const PlaceSum& sum : sums) {
    if (!reports_[sum.place]) silent.push_back(sum.place);
  }
  if (silent.size() == known) return false;
  std::sort(silent.begin(), silent.end());
  return true;
}

void NaturalNeighbours::AtStep::look_up(Waiting block) {
  const bool is_few = block.silent.size() <= few_silent;
  if (!is_few || all_.full_.chart.kind() == ChartKind::whole_earth) {
    by_all_.push_back(std::move(block));
    return;
  }
  if (auto sums = remembered(block)) {
    settle(std::move(block), std::move(sums));
  } else {
    waiting_.push_back(std::move(block));
  }
}

void NaturalNeighbours::AtStep::settle(Waiting block, std::shared_ptr<const Sums> sums) {
  if (add_silent(*sums, block.silent)) return look_up(std::move(block));
  sums_[block.basin][block.block] = std::move(sums);
}

std::shared_ptr<const NaturalNeighbours::Sums> NaturalNeighbours::AtStep::remembered(
    const Waiting& block) {
  if (block.silent.size() == 1) return all_.singles_->find(single(block));
  set_key(block);
  return all_.remembered_.find(key_);
}

std::shared_ptr<const NaturalNeighbours::Sums> NaturalNeighbours::AtStep::kept(const Waiting& block,
                                                                               Sums sums) {
  const std::size_t bytes = sums.capacity() * sizeof(PlaceSum);
  if (block.silent.size() == 1)
    return all_.singles_->keep(single(block), std::make_unique<const Sums>(std::move(sums)), bytes);
  auto value = std::make_shared<const Sums>(std::move(sums));
  set_key(block);
  all_.remembered_.keep(key_, value, bytes);
  return value;
}

// The number of the block's sum of the one gauge that is silent.
std::size_t NaturalNeighbours::AtStep::single(const Waiting& waiting) const {
  const Points& points = all_.points_[waiting.basin];
  const PointBlock& block = points.blocks.all[waiting.block];
  const std::span<const PlaceSum> sums = full_sums(waiting.basin, block);
  const auto at = std::find_if(sums.begin(), sums.end(), [&](const PlaceSum& sum) {
    return sum.place == waiting.silent.front();
  });
  return all_.first_sum_[waiting.basin] + month_ * points.blocks.sums.front().size() +
         block.first_sum + static_cast<std::size_t>(at - sums.begin());
}

void NaturalNeighbours::AtStep::set_key(const Waiting& block) {
  key_.assign({block.basin, block.block, static_cast<std::uint32_t>(month_)});
  for (const PlaceIndex p : block.silent) key_.push_back(static_cast<std::uint32_t>(index(p)));
}

void NaturalNeighbours::AtStep::find_all() {
  while (!waiting_.empty()) {
    std::vector<Waiting> blocks = std::exchange(waiting_, {});
    std::sort(blocks.begin(), blocks.end(), [](const Waiting& a, const Waiting& b) {
      return std::tie(a.silent, a.basin, a.block) < std::tie(b.silent, b.basin, b.block);
    });
    for (std::size_t first = 0; first < blocks.size();) {
      std::size_t end = first;
      while (end < blocks.size() && blocks[end].silent == blocks[first].silent) ++end;
      find_without(std::span(blocks).subspan(first, end - first));
      first = end;
    }
  }
  if (by_all_.empty()) return;
  workplace_.with(reports_, [&] {
    for (const Waiting& block : by_all_) {
      throw_if_interrupted();
      const Points& points = all_.points_[block.basin];
      sums_[block.basin][block.block] = std::make_shared<const Sums>(
          workplace_.sums_of(points, points.blocks.all[block.block], month_, reports_));
    }
  });
}

// Finds the sums of blocks without the same silent gauges.
void NaturalNeighbours::AtStep::find_without(std::span<Waiting> blocks) {
  throw_if_interrupted();
  const std::vector<PlaceIndex> silent = blocks.front().silent;
  workplace_.without(silent, [&](const ReportingPlaces& all_but) {
    for (Waiting& block : blocks) {
      const Points& points = all_.points_[block.basin];
      auto sums =
          kept(block, workplace_.sums_of(points, points.blocks.all[block.block], month_, all_but));
      settle(std::move(block), std::move(sums));
    }
  });
}

std::vector<PlaceWeight> NaturalNeighbours::AtStep::weights_of(std::uint32_t basin) {
  const std::vector<PointBlock>& blocks = all_.points_[basin].blocks.all;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto& sums = sums_[basin][i];
    workplace_.sums.add(sums ? std::span<const PlaceSum>(*sums) : full_sums(basin, blocks[i]));
  }
  return workplace_.sums.take();
}

}  // namespace thiessen
