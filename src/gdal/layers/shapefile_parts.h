#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Requires the files of a shapefile to be whole and to belong together: each as long as its header
/// says, and as many shapes in the .shp as the .shx lists and the .dbf has records. GDAL itself
/// takes the least of these numbers, and gives names to the wrong shapes, in silence.
///
/// `name` is its .shp or .dbf as GDAL is given it, `file` as messages name it. A .dbf without a
/// .shp beside it is looked at alone; a .shp without a .dbf is noted among the `oddities`. Throws
/// Error, with the numbers that disagree. Cost: reads the .shx, and of the .shp two places.
void require_whole_shapefile(const std::string& file, const std::string& name,
                             std::vector<std::string>& oddities);

}  // namespace thiessen
