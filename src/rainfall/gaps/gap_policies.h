#pragma once

#include <memory>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// The name of a policy, which its class gives itself.
const char* name_of(Gaps gaps);

/// Makes a policy for the gauges that the weigher weighs, with the normals of a month or of the
/// year. The weigher must outlive it. Cost: the
/// full network's weights; for retessellation also what the weigher keeps for it.
std::unique_ptr<const GapPolicy> gap_policy(Gaps gaps, const Weigher& weigher,
                                            const NormalMonth& month = {});

}  // namespace thiessen
