#include "gdal/crs/operation_choice.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "gdal/crs/proj_objects.h"
#include "gdal/crs/unknown_datum.h"

namespace thiessen {
namespace {

/// The limits within which PROJ may choose.
struct Allowed {
  std::optional<Box> area = {};
  bool all_grids = false;  ///< also operations with grids that are not installed
  bool ballpark = false;   ///< also leaving longitudes and latitudes as they are
  bool grids = true;       ///< also operations that work only as far as a grid
};

/// Chooses among PROJ's operations between two CRSs.
class Chooser {
 public:
  Chooser(const Crs& from, const Crs& to)
      : context_(quiet_context()),
        from_(proj_create(context_.get(), from.wkt().c_str())),
        to_(proj_create(context_.get(), to.wkt().c_str())),
        to_degrees_(to.is_wgs84()) {}

  /// The best operation that works in all of `reach`; empty where there is none.
  std::optional<OperationChoice> best(const Allowed& allowed,
                                      const std::optional<Box>& reach) const;
  /// The first grid that is not installed of the best operation that needs one and is more accurate
  /// than `accuracy` metres; empty where there is none.
  std::string missing_grid(const std::optional<Box>& area, double accuracy) const;

 private:
  ProjList candidates(const Allowed& allowed) const;
  bool serves(PJ* operation, const std::optional<Box>& area) const;
  std::string missing_grid_of(const PJ* operation) const;

  ProjContext context_;
  ProjObject from_;
  ProjObject to_;
  bool to_degrees_;
};

/// The operations, best first: those whose area of use holds most of the area, and among these the
/// most accurate.
ProjList Chooser::candidates(const Allowed& allowed) const {
  PJ_CONTEXT* context = context_.get();
  const ProjFactory factory(proj_create_operation_factory_context(context, nullptr));
  proj_operation_factory_context_set_spatial_criterion(context, factory.get(),
                                                       PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  proj_operation_factory_context_set_grid_availability_use(
      context, factory.get(),
      allowed.all_grids ? PROJ_GRID_AVAILABILITY_IGNORED
                        : PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID);
  proj_operation_factory_context_set_allow_ballpark_transformations(context, factory.get(),
                                                                    allowed.ballpark ? 1 : 0);
  if (allowed.area) {
    const Box& box = *allowed.area;
    const double east = box.high.x > 180 ? box.high.x - 360 : box.high.x;
    proj_operation_factory_context_set_area_of_interest(context, factory.get(), box.low.x,
                                                        box.low.y, east, box.high.y);
  }
  return ProjList(proj_create_operations(context, from_.get(), to_.get(), factory.get()));
}

std::optional<OperationChoice> Chooser::best(const Allowed& allowed,
                                             const std::optional<Box>& reach) const {
  const ProjList list = candidates(allowed);
  const int count = list ? proj_list_get_count(list.get()) : 0;
  for (int i = 0; i < count; ++i) {
    const ProjObject chosen(proj_list_get(context_.get(), list.get(), i));
    const ProjObject usual(proj_normalize_for_visualization(context_.get(), chosen.get()));
    if (!usual) continue;
    if (!allowed.grids && proj_coordoperation_get_grid_used_count(context_.get(), chosen.get()) > 0)
      continue;
    const char* steps = proj_as_proj_string(context_.get(), usual.get(), PJ_PROJ_5, nullptr);
    if (steps == nullptr) continue;
    OperationChoice choice{steps, proj_get_name(chosen.get()), {}, {}};
    // Where a grid is not installed, PROJ makes no operation of the text.
    const ProjObject operation(proj_create(context_.get(), choice.steps.c_str()));
    if (!operation || !serves(operation.get(), reach)) continue;
    const double accuracy = proj_coordoperation_get_accuracy(context_.get(), chosen.get());
    if (accuracy >= 0) choice.accuracy = accuracy;
    return choice;
  }
  return std::nullopt;
}

/// Whether the operation works in all of the area: its corners are transformed there and back,
/// which fails where a grid does not reach so far.
bool Chooser::serves(PJ* operation, const std::optional<Box>& area) const {
  if (!area || !to_degrees_) return true;
  for (const double x : {area->low.x, area->high.x}) {
    for (const double y : {area->low.y, area->high.y}) {
      PJ_COORD at = proj_coord(x, y, 0, HUGE_VAL);
      at = proj_trans(operation, PJ_FWD, proj_trans(operation, PJ_INV, at));
      if (!std::isfinite(at.xy.x) || !std::isfinite(at.xy.y)) return false;
    }
  }
  return true;
}

std::string Chooser::missing_grid_of(const PJ* operation) const {
  const int grids = proj_coordoperation_get_grid_used_count(context_.get(), operation);
  for (int g = 0; g < grids; ++g) {
    const char* name = nullptr;
    int there = 0;
    const int known = proj_coordoperation_get_grid_used(
        context_.get(), operation, g, &name, nullptr, nullptr, nullptr, nullptr, nullptr, &there);
    if (known != 0 && there == 0 && name != nullptr) return name;
  }
  return {};
}

std::string Chooser::missing_grid(const std::optional<Box>& area, double accuracy) const {
  const ProjList list = candidates({area, true, false});
  const int count = list ? proj_list_get_count(list.get()) : 0;
  for (int i = 0; i < count; ++i) {
    const ProjObject operation(proj_list_get(context_.get(), list.get(), i));
    const double its = proj_coordoperation_get_accuracy(context_.get(), operation.get());
    if (!(its < accuracy)) continue;
    std::string grid = missing_grid_of(operation.get());
    if (!grid.empty()) return grid;
  }
  return {};
}

OperationChoice choose(const Crs& from, const Crs& to, const std::optional<Box>& area) {
  const Chooser chooser(from, to);
  std::optional<OperationChoice> choice;
  if (area) choice = chooser.best({area}, area);
  if (!choice) choice = chooser.best({}, area);
  if (!choice) choice = chooser.best({}, {});
  if (choice) return *choice;
  const bool stays = may_be_taken_over(from, to);
  if (stays) choice = chooser.best({{}, false, true}, {});
  if (choice) {
    if (on_sphere(from) != on_sphere(to)) {
      choice->sphere = on_sphere(from) ? from.name() : to.name();
    }
    return *choice;
  }
  const std::string grid = chooser.missing_grid({}, std::numeric_limits<double>::infinity());
  if (!grid.empty()) fail_for_grid(from, to, grid);
  if (stays) fail_for_projection(from, to);
  fail_for_datum(from, to);
}

}  // namespace

OperationChoice choose_operation(const Crs& from, const Crs& to, const std::optional<Box>& area) {
  using Question = std::pair<std::array<std::string, 2>, std::array<double, 4>>;
  static std::mutex guard;
  static std::map<Question, OperationChoice> known;
  const Box box = area.value_or(Box{});
  const Question question{{from.wkt(), to.wkt()}, {box.low.x, box.low.y, box.high.x, box.high.y}};
  const std::lock_guard<std::mutex> lock(guard);
  const auto found = known.find(question);
  if (found != known.end()) return found->second;
  return known.emplace(question, choose(from, to, area)).first->second;
}

std::optional<OperationChoice> choose_rough_operation(const Crs& from) {
  const Chooser chooser(from, Crs::wgs84());
  auto choice = chooser.best({{}, false, true, false}, {});
  return choice ? choice : chooser.best({{}, false, true}, {});
}

std::string better_grid(const Crs& from, const Crs& to, const std::optional<Box>& area,
                        double accuracy) {
  return Chooser(from, to).missing_grid(area, accuracy);
}

}  // namespace thiessen
