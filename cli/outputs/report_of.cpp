#include "cli/outputs/report_of.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "cli/checks/distances_report.h"
#include "cli/options/study_file.h"
#include "cli/terminal/messages.h"
#include "files/file_digest.h"
#include "readings/units/rain_unit.h"
#include "report/report.h"
#include "results/weights_file.h"

namespace thiessen::cli {
namespace {

std::vector<std::size_t> places_of(const Network& network) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < network.stations().size(); ++i) {
    const StationIndex station{static_cast<std::uint32_t>(i)};
    places.push_back(static_cast<std::size_t>(network.place_of(station)));
  }
  return places;
}

std::vector<Report::Input> inputs_of(const OptionList& options) {
  std::vector<Report::Input> inputs;
  for (const GivenFile& given : given_files(options)) {
    for (FileDigest& digest : digests_of(given.file))
      inputs.push_back({given.option, std::move(digest.name), std::move(digest.sha256)});
  }
  return inputs;
}

/// The message on one line, with its file's name but not its folder.
std::string finding_of(const std::string& kind, Message message) {
  message.file = std::filesystem::path(message.file).filename().string();
  std::string text = kind + ": " + shown(message.placed());
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void add_lines(std::vector<std::string>& findings, const std::string& lines) {
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    findings.push_back(lines.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

StudyReport::StudyReport(const Inputs& inputs)
    : inputs_(inputs), series_(inputs.basins().size(), inputs.network().stations().size()) {}

void StudyReport::add(const RainStep& step) {
  values_.clear();
  for (const BasinRainfall& basin : step.basins) values_.push_back(basin.rainfall);
  series_.add(step.time, values_, step.readings);
  ++passed_.steps;
  passed_.intervals.note(calendar_time(step.time, step.written));
  for (const double reading : step.readings) passed_.missing += std::isnan(reading) ? 1U : 0U;
}

std::vector<std::string> StudyReport::findings(const ReportParts& parts,
                                               const Warnings& warnings) const {
  const Option* const study_file = parts.options->find(study_file_option);
  // What the command line says in place of a study's file is said of neither study.
  const auto is_of_study = [&](const Message& message) {
    return study_file == nullptr || !study_file->is_given() ||
           message.file != study_file->texts.front();
  };
  std::vector<std::string> findings;
  for (const Message& message : warnings.messages())
    findings.push_back(finding_of("warning", message));
  for (const Message& notice : warnings.notices()) {
    if (is_of_study(notice)) findings.push_back(finding_of("notice", notice));
  }
  add_lines(findings, describe_study(inputs_) + odd_gauges_text(inputs_) +
                          describe_weights(parts.summary->findings()) +
                          describe_steps(inputs_, passed_));
  findings.push_back(nearest_gauges_table(inputs_));
  return findings;
}

std::string StudyReport::page(const ReportParts& parts, const Warnings& warnings) const {
  Report report;
  report.picture = parts.picture;
  report.unit = parts.unit;
  report.depth_unit = depth_unit(parts.unit);
  report.is_area_known = inputs_.area_unit().known();
  report.network = inputs_.network().stations().size();
  report.places = places_of(inputs_.network());
  report.basins = parts.summary->basins();
  report.remarks = parts.summary->remarks();
  report.has_factors = inputs_.weighing().normals() != nullptr;
  report.weights = weight_rows(inputs_.weighing(), *parts.weights, inputs_.area_unit());
  report.series = &series_;
  report.gaps = parts.gaps;
  report.has_totals = parts.has_totals;
  report.findings = findings(parts, warnings);
  report.made_by = items_of(parts.made_by);
  report.options = study_options_text(*parts.options);
  report.inputs = inputs_of(*parts.options);
  return report_page(report);
}

}  // namespace thiessen::cli
