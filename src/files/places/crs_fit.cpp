#include "files/places/crs_fit.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "study/coordinate_checks.h"

namespace thiessen {
namespace {

constexpr double farthest_longitude = 540;

/// Checks one file, whose CRS the user names by the setting `its_setting`.
template <typename File>
class Fit {
 public:
  Fit(const File& file, const std::string& lender, const char* its_setting)
      : file_(file), lender_(lender), its_setting_(its_setting), reach_(reach_of(file)) {}

  void require() const {
    const double widest = std::max(std::abs(reach_.west), std::abs(reach_.east));
    const double highest = std::max(std::abs(reach_.south), std::abs(reach_.north));
    if (file_.crs->geographic()) {
      const double nearest = std::min(widest, highest) * file_.crs->degrees_per_unit();
      const bool none = reach_.not_degrees == reach_.points;
      if (none && nearest > farthest_longitude) refuse("coordinates are not degrees", "", right());
      require_degrees(file_, file_.crs->kind(), lent() ? right() : Wording());
      return;
    }
    const double turn = lent() ? 360 : 180;
    if (widest <= turn && highest <= 90 && file_.crs->metres_per_unit() <= 1)
      refuse("coordinates look like degrees", ", which is projected", degrees());
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& kind,
                           const Wording& hint) const {
    throw Error(Message{file_.file, 0,
                        what + (", but " + claim()) + kind + ": " + reach_.sentence(), hint});
  }

  bool lent() const { return file_.crs_origin == CrsOrigin::lent; }

  /// Words the reason why the coordinates are taken to be in this CRS.
  Wording claim() const {
    const std::string name = file_.crs->name();
    switch (file_.crs_origin) {
      case CrsOrigin::option:
        return setting(its_setting_) + " says " + name;
      case CrsOrigin::columns:
        return "the names of its columns say " + name;
      case CrsOrigin::lent:
        return "it names no CRS and would take that of " + lender_ + ", " + name;
      case CrsOrigin::none:
      case CrsOrigin::implied:
      case CrsOrigin::file:
      case CrsOrigin::object:
        break;
    }
    return "its CRS is " + name;
  }

  // A setting against a CRS that the file names is refused, so it is no way out.
  Wording wrong_in_file() const {
    return "the CRS that stands in the file is not that of its coordinates; ogr2ogr -a_srs writes "
           "another";
  }
  static Wording wrong_in_object() {
    return "the CRS that stands with the coordinates is not theirs: hand them in with their own";
  }
  Wording right() const {
    if (file_.crs_origin == CrsOrigin::object) return wrong_in_object();
    return file_.crs_origin == CrsOrigin::file
               ? wrong_in_file()
               : "name the CRS that they are in with " + setting(its_setting_);
  }
  Wording degrees() const {
    if (file_.crs_origin == CrsOrigin::object) return wrong_in_object();
    if (file_.crs_origin == CrsOrigin::file) return wrong_in_file();
    return "longitude and latitude are " + setting(its_setting_, "EPSG:4326");
  }

  const File& file_;
  const std::string& lender_;
  const char* its_setting_;
  Reach reach_;
};

template <typename File>
void add_faults_of_range(const File& file, Complaints& complaints) {
  if (complaints.empty() || !file.crs || !file.crs->geographic()) return;
  const bool doubtful = file.crs_origin == CrsOrigin::implied;
  if (doubtful && !reach_of(file).looks_like_degrees()) return;
  try {
    require_degrees(file, file.crs->kind());
  } catch (const Error& error) {
    complaints.add(error);
  }
}

}  // namespace

void require_fit(const StationsFile& stations, const std::string& lender) {
  Fit(stations, lender, "crs").require();
}

void require_fit(const BasinsFile& basins, const std::string& lender) {
  Fit(basins, lender, "basins_crs").require();
}

void complain_of_range(const StationsFile& stations, Complaints& complaints) {
  add_faults_of_range(stations, complaints);
}

void complain_of_range(const BasinsFile& basins, Complaints& complaints) {
  add_faults_of_range(basins, complaints);
}

}  // namespace thiessen
