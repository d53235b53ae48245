// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Any kind of field as a list of arrays in each block, for those who only move numbers to and from files.
#include "core/field/field.hpp"

namespace io {

/// Which blocks of the mesh this rank has: own[b] is the global id of local block b.
struct BlockList {
    std::vector<core::BlockId> own;
    int total = 0; ///< blocks of all ranks together
};

/// The arrays of a field. T is double or const double.
template <class T>
struct FieldViews {
    std::string name;
    std::string unit;
    std::vector<std::vector<core::View<T>>> blocks; ///< [local block][component or axis]
};

[[nodiscard]] FieldViews<const double> views(const core::ScalarField& field);
[[nodiscard]] FieldViews<const double> views(const core::VectorField& field);
[[nodiscard]] FieldViews<const double> views(const core::FaceField& field);
[[nodiscard]] FieldViews<double> views(core::ScalarField& field);
[[nodiscard]] FieldViews<double> views(core::VectorField& field);
[[nodiscard]] FieldViews<double> views(core::FaceField& field);

/// Interior values of one block: array after array, i fastest.
[[nodiscard]] std::vector<double> interior(const std::vector<core::View<const double>>& arrays);
/// The reverse of interior(). @pre values has as many numbers as the interiors together.
void set_interior(const std::vector<core::View<double>>& arrays, std::span<const double> values);

/// Local blocks in ascending order of their global ids.
[[nodiscard]] std::vector<core::LocalBlock> in_global_order(const BlockList& blocks);

} // namespace io
