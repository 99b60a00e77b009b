"""Thiessen polygons and areal rainfall, exact anywhere on Earth.

    import thiessen
    study = thiessen.Study("stations.csv", "counties.geojson", "rainfall.csv")
    study.weights()          # basin, station, area_km2, weight
    study.rain()             # time, and a column for each basin

Stations, basins and readings are files, as the program `thiessen` reads them, or what is in memory: arrays, frames,
GeoJSON, WKB. The long options of the program's rain, weights and cells are keywords here, with `_` in place of `-`
(`from_` for --from, `with_` for --with), each of the call that it acts on. Those that say where a table goes and how it
is written, or are methods here, are no keywords: append, decimals, delaunay, format, help, influence, iso_times, long,
neighbours, output, output_layer, overwrite, study, units, version, weights_log.
"""

from ._thiessen import Error, __version__
from .study import Study, ThiessenWarning

__all__ = ["Error", "Study", "ThiessenWarning", "__version__"]
