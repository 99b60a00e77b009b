#include "readings/published/known_formats.h"

#include "readings/published/arcswat_files.h"
#include "readings/published/headerless_formats.h"
#include "readings/published/hourly_order.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_formats.h"
#include "readings/published/swat_files.h"
#include "readings/published/usgs_rdb.h"

namespace thiessen {

std::vector<PublishedFormat> known_formats() {
  const auto rows = published_formats();
  std::vector<PublishedFormat> all(rows.begin(), rows.end());
  const auto headerless = headerless_formats();
  all.insert(all.end(), headerless.begin(), headerless.end());
  all.push_back(usgs_rdb_format());
  all.push_back(hourly_order_format());
  all.push_back(ana_format());
  all.push_back(swat_format());
  all.push_back(arcswat_list_format());
  all.push_back(arcswat_gauge_format());
  return all;
}

}  // namespace thiessen
