#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "readings/published/published_format.h"
#include "text/lines_of_files.h"
#include "text/table.h"
#include "text/text_lines.h"

namespace thiessen {

/// How the readings of SWAT's files are read, once SwatRainfall has made a table of them.
const PublishedFormat& swat_format();

/// What a file of rain of SWAT's is, by its beginning.
enum class SwatFile {
  none,
  gauges,  ///< SWAT 2012: Station, Lati, Long, Elev, and a column of five characters a gauge
  gauge,   ///< SWAT+: one gauge, with nbyr, tstep, lat, long and elev above its days
  list     ///< SWAT+'s pcp.cli: the names of files of one gauge each, which lie beside it
};
SwatFile swat_file(std::string_view beginning);

/// Opens a file by its name.
using OpenNamed = std::function<InputFile(const std::string& file)>;

/// The files that a list (pcp.cli) names, in its folder. Throws Error where it names none.
std::vector<std::string> files_of_swat_list(const std::string& list, const OpenNamed& open);

/// The rain in files of SWAT or SWAT+, as a table of station, date (YYYY-MM-DD) and precipitation,
/// in millimetres. Stations of SWAT+ are called as their files, without .pcp. Where SWAT 2012 has
/// steps shorter than a day the date has a clock (YYYY-MM-DDThh:mm), and a day that is one line
/// without a clock, which means that it was dry, has the steps of the first day that has any.
/// Throws Error at the end with all lines that are none, and rain that is no number from 0 on, and
/// at once for steps of SWAT+ that are shorter than a day.
class SwatRainfall : public Table {
 public:
  /// Requires a file that is one of SWAT's, and what it is. Throws Error.
  SwatRainfall(std::string file, SwatFile kind, OpenNamed open);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return numbers_rows() ? 0 : 1; }
  bool numbers_rows() const override { return kind_ == SwatFile::list || !clocks_.empty(); }
  RowPlace place(std::size_t number) const override {
    return places_.place(clocks_.empty() ? number : number / steps_a_line);
  }
  bool next(Row& row) override;
  std::unique_ptr<Table> again() const override;

 private:
  static constexpr std::size_t steps_a_line =
      std::size_t{24} * 60;  ///< rows of steps that may be numbered

  void find_clocks();
  std::size_t row_number();
  bool next_line();
  bool next_day(std::string_view line);
  bool next_steps(std::string_view line, std::int64_t day);
  void go_to_step(std::size_t step);
  void read_values_of_gauges(std::string_view line);
  bool complain(const std::string& text);
  void read_heads_of_gauges();
  void read_head_of_gauge();
  bool open_next();

  std::string file_;
  SwatFile kind_;
  OpenNamed open_;
  std::vector<std::string> files_;  ///< of one gauge each
  std::size_t next_file_ = 0;
  std::optional<TextLines> lines_;
  std::vector<std::string> header_ = {"station", "date", "precipitation"};
  std::vector<std::string> stations_;  ///< of the file that is read
  std::vector<std::string> values_;    ///< of its line, by station
  std::size_t next_value_ = 0;
  std::vector<int> clocks_;          ///< of the steps of a day, in minutes; none: it is one step
  std::vector<std::int64_t> steps_;  ///< the moments that the line is of, in seconds
  std::size_t step_ = 0;
  LinesOfFiles places_;
  std::string date_;
  Complaints complaints_;
};

/// A gauge of SWAT's, as its file places it.
struct SwatGauge {
  std::string id;
  std::string longitude;
  std::string latitude;
  std::string elevation;
};

/// The gauges of a file of SWAT's, or of the files that a list names. Throws Error.
std::vector<SwatGauge> swat_gauges(const std::string& file, SwatFile kind, const OpenNamed& open);

}  // namespace thiessen
