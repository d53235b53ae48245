// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene.hpp"

#include <algorithm>
#include <numbers>

namespace io {

PipeCells cells_of(PipeSize size)
{
    switch (size) {
    case PipeSize::small: return {12, 20};
    case PipeSize::medium: return {16, 32};
    case PipeSize::large: return {24, 48};
    }
    return {};
}

bool Grid::is_periodic(int axis) const
{
    return std::any_of(periodic.begin(), periodic.end(),
                       [&](Axis named) { return (named == Axis::axial ? 0 : static_cast<int>(named) - 1) == axis; });
}

std::string Grid::shape() const
{
    if (pipe) return "pipe";
    if (box) return "box";
    if (wavy_box) return "wavy_box";
    if (annulus) return "annulus";
    if (bent_pipe) return "bent_pipe";
    if (stepped_channel) return "stepped_channel";
    return blocks ? "blocks" : "";
}

core::Vec3 Grid::low() const
{
    if (pipe) return {0.0, -0.5 * pipe->diameter, -0.5 * pipe->diameter};
    return measure ? measure->low : core::Vec3(core::Vec3::Zero());
}

core::Vec3 Grid::high() const
{
    if (pipe) return {pipe->length, 0.5 * pipe->diameter, 0.5 * pipe->diameter};
    if (box) return box->size;
    return measure ? measure->high : core::Vec3(core::Vec3::Zero());
}

double Grid::volume() const
{
    if (pipe) return 0.25 * std::numbers::pi * pipe->diameter * pipe->diameter * pipe->length;
    if (box) return box->size.prod();
    return measure ? measure->volume : 0.0;
}

void Scene::resolve()
{
    if (grid.pipe && !grid.pipe->cells && !grid.pipe->size) grid.pipe->size = PipeSize::medium;
    if (fluid && !particles.empty() && !coupling) coupling.emplace();
}

DragLaw Coupling::chosen_drag() const
{
    if (drag) return *drag;
    return preset == CouplingPreset::seed ? DragLaw::seed : DragLaw::smooth;
}

MagnusLaw Coupling::chosen_magnus() const
{
    if (magnus) return *magnus;
    return preset == CouplingPreset::seed ? MagnusLaw::seed : MagnusLaw::lun_liu;
}

} // namespace io
