#pragma once

#include <optional>
#include <string>

#include "gdal/crs.h"
#include "geometry/box.h"

namespace thiessen {

/// An operation of PROJ's between two CRSs, and what its authority says of it.
struct OperationChoice {
  std::string steps;               ///< a pipeline of PROJ's, east before north, in degrees or units
  std::string name;                ///< `NAD27 to WGS 84 (4)`
  std::optional<double> accuracy;  ///< metres; nothing where the authority states none
  /// The CRS on a sphere and without a datum whose longitudes and latitudes are taken for the other
  /// side's; empty: none.
  std::string sphere;
};

/// The most accurate operation whose grids are there and that is made for all of `area` (degrees;
/// its east may lie beyond 180), else the one made for most of it. Where no authority knows an
/// operation between the datums, see unknown_datum.h: longitudes and latitudes stay as they are, or
/// Error is thrown. Throws Error as well where every operation needs a grid that is not there,
/// naming it. Choices are remembered. Cost: some 10 ms, or 100 for reference frames that PROJ knows
/// well.
OperationChoice choose_operation(const Crs& from, const Crs& to, const std::optional<Box>& area);

/// To WGS 84 longitude and latitude, to a kilometre or so, whatever the datum; nothing where a grid
/// that the CRS itself names is not there.
std::optional<OperationChoice> choose_rough_operation(const Crs& from);

/// A grid that is not there and with which PROJ would be more accurate than `accuracy` metres;
/// empty: none.
std::string better_grid(const Crs& from, const Crs& to, const std::optional<Box>& area,
                        double accuracy);

}  // namespace thiessen
