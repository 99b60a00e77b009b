#include "rainfall/normals/normal_field.h"

#include <algorithm>

namespace thiessen {
namespace {

/// What a month says, or the mean of all months.
template <typename OfMonth>
double of_year(const NormalField& normals, const NormalMonth& month, const OfMonth& of_month) {
  if (month) return of_month(*month);
  if (normals.months() == 1) return of_month(0);
  double sum = 0;
  for (std::size_t m = 0; m < normals.months(); ++m) sum += of_month(m);
  return sum / static_cast<double>(normals.months());
}

}  // namespace

std::vector<NormalMonth> months_of(const NormalField* normals) {
  std::vector<NormalMonth> months;
  if (normals == nullptr) return months;
  for (std::size_t m = 0; m < normals->months(); ++m) months.emplace_back(m);
  if (months.size() > 1) months.emplace_back();
  return months;
}

std::size_t place_of(const NormalField* normals, const NormalMonth& month) {
  if (month) return *month;
  return normals == nullptr || normals->months() == 1 ? 0 : normals->months();
}

double normal_at_gauge(const NormalField& normals, StationIndex station, const NormalMonth& month) {
  return of_year(normals, month, [&](std::size_t m) { return normals.at_gauge(station, m); });
}

double normal_without(const NormalField& normals, StationIndex station, const NormalMonth& month) {
  return of_year(normals, month, [&](std::size_t m) { return normals.without(station, m); });
}

GroundNormal normal_over(const NormalField& normals, std::size_t basin,
                         std::span<const double> figures, double area, const NormalMonth& month) {
  const BasinNormals& ground = normals.in(basin);
  double covered = 1;
  const double mean = of_year(normals, month, [&](std::size_t m) {
    const GroundNormal normal = ground.of(figures, area, m);
    covered = std::min(covered, normal.covered);
    return normal.mean;
  });
  return {mean, covered};
}

double basin_normal(const NormalField& normals, std::size_t basin, const NormalMonth& month) {
  return of_year(normals, month, [&](std::size_t m) { return normals.in(basin).whole(m).mean; });
}

double normal_at(const NormalField& normals, std::size_t basin, Point p, const NormalMonth& month) {
  return of_year(normals, month, [&](std::size_t m) { return normals.in(basin).at(p, m); });
}

}  // namespace thiessen
