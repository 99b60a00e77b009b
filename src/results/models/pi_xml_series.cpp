#include "results/models/pi_xml_series.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/series/time_bounds.h"

namespace thiessen {
namespace {

constexpr std::string_view missing = "-999.0";

void check_ids(const ModelSubject& subject) {
  Complaints complaints;
  for (const std::string& id : subject.basins) {
    const bool is_odd = std::any_of(id.begin(), id.end(), [](char c) {
      return static_cast<unsigned char>(c) < ' ' || c == '\x7F';
    });
    if (!id.empty() && !is_odd && !find_invalid_utf8(id)) continue;
    complaints.add({subject.output, 0,
                    "the basin's id " + quoted(id, 80) +
                        " is no location of PI-XML: it is empty or has control characters",
                    setting("basin_id") + " names another field"});
  }
  complaints.throw_if_any();
}

/// The text as it stands between tags and between quotes.
std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

/// The text as it may stand in a comment, in which no two hyphens follow each other.
std::string in_comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1))
    text.insert(at + 1, " ");
  return text;
}

/// `date="2006-08-23" time="17:00:00"`.
std::string moment_attributes(std::int64_t seconds) {
  const std::string text = time_text(seconds, TimePrecision::instant);
  const std::size_t clock = text.find('T');
  const std::string time = text.substr(clock + 1);
  return "date=\"" + text.substr(0, clock) + "\" time=\"" + time +
         (time.size() == 5 ? ":00\"" : "\"");
}

/// The zone in hours, with a point: `5.5`, `-3.0`.
std::string zone_hours(int minutes) {
  const std::string hours = shortest_text(minutes / 60.0);
  return hours.find('.') == std::string::npos ? hours + ".0" : hours;
}

}  // namespace

PiXmlSeries::PiXmlSeries(OutputFile& file, ModelSubject subject)
    : SteppedSeries(std::move(subject), "PI-XML"), file_(file) {
  check_ids(this->subject());
}

void PiXmlSeries::write_head() {
  file_.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " +
               in_comment(sentence_of(subject().made_by)) +
               " -->\n<TimeSeries xmlns=\"http://www.wldelft.nl/fews/PI\""
               " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\""
               " xsi:schemaLocation=\"http://www.wldelft.nl/fews/PI"
               " http://fews.wldelft.nl/schemas/version1.0/pi-schemas/pi_timeseries.xsd\""
               " version=\"1.2\">\n  <timeZone>" +
               zone_hours(times().zone().value_or(0)) + "</timeZone>\n");
}

/// When each step ends, those that lack among them.
std::vector<std::int64_t> PiXmlSeries::ends(const Steps& steps, Warnings& warnings) {
  std::vector<std::int64_t> ends;
  ends.reserve(steps.count);
  if (steps.length > 0) {
    for (std::size_t i = 0; i < steps.count; ++i)
      ends.push_back(steps.begin + static_cast<std::int64_t>(i + 1) * steps.length);
    return ends;
  }
  std::vector<IsoTime> moments;
  held().by_step([&](std::int64_t moment, std::span<const double>) {
    IsoTime time = parse_iso_time(time_text(moment, TimePrecision::instant)).time;
    time.precision = times().first().precision;
    moments.push_back(time);
  });
  const std::optional<StepLength> step = times().step();
  for (const TimeBounds& bounds : bounds_of(moments, step, subject().stamp))
    ends.push_back(static_cast<std::int64_t>(bounds.end));
  if (!step && times().first().precision == TimePrecision::instant &&
      subject().stamp == Stamp::begin) {
    warnings.add_notice({subject().rainfall, 0,
                         steps.count == 1
                             ? "nothing tells how long its only step is: its event is at its time"
                             : "its times have no regular step: in PI-XML each lasts until the "
                               "next, and the last as long as the one before it",
                         ""});
  }
  return ends;
}

void PiXmlSeries::write(const Steps& steps, Warnings& warnings) {
  if (!times().zone()) {
    warnings.add_notice(
        {subject().output, 0, "the times have no zone, and PI-XML has one: timeZone is 0.0", ""});
  }
  tell_lacking(steps, std::string(missing), warnings);
  const std::vector<std::int64_t> ends = this->ends(steps, warnings);
  write_head();
  by_basin(steps, [&](std::size_t basin, std::span<const double> values) {
    write_basin(steps, ends, basin, values);
  });
  file_.append("</TimeSeries>\n");
}

void PiXmlSeries::write_basin(const Steps& steps, std::span<const std::int64_t> ends,
                              std::size_t basin, std::span<const double> values) {
  const bool is_rate = subject().unit.find('/') != std::string::npos;
  file_.append(
      std::string("  <series>\n    <header>\n      <type>") + (is_rate ? "mean" : "accumulative") +
      "</type>\n      <locationId>" + escaped(subject().basins[basin]) +
      "</locationId>\n      <parameterId>P</parameterId>\n      <timeStep " +
      (steps.length > 0 ? "unit=\"second\" multiplier=\"" + std::to_string(steps.length) + "\"/>\n"
                        : std::string("unit=\"nonequidistant\"/>\n")) +
      "      <startDate " + moment_attributes(ends.front()) + "/>\n      <endDate " +
      moment_attributes(ends.back()) + "/>\n      <missVal>" + std::string(missing) +
      "</missVal>\n      <units>" + escaped(subject().unit) + "</units>\n    </header>\n");
  std::string event;
  for (std::size_t i = 0; i < values.size(); ++i) {
    event = "    <event " + moment_attributes(ends[i]) + " value=\"";
    append_value(event, values[i], missing);
    file_.append(event + "\"/>\n");
  }
  file_.append("  </series>\n");
}

}  // namespace thiessen
