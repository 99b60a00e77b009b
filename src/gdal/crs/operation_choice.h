#pragma once

#include <optional>
#include <string>

#include "gdal/crs/crs.h"
#include "geometry/box.h"

namespace thiessen {

/// An operation of PROJ's between two CRSs, and what its authority says of it.
struct OperationChoice {
  std::string steps;               ///< PROJ's pipeline, east before north, in degrees or units
  std::string name;                ///< such as `NAD27 to WGS 84 (4)`
  std::optional<double> accuracy;  ///< metres; empty where the authority states none
  /// The CRS on a sphere and without a datum whose longitudes and latitudes are taken to be those
  /// of the other side; empty where there is none.
  std::string sphere;
};

/// Chooses the most accurate operation whose grids are installed and that is made for all of `area`
/// (degrees; its east may lie beyond 180); where there is none, the one made for most of the area.
/// Where no authority knows an operation between the datums, see unknown_datum.h: longitudes and
/// latitudes stay as they are, or Error is thrown. Throws Error as well where every operation needs
/// a grid that is not installed, naming the grid. Choices are remembered. Cost: some 10 ms, or 100
/// for reference frames that PROJ knows well.
OperationChoice choose_operation(const Crs& from, const Crs& to, const std::optional<Box>& area);

/// Chooses an operation to WGS 84 longitude and latitude that is right to a kilometre or so,
/// whatever the datum; empty where a grid that the CRS itself names is not installed.
std::optional<OperationChoice> choose_rough_operation(const Crs& from);

/// The name of a grid that is not installed and with which PROJ would be more accurate than
/// `accuracy` metres; empty where there is none.
std::string better_grid(const Crs& from, const Crs& to, const std::optional<Box>& area,
                        double accuracy);

}  // namespace thiessen
