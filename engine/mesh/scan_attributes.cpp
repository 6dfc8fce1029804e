// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/scan_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace loopmend {

namespace {

/// Calls `with` with a value of the type.
template <class With>
auto visit(ScalarType type, const With& with) {
  switch (type) {
    case ScalarType::int8: return with(std::int8_t{});
    case ScalarType::uint8: return with(std::uint8_t{});
    case ScalarType::int16: return with(std::int16_t{});
    case ScalarType::uint16: return with(std::uint16_t{});
    case ScalarType::int32: return with(std::int32_t{});
    case ScalarType::uint32: return with(std::uint32_t{});
    case ScalarType::float32: return with(float{});
    case ScalarType::float64: break;
  }
  return with(double{});
}

template <class T>
T rounded(double value) {
  if constexpr (std::is_integral_v<T>) {
    constexpr double low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
    return std::isfinite(value) ? static_cast<T>(std::clamp(std::round(value), low, high)) : T{0};
  } else {
    return static_cast<T>(value);
  }
}

}  // namespace

std::size_t size_in_bytes(ScalarType type) {
  return visit(type, [](auto value) { return sizeof value; });
}

bool is_signed(ScalarType type) {
  return type != ScalarType::uint8 && type != ScalarType::uint16 && type != ScalarType::uint32;
}

bool is_integer(ScalarType type) { return type != ScalarType::float32 && type != ScalarType::float64; }

AttributeColumn::AttributeColumn(std::string name, ScalarType type, std::optional<ScalarType> count_type)
    : name_(std::move(name)),
      type_(type),
      count_type_(count_type) {}

std::size_t AttributeColumn::rows() const { return is_list() ? ends_.size() : bytes_.size() / size_in_bytes(type_); }

double AttributeColumn::value(std::size_t row, std::size_t item) const {
  const std::size_t place = is_list() ? begin(row) + item : row;
  return visit(type_, [&](auto value) {
    std::memcpy(&value, bytes_.data() + place * sizeof value, sizeof value);
    return static_cast<double>(value);
  });
}

void AttributeColumn::push(double value) {
  append(value);
  if (is_list()) end_list();
}

void AttributeColumn::append(double value) {
  visit(type_, [&](auto typed) {
    typed = rounded<decltype(typed)>(value);
    const std::size_t size = bytes_.size();
    bytes_.resize(size + sizeof typed);
    std::memcpy(bytes_.data() + size, &typed, sizeof typed);
    return 0;
  });
}

void AttributeColumn::pop_row() {
  bytes_.resize(bytes_.size() - items(rows() - 1) * size_in_bytes(type_));
  if (is_list()) ends_.pop_back();
}

void AttributeColumn::reserve(std::size_t rows) {
  if (is_list())
    ends_.reserve(rows);
  else
    bytes_.reserve(rows * size_in_bytes(type_));
}

const AttributeColumn* find_column(const std::vector<AttributeColumn>& columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name() == name; });
  return found == columns.end() ? nullptr : &*found;
}

AttributeRole role_of(std::string_view name) {
  constexpr std::array<std::string_view, 12> colors = {
      "red",         "green",         "blue",         "alpha",        "r", "g", "b", "a",
      "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"};
  if (std::find(colors.begin(), colors.end(), name) != colors.end()) return AttributeRole::color;
  return name == "nx" || name == "ny" || name == "nz" ? AttributeRole::normal : AttributeRole::other;
}

bool is_smooth(const AttributeColumn& column) {
  return !column.is_list() && (!is_integer(column.type()) || role_of(column.name()) == AttributeRole::color);
}

void copy_row(const AttributeColumn& from, int row, AttributeColumn& to) {
  if (!from.is_list()) return to.push(row < 0 ? 0 : from.value(static_cast<std::size_t>(row)));
  for (std::size_t k = 0; row >= 0 && k < from.items(static_cast<std::size_t>(row)); ++k)
    to.push_item(from.value(static_cast<std::size_t>(row), k));
  to.end_list();
}

}  // namespace loopmend
