#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "readings/published/published_format.h"
#include "readings/published/swat_files.h"
#include "text/lines_of_files.h"
#include "text/table.h"
#include "text/text_lines.h"

namespace thiessen {

/// How the readings of ArcSWAT's files are read, once ArcSwatRainfall has made a table of them: of
/// a list, and of one gauge.
const PublishedFormat& arcswat_list_format();
const PublishedFormat& arcswat_gauge_format();

/// What a file of rain of ArcSWAT's is, by its beginning.
enum class ArcSwatFile {
  none,
  list,  ///< ID,NAME,LAT,LONG,ELEVATION: files of one gauge each lie beside it, called NAME.txt
  gauge  ///< a first day as YYYYMMDD, and below it the rain of a day a line
};
ArcSwatFile arcswat_file(std::string_view beginning);

/// A gauge of a list, and the file of its rain.
struct ArcSwatGauge {
  std::string id;
  std::string file;
};

/// The files that a list names, beside it. Throws Error with all lines that name none, and where
/// there are none at all.
std::vector<std::string> files_of_arcswat_list(const std::string& list, const OpenNamed& open);

/// The rain in files of ArcSWAT, in millimetres, as a table of date (YYYY-MM-DD) and precipitation;
/// of a list with the gauge's ID as station. Throws Error at the end with all lines that are no
/// rain from 0 on, nor -99 for none.
class ArcSwatRainfall : public Table {
 public:
  /// Requires a file that is one of ArcSWAT's, and what it is. Throws Error.
  ArcSwatRainfall(std::string file, ArcSwatFile kind, OpenNamed open);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return kind_ == ArcSwatFile::list ? 0 : 1; }
  bool numbers_rows() const override { return kind_ == ArcSwatFile::list; }
  RowPlace place(std::size_t number) const override { return places_.place(number); }
  bool next(Row& row) override;
  std::unique_ptr<Table> again() const override;

 private:
  bool open_next();

  std::string file_;
  ArcSwatFile kind_;
  OpenNamed open_;
  std::vector<std::string> header_;
  std::vector<ArcSwatGauge> gauges_;
  std::size_t next_gauge_ = 0;
  std::optional<TextLines> lines_;
  std::int64_t seconds_ = 0;  ///< of the day that comes next
  LinesOfFiles places_;
  std::string date_;
  std::string value_;
  Complaints complaints_;
};

}  // namespace thiessen
