#include "files/tables/netcdf_rainfall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18U;  ///< values that are read at once

constexpr std::array<std::string_view, 9> rain_names = {"precipitation_amount",
                                                        "rainfall_amount",
                                                        "thickness_of_rainfall_amount",
                                                        "thickness_of_precipitation_amount",
                                                        "lwe_thickness_of_precipitation_amount",
                                                        "lwe_precipitation_rate",
                                                        "rainfall_rate",
                                                        "precipitation_flux",
                                                        "rainfall_flux"};

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_real(nc_type type) {
  return type == NC_FLOAT || type == NC_DOUBLE;
}

template <typename Names>
bool is_among(std::string_view name, const Names& names) {
  return std::ranges::any_of(names, [&](std::string_view one) { return same_name(name, one); });
}

}  // namespace

NetcdfRainfall::NetcdfRainfall(std::string file, std::string variable, Warnings& warnings)
    : NetcdfRainfall(std::move(file), std::move(variable), warnings,
                     std::make_shared<bool>(false)) {}

NetcdfRainfall::NetcdfRainfall(std::string file, std::string variable, Warnings& warnings,
                               std::shared_ptr<bool> has_told)
    : file_(std::move(file)),
      variable_(std::move(variable)),
      warnings_(warnings),
      has_told_(std::move(has_told)),
      stations_(file_) {
  stations_.find();
  times_.emplace(stations_);
  find_layout();
  find_valid_range();
}

std::unique_ptr<Table> NetcdfRainfall::again() const {
  return std::unique_ptr<Table>(new NetcdfRainfall(file_, variable_, warnings_, has_told_));
}

void NetcdfRainfall::find_layout() {
  const NetcdfStations::Variable& time = *stations_.time();
  const int station = stations_.dimension();
  std::vector<int> wanted = time.dimensions;
  if (wanted.size() == 2) {
    layout_ = Layout::time_of_station;
    if (wanted[0] != station) stations_.fail("the first dimension of its times is no station");
  }
  const std::string observations = stations_.name_of_dimension(wanted.back());
  for (const NetcdfStations::Variable& one : stations_.variables()) {
    if (!stations_.attribute(one.number, "instance_dimension").empty()) {
      layout_ = Layout::indexed;
      index_ = one.number;
    } else if (stations_.attribute(one.number, "sample_dimension") == observations) {
      layout_ = Layout::contiguous;
      for (const double size : stations_.all_of(one))
        row_sizes_.push_back(size > 0 ? static_cast<std::size_t>(size) : 0);
    }
  }
  if (layout_ == Layout::one_time && station >= 0) wanted = {station, wanted[0]};
  if (layout_ == Layout::contiguous && row_sizes_.size() != stations_.count())
    stations_.fail("it does not say of each station how many observations it has");
  time_count_ = stations_.length_of(time.dimensions.back());
  const NetcdfStations::Variable* found = nullptr;
  int rank = 0;
  std::size_t equal = 0;
  for (const NetcdfStations::Variable& one : stations_.variables()) {
    if (one.type == NC_CHAR || one.type == NC_STRING || one.number == time.number ||
        one.number == index_)
      continue;
    std::vector<int> turned = one.dimensions;
    std::ranges::reverse(turned);
    const bool may_turn = layout_ == Layout::one_time && turned == wanted;
    if (one.dimensions != wanted && !may_turn) continue;
    const int its_rank = !variable_.empty() ? (one.name == variable_ ? 3 : 0)
                         : is_among(stations_.attribute(one.number, "standard_name"), rain_names)
                             ? 3
                         : is_among(one.name, known::values) ? 2
                                                             : 1;
    if (its_rank < std::max(rank, 1)) continue;
    equal = its_rank == rank ? equal + 1 : 1;
    rank = its_rank;
    if (equal == 1) found = &one;
  }
  if (found == nullptr || equal > 1) {
    stations_.fail(found == nullptr ? "it has no such variable of all stations and times"
                                    : "more than one of its variables may be rain",
                   setting("value_field") + " names it");
  }
  rain_ = found->number;
  rain_type_ = found->type;
  time_first_ = found->dimensions.size() == 2 && found->dimensions != wanted;
  header_ = {"station", "time", found->name};
  units_ = stations_.attribute(rain_, "units");
  fill_ = stations_.number(rain_, "_FillValue");
  missing_ = stations_.number(rain_, "missing_value");
  scale_ = stations_.number(rain_, "scale_factor").value_or(1);
  offset_ = stations_.number(rain_, "add_offset").value_or(0);
}

