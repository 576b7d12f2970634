// Numbers of a study's file, which may hold any: only those that Foveola writes are taken.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "renderer/base/clock.h"

namespace foveola::study {

/// The number of a column. Throws SQLite::Exception, as for a damaged file, for one that `Number`
/// does not hold.
template <std::integral Number>
Number whole_number(const SQLite::Column& column) {
  const std::int64_t number = column.getInt64();
  if (!std::in_range<Number>(number)) {
    throw SQLite::Exception(
        fmt::format("{} has the value {}, which is out of range", column.getName(), number),
        SQLITE_CORRUPT);
  }
  return static_cast<Number>(number);
}

/// The same of JSON. Throws std::invalid_argument.
template <std::integral Number>
Number whole_number(const nlohmann::ordered_json& json) {
  if (json.is_number_unsigned()) {
    if (const auto number = json.get<std::uint64_t>(); std::in_range<Number>(number)) {
      return static_cast<Number>(number);
    }
  } else if (json.is_number_integer()) {
    if (const auto number = json.get<std::int64_t>(); std::in_range<Number>(number)) {
      return static_cast<Number>(number);
    }
  }
  throw std::invalid_argument(fmt::format("{} is not a whole number in its range",
                                          json.is_number() ? json.dump() : json.type_name()));
}

/// The place of a column in a list of so many. Throws SQLite::Exception as above.
template <std::integral Number>
Number place_in(const SQLite::Column& column, std::size_t count) {
  const auto place = whole_number<Number>(column);
  if (!std::in_range<std::size_t>(place) || static_cast<std::size_t>(place) >= count) {
    throw SQLite::Exception(
        fmt::format("{} has the value {}, of {} that there are", column.getName(), place, count),
        SQLITE_CORRUPT);
  }
  return place;
}

/// The number of a column, never -0, which tables do not keep and views of JSON do. Throws
/// SQLite::Exception as above for one that is not finite.
inline double finite_number(const SQLite::Column& column) {
  const double number = column.getDouble();
  if (!std::isfinite(number)) {
    throw SQLite::Exception(fmt::format("{} is not finite", column.getName()), SQLITE_CORRUPT);
  }
  return number + 0.0;
}

/// As above, of a JSON value. Throws std::invalid_argument if `Number` cannot hold it, and
/// nlohmann's exceptions if it is not a number.
template <std::floating_point Number>
Number finite_number(const nlohmann::ordered_json& json) {
  const auto number = json.get<double>();
  if (!(std::abs(number) <= double{std::numeric_limits<Number>::max()})) {
    throw std::invalid_argument(fmt::format("{} is out of range", number));
  }
  return static_cast<Number>(number);
}

/// Times of up to 73 years, forwards or backwards, whose sums and differences do not overflow.
/// Throws std::invalid_argument for others.
inline Nanoseconds time_from(std::int64_t ns) {
  constexpr std::int64_t longest_ns = std::int64_t{1} << 61;
  if (ns < -longest_ns || ns > longest_ns) {
    throw std::invalid_argument(fmt::format("a time of {} ns is out of range", ns));
  }
  return Nanoseconds(ns);
}

/// The same of a column. Throws SQLite::Exception.
inline Nanoseconds time_from(const SQLite::Column& column) {
  try {
    return time_from(column.getInt64());
  } catch (const std::invalid_argument& fault) {
    throw SQLite::Exception(fault.what(), SQLITE_CORRUPT);
  }
}

}  // namespace foveola::study
