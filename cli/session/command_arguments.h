#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/coordinates.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen::cli {

/// \file
/// Readers of the words that follow a command's name in a session. All throw Error where these are
/// not what the command takes.

/// Reads as many coordinates as there are dimensions, in the exact range; -0 becomes 0.
template <int Dimension>
CoordinatesIn<Dimension> read_coordinates(const std::string& command,
                                          const std::vector<std::string>& words);

/// Requires a single word, the name of a file.
std::string require_file(const std::string& command, const std::vector<std::string>& words);
void require_none(const std::string& command, const std::vector<std::string>& words);

/// The arguments of `show` and `watch`: FILE.png [--size WxH] [--dpi N], in the plane
/// [--window XMIN,YMIN,XMAX,YMAX], in space [--view X,Y,Z --site X,Y,Z].
struct ShowArguments {
  std::string file;
  std::optional<PlaneWindow> window;
  std::optional<View> view;
  PlotSize size;
};
ShowArguments read_show_arguments(const std::string& command, int dimension,
                                  const std::vector<std::string>& words);

}  // namespace thiessen::cli
