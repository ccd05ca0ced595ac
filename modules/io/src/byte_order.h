// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace posture {

enum class ByteOrder { LITTLE, BIG };

/// The unsigned integer as wide as T.
template <class T>
using BitsOf = std::conditional_t<
    sizeof(T) == 1,
    std::uint8_t,
    std::conditional_t<sizeof(T) == 2,
                       std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// \pre offset + sizeof(T) <= bytes.size()
template <class T>
T loadNumber(std::string_view bytes, std::size_t offset, ByteOrder order) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t at = order == ByteOrder::BIG ? i : sizeof(T) - 1 - i;
    bits = bits << 8 | static_cast<std::uint8_t>(bytes[offset + at]);
  }
  const auto narrow = static_cast<BitsOf<T>>(bits);
  T value;
  std::memcpy(&value, &narrow, sizeof value);
  return value;
}

template <class T>
void appendLittle(std::string& bytes, T value) {
  BitsOf<T> narrow;
  std::memcpy(&narrow, &value, sizeof value);
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes += static_cast<char>(static_cast<std::uint64_t>(narrow) >> (8 * i) & 0xff);
}

/// In four bytes, or in eight.
inline void appendReal(std::string& bytes, double value, bool as_float) {
  if (as_float)
    appendLittle(bytes, static_cast<float>(value));
  else
    appendLittle(bytes, value);
}

/// A number type as files name it.
enum class Scalar { INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64, FLOAT, DOUBLE };

constexpr std::size_t sizeOf(Scalar type) {
  constexpr std::size_t SIZES[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return SIZES[static_cast<int>(type)];
}

template <class T>
double loadAsDouble(std::string_view bytes, std::size_t offset, ByteOrder order) {
  return static_cast<double>(loadNumber<T>(bytes, offset, order));
}

/// \pre offset + sizeOf(type) <= bytes.size()
inline double loadScalar(std::string_view bytes, std::size_t offset, Scalar type, ByteOrder order) {
  using Load = double (*)(std::string_view, std::size_t, ByteOrder);
  constexpr Load LOADS[] = {loadAsDouble<std::int8_t>,
                            loadAsDouble<std::uint8_t>,
                            loadAsDouble<std::int16_t>,
                            loadAsDouble<std::uint16_t>,
                            loadAsDouble<std::int32_t>,
                            loadAsDouble<std::uint32_t>,
                            loadAsDouble<std::int64_t>,
                            loadAsDouble<std::uint64_t>,
                            loadAsDouble<float>,
                            loadAsDouble<double>};
  return LOADS[static_cast<int>(type)](bytes, offset, order);
}

}  // namespace posture
