#include "readings/published/known_formats.h"

#include "readings/published/month_rows.h"
#include "readings/published/swat_files.h"
#include "readings/published/usgs_rdb.h"

namespace thiessen {

std::vector<PublishedFormat> known_formats() {
  const auto rows = published_formats();
  std::vector<PublishedFormat> all(rows.begin(), rows.end());
  all.push_back(ghcn_without_header());
  all.push_back(usgs_rdb_format());
  all.push_back(ana_format());
  all.push_back(swat_format());
  return all;
}

}  // namespace thiessen