/// Finds between which numbers values are valid. These are numbers as they are stored, but where
/// they are of a wider type than stored values that have a scale.
void NetcdfRainfall::find_valid_range() {
  std::vector<double> range = stations_.numbers(rain_, "valid_range");
  const char* name = "valid_range";
  if (range.size() != 2) {
    const auto least = stations_.number(rain_, "valid_min");
    const auto most = stations_.number(rain_, "valid_max");
    if (!least && !most) return;
    name = !most ? "valid_min" : !least ? "valid_max" : "valid_min and valid_max";
    range = {least.value_or(-infinite), most.value_or(infinite)};
  }
  const bool is_packed = scale_ != 1 || offset_ != 0;
  bool is_real_there = false;
  for (const char* one : {"valid_range", "valid_min", "valid_max"})
    is_real_there = is_real_there || is_real(stations_.type_of(rain_, one));
  valid_ = {range[0], range[1], is_packed && is_real_there && !is_real(rain_type_), name};
}

/// Whether a value is one that the file itself calls invalid.
bool NetcdfRainfall::is_outside(double value) const {
  const double amount = valid_.is_of_amounts ? value * scale_ + offset_ : value;
  return amount < valid_.least || amount > valid_.most;
}

/// Takes note of a value that is invalid, for what is said at the end.
void NetcdfRainfall::note_outside(const Entry& entry) {
  if (outside_++ > 0) return;
  first_outside_ =
      place(entry.number).words + ", is " + shortest_text(entry.value * scale_ + offset_);
}

/// Says once that values were left out, at the end of whichever reading of the file comes there
/// first.
void NetcdfRainfall::tell_outside() {
  if (outside_ == 0 || std::exchange(*has_told_, true)) return;
  warnings_.add({file_, 0,
                 first_outside_ + ", outside what its " + valid_.attribute + " allows" +
                     (outside_ > 1 ? ", the first of " + std::to_string(outside_) : "") +
                     ": taken for missing",
                 ""});
}

bool NetcdfRainfall::next(Row& row) {
  while (next_ == block_.size()) {
    throw_if_interrupted();
    block_.clear();
    next_ = 0;
    if (load_block()) continue;
    tell_outside();
    return false;
  }
  const Entry& entry = block_[next_++];
  time_ = times_->text_of(entry.time);
  value_.clear();
  if (is_there(entry.value)) {
    if (is_outside(entry.value)) {
      note_outside(entry);
    } else {
      value_ = shortest_text(entry.value * scale_ + offset_);
    }
  }
  row.line = entry.number;
  row.padded = false;
  row.fields = {stations_.ids()[entry.station], time_, value_};
  return true;
}

RowPlace NetcdfRainfall::place(std::size_t number) const {
  const std::string& variable = header_.back();
  const std::size_t at = number - 1;
  std::string words = quoted(variable, 60) + ", ";
  const auto of_station = [&](std::size_t step, std::size_t station) {
    words +=
        "step " + std::to_string(step + 1) + " of station " + quoted(stations_.ids()[station], 60);
  };
  switch (layout_) {
    case Layout::one_time:
      of_station(at / stations_.count(), at % stations_.count());
      break;
    case Layout::time_of_station:
      of_station(at % time_count_, at / time_count_);
      break;
    case Layout::contiguous:
    case Layout::indexed:
      words += "observation " + std::to_string(number);
      break;
  }
  return {file_, 0, std::move(words)};
}

