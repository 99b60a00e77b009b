"""Thiessen polygons and areal rainfall, exact anywhere on Earth.

    import thiessen
    study = thiessen.Study("stations.csv", "counties.geojson", "rainfall.csv")
    study.weights()          # basin, station, area_km2, weight
    study.rain()             # time, and a column for each basin

Stations, basins and readings are files, as the program `thiessen` reads them, or what is in memory: arrays, frames,
GeoJSON, WKB. Every long option of the program is a keyword here, with `_` in place of `-` (`from_` for --from).
"""

from ._thiessen import Error, __version__
from .study import Study, ThiessenWarning

__all__ = ["Error", "Study", "ThiessenWarning", "__version__"]
