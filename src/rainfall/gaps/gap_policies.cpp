#include "rainfall/gaps/gap_policies.h"

#include <stdexcept>
#include <type_traits>

#include "rainfall/gaps/renormalisation.h"
#include "rainfall/gaps/retessellation.h"
#include "rainfall/gaps/strictness.h"

namespace thiessen {
namespace {

/// Calls `use` with the class of a policy. A new policy needs a class and a line here; the compiler
/// warns of one that is forgotten.
template <typename Use>
auto with_policy(Gaps gaps, const Use& use) {
  switch (gaps) {
    case Gaps::retessellate:
      return use(std::type_identity<Retessellation>{});
    case Gaps::renormalise:
      return use(std::type_identity<Renormalisation>{});
    case Gaps::strict:
      return use(std::type_identity<Strictness>{});
  }
  throw std::logic_error("not a gap policy");
}

}  // namespace

const char* name_of(Gaps gaps) {
  return with_policy(gaps,
                     []<typename Policy>(std::type_identity<Policy>) { return Policy::name; });
}

std::unique_ptr<const GapPolicy> gap_policy(Gaps gaps, const Weigher& weigher,
                                            const NormalMonth& month) {
  return with_policy(gaps, [&]<typename Policy>(std::type_identity<Policy>) {
    return Policy::of(weigher, month);
  });
}

}  // namespace thiessen
