#include "rainfall/gaps/retessellation.h"

#include "rainfall/gaps/weigher.h"

namespace thiessen {

std::unique_ptr<const GapPolicy> Retessellation::of(const Weigher& weigher,
                                                    const NormalMonth& month) {
  return weigher.retessellation(month);
}

}  // namespace thiessen
