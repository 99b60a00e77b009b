#include "files/tables/netcdf_station_list.h"

#include <utility>

#include "base/number.h"

namespace thiessen {

NetcdfStationList::NetcdfStationList(std::string file) : file_(std::move(file)), stations_(file_) {
  stations_.find();
  for (const double one : stations_.all_of(*stations_.longitude()))
    longitudes_.push_back(shortest_text(one));
  for (const double one : stations_.all_of(*stations_.latitude()))
    latitudes_.push_back(shortest_text(one));
}

bool NetcdfStationList::next(Row& row) {
  if (next_ == stations_.count()) return false;
  row.line = next_ + 1;
  row.padded = false;
  row.fields = {stations_.ids()[next_], longitudes_[next_], latitudes_[next_]};
  ++next_;
  return true;
}

}  // namespace thiessen
