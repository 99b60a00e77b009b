#include "results/cell_features.h"

#include <unordered_set>

#include "base/utf8.h"

namespace thiessen {

std::vector<FieldName> attribute_fields(const CellFeatures& features) {
  if (features.attributes == nullptr) return {};
  std::unordered_set<std::string> taken = {"station", "basin",    features.area_column,
                                           "weight",  "rainfall", features.geometry_column};
  if (features.has_factor) taken.insert("factor");
  std::vector<FieldName> fields = features.attributes->fields;
  for (FieldName& field : fields) {
    while (!taken.insert(lower_case(field.name)).second) field.name += '_';
  }
  return fields;
}

}  // namespace thiessen
