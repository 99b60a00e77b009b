#include "rainfall/normals/fitted_normals.h"

#include <cmath>
#include <utility>

namespace thiessen {

FittedNormals::Known FittedNormals::known(std::span<const Point> places,
                                          std::span<const double> elevations,
                                          std::span<const double> normals) {
  Known known;
  known.number.resize(places.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    if (!(normals[place] > 0)) continue;
    known.number[place] = known.places.size();
    known.places.push_back(places[place]);
    known.elevations.push_back(elevations[place]);
    known.logarithms.push_back(std::log(normals[place]));
  }
  return known;
}

FittedNormals::FittedNormals(std::span<const Point> places, std::span<const double> elevations,
                             std::span<const double> normals, Metric metric, unsigned threads)
    : FittedNormals(known(places, elevations, normals), places, elevations, metric, threads) {}

FittedNormals::FittedNormals(Known known, std::span<const Point> places,
                             std::span<const double> elevations, Metric metric, unsigned threads)
    : number_(std::move(known.number)),
      kriging_(known.places, known.elevations, known.logarithms, metric, threads) {
  at_place_.reserve(places.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    const double logarithm = number_[place] ? known.logarithms[*number_[place]]
                                            : kriging_.at(places[place]).value(elevations[place]);
    at_place_.push_back(std::exp(logarithm));
  }
}

double FittedNormals::without(std::size_t place) const {
  if (!number_[place]) return at_place_[place];
  return std::exp(kriging_.told_without(*number_[place]));
}

}  // namespace thiessen
