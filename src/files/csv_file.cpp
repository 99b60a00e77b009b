#include "files/csv_file.h"

#include <span>
#include <utility>

#include "files/gzip_bytes.h"
#include "gdal/layers/opening.h"
#include "gdal/layers/vsi_bytes.h"
#include "text/byte_source.h"

namespace thiessen {
namespace {

std::unique_ptr<CsvReader> open_packed(const std::string& file, std::shared_ptr<ByteSource> bytes,
                                       const CsvOptions& options) {
  InputFile input(file, [bytes = std::move(bytes)](std::span<char> into) {
    return bytes->read(into.data(), into.size());
  });
  return std::make_unique<CsvReader>(std::move(input), options);
}

std::unique_ptr<CsvReader> open(const std::string& file, const CsvOptions& options) {
  if (file == "-") return std::make_unique<CsvReader>(file, options);
  const Opening opening = find_opening(file);
  switch (opening.packing) {
    case Opening::Packing::gzip:
      return open_packed(file, std::make_shared<GzipBytes>(file), options);
    case Opening::Packing::archived:
      return open_packed(file, std::make_shared<VsiBytes>(file, opening.name), options);
    case Opening::Packing::none:
      break;
  }
  return std::make_unique<CsvReader>(file, options);
}

/// Tells, as a notice, what parts the fields where that is no comma.
void tell_separator(const CsvReader& csv, Warnings& warnings) {
  const char separator = csv.separator();
  if (separator == ',') return;
  const std::string name = separator == '\t'  ? "tabs"
                           : separator == ';' ? "semicolons"
                                              : std::string("'") + separator + "'";
  warnings.add_notice({csv.file(), 0, "its fields are parted by " + name, {}});
}

}  // namespace

std::unique_ptr<CsvReader> open_csv(const std::string& file, const CsvOptions& options,
                                    Warnings& warnings) {
  auto csv = open(file, options);
  if (options.separator == '\0') tell_separator(*csv, warnings);
  return csv;
}

}  // namespace thiessen
