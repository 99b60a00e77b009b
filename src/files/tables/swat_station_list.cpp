#include "files/tables/swat_station_list.h"

#include <utility>

#include "files/tables/packed_file.h"
#include "text/csv_form.h"

namespace thiessen {

SwatStationList::SwatStationList(std::string file, SwatFile kind)
    : file_(std::move(file)), gauges_(swat_gauges(file_, kind, open_text)) {}

bool SwatStationList::next(Row& row) {
  if (next_ == gauges_.size()) return false;
  const SwatGauge& gauge = gauges_[next_++];
  row.line = next_;
  row.padded = false;
  row.fields = {gauge.id, gauge.longitude, gauge.latitude, gauge.elevation};
  return true;
}

SwatFile swat_file_called(const std::string& file) {
  return swat_file(beginning_of_text(file, csv_beginning_bytes));
}

}  // namespace thiessen
