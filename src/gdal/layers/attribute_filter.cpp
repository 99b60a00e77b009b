#include "gdal/layers/attribute_filter.h"

#include <cpl_string.h>
#include <ogr_feature.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

OGRFieldType ogr_type(FieldType type) {
  if (type == FieldType::integer) return OFTInteger64;
  return type == FieldType::real ? OFTReal : OFTString;
}

/// The fields that there are, where a filter asks for one that there is not.
std::string fields_in_words(const std::string& fault, const std::vector<FieldName>& fields) {
  if (fault.find("not recognised as an available field") == std::string::npos) return {};
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const FieldName& field : fields) names.push_back(field.name);
  return "; the fields are " + listed(names);
}

struct ReleaseDefinition {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

}  // namespace

struct AttributeFilter::Query {
  std::unique_ptr<OGRFeatureDefn, ReleaseDefinition> definition;
  std::unique_ptr<OGRFeature> feature;
  OGRFeatureQuery query;
  std::vector<std::size_t> asked;

  void find_asked();
};

void AttributeFilter::Query::find_asked() {
  const CPLStringList names(query.GetUsedFields());
  for (int i = 0; i < names.size(); ++i) {
    const int field = definition->GetFieldIndex(names[i]);
    if (field >= 0) asked.push_back(static_cast<std::size_t>(field));
  }
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
}

AttributeFilter::AttributeFilter(const std::string& where, const std::string& its_setting,
                                 const std::string& file, const std::vector<FieldName>& fields)
    : query_(std::make_unique<Query>()) {
  start_gdal();
  query_->definition.reset(new OGRFeatureDefn(""));
  query_->definition->Reference();
  for (const FieldName& field : fields) {
    OGRFieldDefn definition(field.name.c_str(), ogr_type(field.type));
    query_->definition->AddFieldDefn(&definition);
  }
  query_->feature = std::make_unique<OGRFeature>(query_->definition.get());
  const GdalErrors errors;
  if (query_->query.Compile(query_->definition.get(), where.c_str()) != OGRERR_NONE) {
    throw Error(Message{
        file,
        0,
        setting(its_setting, where) + ": " + errors.text() + fields_in_words(errors.text(), fields),
        {}});
  }
  query_->find_asked();
}

AttributeFilter::~AttributeFilter() = default;

const std::vector<std::size_t>& AttributeFilter::fields_asked() const {
  return query_->asked;
}

bool AttributeFilter::keeps(const Row& row) const {
  OGRFeature& feature = *query_->feature;
  const GdalErrors errors;
  feature.SetFID(static_cast<GIntBig>(row.line));
  for (const std::size_t i : query_->asked) {
    const int field = static_cast<int>(i);
    const std::string text(row.fields[i]);
    const OGRFieldType type = feature.GetFieldDefnRef(field)->GetType();
    if (text.empty()) {
      feature.SetFieldNull(field);
    } else if (type == OFTReal) {
      feature.SetField(field, parse_number(trimmed(text)).value);
    } else {
      feature.SetField(field, text.c_str());
    }
  }
  return query_->query.Evaluate(&feature) != FALSE;
}

}  // namespace thiessen
