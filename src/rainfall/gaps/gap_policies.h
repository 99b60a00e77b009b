#pragma once

#include <memory>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// The name that the policy's class gives itself.
const char* name_of(Gaps gaps);

/// Makes the policy for what the weigher weighs. The weigher must outlive it. Cost: the full
/// network's weights, and to retessellate what the weigher keeps for it.
std::unique_ptr<const GapPolicy> gap_policy(Gaps gaps, const Weigher& weigher);

}  // namespace thiessen
