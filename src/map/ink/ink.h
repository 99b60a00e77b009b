#pragma once

#include "map/ink/canvas.h"

namespace thiessen::ink {

inline constexpr Colour text{38, 42, 46};
inline constexpr Colour quiet_text{96, 101, 106};
inline constexpr Colour border{120, 125, 130};
inline constexpr Colour background{250, 250, 249};
inline constexpr Colour cell_edge{72, 80, 88};
inline constexpr Colour basin_edge{24, 28, 32};
inline constexpr Colour isohyet{12, 34, 92};
inline constexpr Colour gauge{168, 28, 36};
inline constexpr Colour voronoi{205, 24, 36};
inline constexpr Colour delaunay{28, 84, 196};
inline constexpr Colour white{255, 255, 255};
inline constexpr Colour no_reading{238, 238, 236};
inline constexpr Colour dry{240, 240, 240};
inline constexpr Colour hatch{190, 190, 187};

}  // namespace thiessen::ink
