#include "gdal/crs/crs.h"

#include <cpl_conv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/crs/proj_objects.h"
#include "gdal/crs/spheres.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_text = 65536;

struct Fault {
  std::string text;
};

bool same_system(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  const GdalErrors errors;
  static constexpr std::array<const char*, 3> how = {
      "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
      nullptr};
  return a.IsSame(&b, how.data()) != 0;
}

/// Whether a definition tells PROJ to read a grid from a path or a server. A grid by a name of
/// PROJ's own is allowed.
bool names_outside_file(const std::string& text) {
  const std::string lower = lower_case(text);
  for (const char* key : {"grids=", "parameterfile[", "+file=", "+xy_grids", "+z_grids"}) {
    for (std::size_t at = lower.find(key); at != std::string::npos; at = lower.find(key, at + 1)) {
      const std::size_t end = lower.find_first_of(" ]", at);
      const std::string value = lower.substr(at, end == std::string::npos ? end : end - at);
      if (value.find('/') != std::string::npos) return true;
    }
  }
  return false;
}

std::string code_or_name(const OGRSpatialReference& system) {
  const char* authority = system.GetAuthorityName(nullptr);
  const char* code = system.GetAuthorityCode(nullptr);
  if (authority != nullptr && code != nullptr) return std::string(authority) + ":" + code;
  const char* name = system.GetName();
  return name == nullptr ? "unnamed" : name;
}

/// What a CRS of a file is called that has neither code nor name: its text in PROJ's notation.
std::string proj_text_of(const OGRSpatialReference& system) {
  const GdalErrors errors;
  char* text = nullptr;
  const bool known = system.exportToProj4(&text) == OGRERR_NONE && text != nullptr;
  std::string name = known ? quoted(text, 80) : "unknown";
  CPLFree(text);
  return name;
}

std::string wkt_of(const OGRSpatialReference& system) {
  static constexpr std::array<const char*, 3> how = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  char* text = nullptr;
  system.exportToWkt(&text, how.data());
  std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

void require_earth(const OGRSpatialReference& system) {
  if (system.IsGeographic() == 0 && system.IsProjected() == 0) {
    throw Fault{"is neither geographic nor projected"};
  }
  OGRErr failed = OGRERR_NONE;
  const double radius = system.GetSemiMajor(&failed);
  if (failed != OGRERR_NONE || !(radius > 6.3e6 && radius < 6.5e6)) {
    throw Fault{"is not of the Earth"};
  }
}

/// Makes a Crs of a system of GDAL's; `otherwise` is its name where it has neither code nor name.
Crs define(const OGRSpatialReference& given, const std::string& otherwise) {
  auto definition = std::make_shared<Crs::Definition>();
  OGRSpatialReference& system = definition->system;
  system = given;
  system.StripVertical();
  if (system.GetAxesCount() > 2) system.DemoteTo2D(nullptr);
  require_earth(system);
  if (is_on_sphere(system)) system = without_shift(system, wkt_of(system));
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  definition->wkt = wkt_of(system);
  if (names_outside_file(definition->wkt))
    throw Fault{"names a file; only PROJ's own grids are used"};
  definition->name = code_or_name(system);
  if (definition->name == "unknown" || definition->name == "unnamed") definition->name = otherwise;
  definition->geographic = system.IsGeographic() != 0;
  definition->unit = definition->geographic
                         ? system.GetAngularUnits(nullptr) * 180 / std::numbers::pi
                         : system.GetLinearUnits(nullptr);
  // Definitions round pi/180; such a unit is the degree.
  if (std::abs(definition->unit - 1) < 1e-9) definition->unit = 1;
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  definition->is_wgs84 = same_system(system, wgs84);
  if (definition->is_wgs84) {
    // All names of WGS 84 get one definition, or PROJ might choose another shift of datum for each.
    system = wgs84;
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    definition->wkt = wkt_of(system);
  }
  return Crs(std::move(definition));
}

OGRSpatialReference parse(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.empty()) throw Fault{"is empty"};
  if (text.size() > longest_text) throw Fault{"is longer than 65536 bytes"};
  if (text.find('\0') != std::string_view::npos) throw Fault{"holds a NUL byte"};
  const std::string whole(text);
  const std::string lower = lower_case(whole);
  if (lower.find("+proj=pipeline") != std::string::npos ||
      lower.find("+step") != std::string::npos ||
      lower.starts_with("urn:ogc:def:coordinateoperation")) {
    throw Fault{"is a pipeline of operations, and no CRS"};
  }
  if (lower.find("+init=") != std::string::npos) {
    throw Fault{
        "says +init, which PROJ would read from a file: write EPSG:4326 for +init=epsg:4326"};
  }
  if (names_outside_file(whole)) throw Fault{"names a file; only PROJ's own grids are used"};
  static constexpr std::array<const char*, 3> closed = {"ALLOW_NETWORK_ACCESS=NO",
                                                        "ALLOW_FILE_ACCESS=NO", nullptr};
  const GdalErrors errors;
  OGRSpatialReference system;
  if (system.SetFromUserInput(whole.c_str(), closed.data()) != OGRERR_NONE) {
    throw Fault{"is not known to PROJ"};
  }
  return system;
}

}  // namespace

Crs Crs::from_text(std::string_view text, const Wording& subject) {
  start_gdal();
  require_proj_database();
  try {
    const OGRSpatialReference system = parse(text);
    const GdalErrors errors;
    return define(system, quoted(text, 80));
  } catch (const Fault& fault) {
    throw Error(Message{{},
                        0,
                        subject + " " + quoted(text, 80) + " " + fault.text,
                        "a CRS is EPSG:32633 or the like, WKT, or PROJ (+proj=utm +zone=33)"});
  }
}

Crs Crs::wgs84() {
  static const Crs shared = from_text("EPSG:4326", "WGS 84");
  return shared;
}

const std::string& Crs::wkt() const {
  return definition_->wkt;
}
const std::string& Crs::name() const {
  return definition_->name;
}
CoordinateKind Crs::kind() const {
  return {definition_->geographic, definition_->unit};
}

bool Crs::geographic() const {
  return definition_->geographic;
}
bool Crs::is_wgs84() const {
  return definition_->is_wgs84;
}
double Crs::degrees_per_unit() const {
  return definition_->geographic ? definition_->unit : 0;
}
double Crs::metres_per_unit() const {
  return definition_->geographic ? 0 : definition_->unit;
}

Crs Crs::over(const Box& area) const {
  Crs used = *this;
  used.area_ = area;
  return used;
}

bool Crs::same_as(const Crs& other) const {
  return definition_ == other.definition_ ||
         same_system(definition_->system, other.definition_->system);
}

std::optional<Crs> crs_from_system(const OGRSpatialReference& system, const std::string& file) {
  require_proj_database();
  const std::string name = code_or_name(system);
  if (system.IsLocal() != 0 || name.starts_with("Undefined")) return std::nullopt;
  const GdalErrors errors;
  try {
    return define(system, proj_text_of(system));
  } catch (const Fault& fault) {
    throw Error(Message{file, 0, "its CRS " + quoted(name, 80) + " " + fault.text, {}});
  }
}

}  // namespace thiessen
