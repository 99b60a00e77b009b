#include "gdal/crs/grid_mapping.h"

#include <array>
#include <string_view>

#include "base/number.h"
#include "gdal/crs/crs_definition.h"

namespace thiessen {
namespace {

/// A parameter of a projection in WKT, and what CF calls it.
struct Parameter {
  const char* wkt;
  const char* cf;
};

struct Projection {
  std::string_view wkt;
  const char* cf;
  std::array<Parameter, 4> parameters;  ///< the standard parallels come first, under one name
};

constexpr const char* parallel = "standard_parallel";
constexpr const char* meridian = "longitude_of_central_meridian";
constexpr const char* longitude = "longitude_of_projection_origin";
constexpr const char* latitude = "latitude_of_projection_origin";
constexpr const char* scale = "scale_factor_at_projection_origin";

constexpr std::array projections = {
    Projection{SRS_PT_TRANSVERSE_MERCATOR,
               "transverse_mercator",
               {{{SRS_PP_LATITUDE_OF_ORIGIN, latitude},
                 {SRS_PP_CENTRAL_MERIDIAN, meridian},
                 {SRS_PP_SCALE_FACTOR, "scale_factor_at_central_meridian"}}}},
    Projection{SRS_PT_LAMBERT_CONFORMAL_CONIC_2SP,
               "lambert_conformal_conic",
               {{{SRS_PP_STANDARD_PARALLEL_1, parallel},
                 {SRS_PP_STANDARD_PARALLEL_2, parallel},
                 {SRS_PP_LATITUDE_OF_ORIGIN, latitude},
                 {SRS_PP_CENTRAL_MERIDIAN, meridian}}}},
    Projection{SRS_PT_ALBERS_CONIC_EQUAL_AREA,
               "albers_conical_equal_area",
               {{{SRS_PP_STANDARD_PARALLEL_1, parallel},
                 {SRS_PP_STANDARD_PARALLEL_2, parallel},
                 {SRS_PP_LATITUDE_OF_CENTER, latitude},
                 {SRS_PP_LONGITUDE_OF_CENTER, meridian}}}},
    Projection{SRS_PT_LAMBERT_AZIMUTHAL_EQUAL_AREA,
               "lambert_azimuthal_equal_area",
               {{{SRS_PP_LATITUDE_OF_CENTER, latitude}, {SRS_PP_LONGITUDE_OF_CENTER, longitude}}}},
    Projection{SRS_PT_AZIMUTHAL_EQUIDISTANT,
               "azimuthal_equidistant",
               {{{SRS_PP_LATITUDE_OF_CENTER, latitude}, {SRS_PP_LONGITUDE_OF_CENTER, longitude}}}},
    Projection{SRS_PT_STEREOGRAPHIC,
               "stereographic",
               {{{SRS_PP_LATITUDE_OF_ORIGIN, latitude},
                 {SRS_PP_CENTRAL_MERIDIAN, longitude},
                 {SRS_PP_SCALE_FACTOR, scale}}}},
    Projection{SRS_PT_MERCATOR_1SP,
               "mercator",
               {{{SRS_PP_CENTRAL_MERIDIAN, longitude}, {SRS_PP_SCALE_FACTOR, scale}}}},
    Projection{SRS_PT_MERCATOR_2SP,
               "mercator",
               {{{SRS_PP_STANDARD_PARALLEL_1, parallel}, {SRS_PP_CENTRAL_MERIDIAN, longitude}}}},
    Projection{SRS_PT_SINUSOIDAL, "sinusoidal", {{{SRS_PP_LONGITUDE_OF_CENTER, longitude}}}},
};

void add_number(GridMapping& mapping, const char* name, double value) {
  if (!mapping.numbers.empty() && mapping.numbers.back().first == name) {
    mapping.numbers.back().second.push_back(value);
  } else {
    mapping.numbers.emplace_back(name, std::vector{value});
  }
}

void add_projection(GridMapping& mapping, const OGRSpatialReference& system) {
  const char* name = system.GetAttrValue("PROJECTION");
  for (const Projection& projection : projections) {
    if (name == nullptr || projection.wkt != name) continue;
    mapping.texts.emplace_back("grid_mapping_name", projection.cf);
    for (const Parameter& parameter : projection.parameters) {
      if (parameter.wkt == nullptr) break;
      add_number(mapping, parameter.cf, system.GetNormProjParm(parameter.wkt));
    }
    add_number(mapping, "false_easting", system.GetProjParm(SRS_PP_FALSE_EASTING));
    add_number(mapping, "false_northing", system.GetProjParm(SRS_PP_FALSE_NORTHING));
  }
}

std::string unit_of(double metres) {
  return metres == 1 ? "m" : shortest_text(metres) + " m";
}

}  // namespace

GridMapping grid_mapping(const Crs& crs) {
  const OGRSpatialReference& system = crs.definition().system;
  GridMapping mapping;
  if (crs.geographic()) {
    mapping.texts.emplace_back("grid_mapping_name", "latitude_longitude");
  } else {
    mapping.unit = unit_of(crs.metres_per_unit());
    add_projection(mapping, system);
  }
  add_number(mapping, "longitude_of_prime_meridian", system.GetPrimeMeridian());
  add_number(mapping, "semi_major_axis", system.GetSemiMajor());
  add_number(mapping, "inverse_flattening", system.GetInvFlattening());
  mapping.texts.emplace_back("crs_wkt", crs.wkt());
  return mapping;
}

}  // namespace thiessen
