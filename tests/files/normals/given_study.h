#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/temporary_folder.h"
#include "earth/yardstick.h"
#include "files/study_files.h"
#include "study/study.h"

namespace thiessen {

/// Two gauges and a basin of 8 by 4 that is parted halfway between them, in files.
struct GivenStudy {
  std::string stations = "id,x,y\na,2,2\nb,6,2\n";
  std::string basins = "id,WKT\nB,\"POLYGON((0 0,8 0,8 4,0 4,0 0))\"\n";
  std::string normal_field = {};
  Metric metric = Metric::planar;
  std::string crs = {};
  TemporaryFolder folder = {};
  Warnings warnings = {};
  std::shared_ptr<StudyFiles> files = {};
  std::unique_ptr<Study> study = {};

  void read() {
    StudyRequest request;
    request.metric = metric;
    request.stations.source.file = folder.write("s.csv", stations);
    request.stations.source.crs = crs;
    request.stations.normal_field = normal_field;
    request.basins.emplace().source.file = folder.write("b.csv", basins);
    request.basins->source.crs = crs;
    request.basins->source.crs_setting = "basins_crs";
    request.basins->normal_field = normal_field;
    Warnings of_files;
    files = std::make_shared<StudyFiles>(read_study(request, of_files));
    study = std::make_unique<Study>(files, StudySettings(), of_files);
  }
};

}  // namespace thiessen
