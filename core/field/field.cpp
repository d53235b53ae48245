// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/field.hpp"

namespace core {
namespace {

template <std::size_t Arrays>
auto repeat(std::span<const Extents> cells)
{
    std::vector<std::array<Extents, Arrays>> shapes;
    for (const Extents e : cells) shapes.emplace_back().fill(e);
    return shapes;
}

auto faces(std::span<const Extents> cells)
{
    std::vector<std::array<Extents, 4>> shapes;
    for (const Extents e : cells)
        shapes.push_back(
            {Extents{e.ni + 1, e.nj, e.nk}, Extents{e.ni, e.nj + 1, e.nk}, Extents{e.ni, e.nj, e.nk + 1}, Extents{e.sub_faces, 1, 1}});
    return shapes;
}

FieldInfo without_halo(FieldInfo info)
{
    info.halo = 0;
    return info;
}

} // namespace

ScalarField::ScalarField(FieldInfo info, std::span<const Extents> cells) : FieldStorage(std::move(info), repeat<1>(cells)) {}

VectorField::VectorField(FieldInfo info, std::span<const Extents> cells)
    : FieldStorage(std::move(info), repeat<3>(cells), Components::vector)
{
}

TensorField::TensorField(FieldInfo info, std::span<const Extents> cells)
    : FieldStorage(std::move(info), repeat<9>(cells), Components::tensor)
{
}

FaceField::FaceField(FieldInfo info, std::span<const Extents> cells) : FieldStorage(without_halo(std::move(info)), faces(cells)) {}

} // namespace core
