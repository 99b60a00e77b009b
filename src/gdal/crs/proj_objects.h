#pragma once

#include <proj.h>

#include <memory>

namespace thiessen {

struct DestroyProj {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
  void operator()(PJ* object) const { proj_destroy(object); }
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const {
    proj_operation_factory_context_destroy(factory);
  }
};

using ProjContext = std::unique_ptr<PJ_CONTEXT, DestroyProj>;
using ProjObject = std::unique_ptr<PJ, DestroyProj>;
using ProjList = std::unique_ptr<PJ_OBJ_LIST, DestroyProj>;
using ProjFactory = std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, DestroyProj>;

/// A PROJ context that prints nothing and fetches nothing, whatever PROJ's own settings say.
ProjContext quiet_context();

/// Requires PROJ's database. Throws Error where it is missing or cannot be read, naming it. Cost: a
/// few milliseconds, once.
void require_proj_database();

}  // namespace thiessen