bool NetcdfRainfall::load_block() {
  switch (layout_) {
    case Layout::one_time:
      return load_times();
    case Layout::time_of_station:
    case Layout::contiguous:
      return load_station();
    case Layout::indexed:
      break;
  }
  return load_observations();
}

/// Reads some times of all stations.
bool NetcdfRainfall::load_times() {
  const std::size_t stations = stations_.count();
  if (done_ == time_count_ || stations == 0) return false;
  const std::size_t count =
      std::min(time_count_ - done_, std::max<std::size_t>(1, block_size / stations));
  const std::vector<double> times = times_->read({&done_, 1}, {&count, 1});
  std::vector<double> values(count * stations);
  const bool one = stations_.dimension() < 0;
  std::array<std::size_t, 2> begin = {time_first_ || one ? done_ : 0, time_first_ ? 0 : done_};
  std::array<std::size_t, 2> size = {time_first_ || one ? count : stations,
                                     time_first_ ? stations : count};
  stations_.check(
      nc_get_vara_double(stations_.file(), rain_, begin.data(), size.data(), values.data()));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t station = 0; station < stations; ++station) {
      const std::size_t at = time_first_ ? i * stations + station : station * count + i;
      block_.push_back({station, times[i], values[at], (done_ + i) * stations + station + 1});
    }
  }
  done_ += count;
  return true;
}

/// Reads all of one station.
bool NetcdfRainfall::load_station() {
  if (done_ == stations_.count()) return false;
  const bool is_ragged = layout_ == Layout::contiguous;
  const std::size_t count = is_ragged ? row_sizes_[done_] : time_count_;
  if (is_ragged && (count > time_count_ || passed_ > time_count_ - count))
    stations_.fail("its stations have more observations than there are");
  std::vector<double> values(count);
  const std::array<std::size_t, 2> begin = {is_ragged ? passed_ : done_, 0};
  const std::array<std::size_t, 2> size = {is_ragged ? count : 1, count};
  const std::size_t rank = is_ragged ? 1 : 2;
  const std::vector<double> times =
      times_->read(std::span(begin).first(rank), std::span(size).first(rank));
  if (count > 0) {
    stations_.check(
        nc_get_vara_double(stations_.file(), rain_, begin.data(), size.data(), values.data()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!(std::abs(times[i]) < 1e15)) continue;  // a place that this station does not fill
    block_.push_back({done_, times[i], values[i], (is_ragged ? passed_ : done_ * count) + i + 1});
  }
  passed_ += count;
  ++done_;
  return true;
}

/// Reads some observations, each of a station that the index names.
bool NetcdfRainfall::load_observations() {
  if (done_ == time_count_) return false;
  const std::size_t count = std::min(time_count_ - done_, block_size);
  const std::vector<double> times = times_->read({&done_, 1}, {&count, 1});
  const std::vector<double> values = part_of(rain_, done_, count);
  const std::vector<double> index = part_of(index_, done_, count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(index[i] >= 0 && index[i] < static_cast<double>(stations_.count())))
      stations_.fail("an observation is of no station: " + shortest_text(index[i]));
    block_.push_back({static_cast<std::size_t>(index[i]), times[i], values[i], done_ + i + 1});
  }
  done_ += count;
  return true;
}

std::vector<double> NetcdfRainfall::part_of(int variable, std::size_t begin,
                                            std::size_t count) const {
  std::vector<double> values(count);
  stations_.check(nc_get_vara_double(stations_.file(), variable, &begin, &count, values.data()));
  return values;
}

bool NetcdfRainfall::is_there(double value) const {
  return !std::isnan(value) && value != fill_ && value != missing_;
}

}  // namespace thiessen
