#include "files/rainfall_file.h"

#include "files/table_file.h"
#include "readings/dly_files.h"
#include "readings/readings_dly.h"

namespace thiessen {

std::unique_ptr<Readings> open_rainfall(const std::string& rainfall, char separator,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall)) {
    return open_dly_readings(rainfall, stations, passed_over, options, warnings);
  }
  if (options.keep_flagged) {
    throw Error({rainfall, 0, setting("keep_flagged") + " is for .dly files of GHCN-Daily", ""});
  }
  return open_readings(open_table(rainfall, separator, warnings), stations, passed_over, options,
                       warnings);
}

}  // namespace thiessen
