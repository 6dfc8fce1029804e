#include "filling/size_field.h"

namespace loopmend {

SizeField::SizeField(const Points& places, const std::vector<double>& sizes) {
  const std::size_t stride = 1 + places.size() / 256;
  double mean = 0;
  for (std::size_t i = 0; i < places.size(); i += stride) {
    place_.push_back(places[i]);
    size_.push_back(sizes[i]);
    mean += sizes[i];
  }
  mean /= static_cast<double>(place_.size());
  floor_ = 0.01 * mean * mean;
}

double SizeField::at(const Vec3& p) const {
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const double d = (p - place_[k]).squaredNorm() + floor_;
    const double weight = 1 / (d * d);
    sum += weight * size_[k];
    total += weight;
  }
  return sum / total;
}

}  // namespace loopmend
