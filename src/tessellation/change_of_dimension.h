#pragma once

#include "tessellation/structure.h"

namespace thiessen {

/// Makes the points span one dimension more, because `apex` lies off what they spanned: every
/// simplex gets the apex as a further corner, and a copy of every finite one gets the infinite
/// point instead. Requires that the structure has a position for the apex. Cost: linear in the
/// structure.
template <int Dimension>
void raise_dimension(Structure<Dimension>& structure, PointId apex);

/// Makes the points span one dimension less, because p was the last point off what the others span:
/// the simplices across from p are what is left. Frees p's number. Cost: linear in the structure.
template <int Dimension>
void lower_dimension(Structure<Dimension>& structure, PointId p);

}  // namespace thiessen
