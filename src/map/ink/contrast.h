#pragma once

#include "base/colour.h"

namespace thiessen {

/// The colour that ground has under ink whose opacity is `alpha` / 255.
Colour blended(Colour ground, Colour ink, int alpha);

/// How well two colours are told apart, by a reader of grey print too: from 1, not at all, to 21,
/// black on white. It is the contrast ratio of the Web Content Accessibility Guidelines.
double contrast(Colour a, Colour b);

}  // namespace thiessen
