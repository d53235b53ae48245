// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/field_views.hpp"

#include <algorithm>
#include <numeric>

namespace io {
namespace {

template <class T>
std::vector<core::View<T>> arrays(core::View<T> view)
{
    return {view};
}

template <class T>
std::vector<core::View<T>> arrays(const core::VectorView<T>& view)
{
    return {view.x, view.y, view.z};
}

template <class T>
std::vector<core::View<T>> arrays(const core::FaceView<T>& view)
{
    return {view.i, view.j, view.k, view.sub_faces};
}

template <class T, class Field>
FieldViews<T> views_of(Field& field)
{
    FieldViews<T> result{field.info().name, field.info().unit, {}};
    for (std::size_t b = 0; b < field.blocks(); ++b) result.blocks.push_back(arrays(field.on(core::LocalBlock(b))));
    return result;
}

} // namespace

FieldViews<const double> views(const core::ScalarField& field) { return views_of<const double>(field); }
FieldViews<const double> views(const core::VectorField& field) { return views_of<const double>(field); }
FieldViews<const double> views(const core::FaceField& field) { return views_of<const double>(field); }
FieldViews<double> views(core::ScalarField& field) { return views_of<double>(field); }
FieldViews<double> views(core::VectorField& field) { return views_of<double>(field); }
FieldViews<double> views(core::FaceField& field) { return views_of<double>(field); }

std::vector<double> interior(const std::vector<core::View<const double>>& arrays)
{
    std::vector<double> values;
    for (const auto& view : arrays) {
        const core::Extents size = view.extents();
        for (int k = 0; k < size.nk; ++k)
            for (int j = 0; j < size.nj; ++j) values.insert(values.end(), view.row(j, k), view.row(j, k) + size.ni);
    }
    return values;
}

void set_interior(const std::vector<core::View<double>>& arrays, std::span<const double> values)
{
    auto next = values.begin();
    for (const auto& view : arrays) {
        const core::Extents size = view.extents();
        for (int k = 0; k < size.nk; ++k)
            for (int j = 0; j < size.nj; ++j, next += size.ni) std::copy_n(next, size.ni, view.row(j, k));
    }
}

std::vector<core::LocalBlock> in_global_order(const BlockList& blocks)
{
    std::vector<core::LocalBlock> order(blocks.own.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return blocks.own[std::size_t(a)] < blocks.own[std::size_t(b)]; });
    return order;
}

} // namespace io
