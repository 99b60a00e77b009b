#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/number.h"
#include "base/temporary_folder.h"
#include "files/study_files.h"
#include "study/study.h"

namespace thiessen {

/// A study in a plane: 16 gauges in a square of 8 by 8, the basin, whose elevations are 100 (x + y)
/// but for a bump, and a raster of the ground's elevations with pixels of 1.
struct MountainStudy {
  /// The elevation of the ground at the middle of a pixel.
  static double ground(double x, double y) { return 100 * (x + y) + (x > 4 ? 300 : 0); }

  TemporaryFolder folder = {};
  std::shared_ptr<StudyFiles> files = std::make_shared<StudyFiles>();
  std::unique_ptr<Study> study = {};
  Warnings warnings = {};

  MountainStudy() {
    files->metric = Metric::planar;
    files->stations_file = "s.csv";
    files->basins_file = "b.csv";
    files->has_basins = true;
    files->elevation_field = "elev";
    for (int i = 0; i < 16; ++i) {
      // A little apart from a lattice, so that distances differ.
      const double x = 1.1 + 1.9 * (i % 4) + 0.05 * (i / 4);
      const double y = 0.9 + 1.9 * (i / 4) - 0.04 * (i % 4);
      add_station("g" + std::to_string(i), {x, y}, ground(x, y));
    }
    files->basins = {{"B", {{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {}}}, {}}};
    files->basin_elevations = {{"B", 1000}};
  }

  void add_station(const std::string& id, Point at, double elevation) {
    files->stations.push_back({id, at, files->stations.size() + 2});
    files->stations_have_lines = true;
    files->station_elevations[id] = elevation;
  }
  /// Is called once, when all parts are there.
  const Study& made() {
    study = std::make_unique<Study>(files, StudySettings{}, warnings);
    return *study;
  }
  /// Writes a raster over the basin, of what `value` says at the middles of its pixels, of which
  /// there are so many along each side.
  std::string raster(const std::function<double(double, double)>& value = ground,
                     const std::string& name = "dem.asc", int pixels = 8) const {
    const std::string count = std::to_string(pixels);
    const double side = 8.0 / pixels;
    std::string text = "ncols " + count + "\nnrows " + count +
                       "\nxllcorner 0\nyllcorner 0\ncellsize " + shortest_text(side) +
                       "\nNODATA_value -9999\n";
    for (int row = 0; row < pixels; ++row) {
      for (int column = 0; column < pixels; ++column)
        text += shortest_text(value((column + 0.5) * side, 8 - (row + 0.5) * side)) + " ";
      text += "\n";
    }
    return folder.write(name, text);
  }
  /// The notices as sentences, without the folder's name.
  std::vector<std::string> notices() const {
    std::vector<std::string> texts;
    for (const Message& notice : warnings.notices()) texts.push_back(notice.text.plain());
    return texts;
  }
  /// The texts of an error's messages.
  static std::vector<std::string> faults_of(const std::function<void()>& call) {
    try {
      call();
    } catch (const Error& error) {
      std::vector<std::string> texts;
      for (const Message& message : error.messages()) texts.push_back(message.text.plain());
      return texts;
    }
    return {};
  }
};

}  // namespace thiessen
