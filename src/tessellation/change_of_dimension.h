#pragma once

#include "tessellation/structure.h"

namespace thiessen {

/// The points span one dimension more, for `apex` is off what they spanned: every simplex gets the
/// apex for a further corner, and every finite one is doubled with the infinite point for it. The
/// structure has a position for the apex. Cost: linear in the structure.
template <int Dimension>
void raise_dimension(Structure<Dimension>& structure, PointId apex);

/// The points span one dimension less, for p was the last one off what the others span: what is
/// left are the simplices across from it. Frees p's number. Cost: linear in the structure.
template <int Dimension>
void lower_dimension(Structure<Dimension>& structure, PointId p);

}  // namespace thiessen
