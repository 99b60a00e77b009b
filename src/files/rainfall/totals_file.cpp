#include "files/rainfall/totals_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "files/rainfall/published_rainfall.h"

namespace thiessen {
namespace {

ReadingsOptions reading(AmountsRead read, ReadingsOptions options) {
  options.read = read;
  options.is_beside_others = true;
  options.steps_may_differ = read != AmountsRead::totals;
  return options;
}

/// What settings of RAINFALL are called where they are about totals.
Wording told_of_totals(Wording hint) {
  const std::string plain = hint.plain();
  const auto names = [&](const char* setting_name) {
    return plain.find(setting_name) != std::string::npos;
  };
  if (names("time_format")) hint += "; of totals that is " + setting("totals_time_format");
  if (names("from_unit")) hint += "; of totals that is " + setting("totals_unit");
  // These name columns of RAINFALL, which may lack those of the totals.
  if (names("value_field") || names("station_field") || names("time_field")) {
    return "totals have a column a station, or columns with usual names such as date, station and "
           "rainfall, or with those that are said of " +
           input("rainfall");
  }
  return hint;
}

Error told_of_totals(const Error& error) {
  std::vector<Message> messages = error.messages();
  for (Message& message : messages) message.hint = told_of_totals(message.hint);
  return {std::move(messages), error.unlisted()};
}

/// Readings whose faults are told of as those of totals.
class ToldOfTotals : public Readings {
 public:
  explicit ToldOfTotals(std::unique_ptr<Readings> all) : all_(std::move(all)) {}

  bool next(TimeStep& step) override {
    try {
      return all_->next(step);
    } catch (const Error& error) {
      throw told_of_totals(error);
    }
  }
  std::string unit() const override { return all_->unit(); }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  std::unique_ptr<Readings> all_;
};

/// Opens totals that may be sorted, and what there may be beside them.
class TotalsFile {
 public:
  TotalsFile(RainfallRequest totals, std::span<const Station> stations,
             std::span<const std::string> passed_over, ReadingsOptions options)
      : totals_(std::move(totals)),
        stations_(stations),
        passed_over_(passed_over),
        options_(std::move(options)) {}

  std::vector<TotalsPart> open(bool is_sorted, Warnings& warnings) const {
    std::vector<TotalsPart> parts(1);
    parts[0].days = if_there(AmountsRead::days, is_sorted);
    ReadingsOptions amounts = reading(AmountsRead::totals, options_);
    amounts.steps_may_differ = parts[0].days != nullptr;
    amounts.steps_by_calendar = is_sorted;
    parts[0].amounts = opened(amounts, warnings);
    TotalsPart sums{if_there(AmountsRead::sums, is_sorted), nullptr, false};
    if (!sums.amounts) return parts;
    sums.days = if_there(AmountsRead::days_of_sums, is_sorted);
    parts.push_back(std::move(sums));
    return parts;
  }

 private:
  std::unique_ptr<Readings> opened(const ReadingsOptions& options, Warnings& warnings) const {
    try {
      return std::make_unique<ToldOfTotals>(
          open_rainfall(totals_, stations_, passed_over_, options, warnings));
    } catch (const NoRain&) {
      throw;
    } catch (const Error& error) {
      throw told_of_totals(error);
    }
  }

  /// What is odd about it is told of the amounts.
  std::unique_ptr<Readings> if_there(AmountsRead read, bool is_sorted) const {
    ReadingsOptions options = reading(read, options_);
    options.steps_by_calendar = is_sorted;
    try {
      return opened(options, *told_elsewhere_);
    } catch (const NoRain&) {
      return nullptr;
    }
  }

  RainfallRequest totals_;
  std::span<const Station> stations_;
  std::span<const std::string> passed_over_;
  ReadingsOptions options_;
  std::shared_ptr<Warnings> told_elsewhere_ = std::make_shared<Warnings>();
};

}  // namespace

TotalsSource totals_in(const RainfallRequest& totals, std::span<const Station> stations,
                       std::span<const std::string> passed_over, const ReadingsOptions& options) {
  const TotalsFile file(totals, stations, passed_over, options);
  return {totals.name(),
          [file](bool is_sorted, Warnings& warnings) { return file.open(is_sorted, warnings); }};
}

ReportingStations stations_with_totals(const RainfallRequest& totals,
                                       std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options) {
  ReportingStations heard =
      stations_that_report(totals, stations, passed_over, reading(AmountsRead::totals, options));
  const ReportingStations of_sums =
      stations_that_report(totals, stations, passed_over, reading(AmountsRead::sums, options));
  for (std::uint32_t s = 0; s < stations.size(); ++s) {
    if (of_sums[StationIndex{s}]) heard.set(StationIndex{s}, true);
  }
  return heard;
}

}  // namespace thiessen
