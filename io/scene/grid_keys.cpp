// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/grid_keys.hpp"
#include "io/scene/schema.hpp"

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

void describe(Schema& s, PipeCells& p)
{
    s.required("across", p.across, "", "Cells over the diameter, a multiple of 4: half of them in the core", at_least(4));
    s.required("along", p.along, "", "Cells along the axis, a multiple of blocks_along", at_least(1));
}

void describe(Schema& s, PipeGrid& p)
{
    s.required("diameter", p.diameter, "m", "Inner diameter", positive);
    s.required("length", p.length, "m", "Length along the axis, which is x", positive);
    s.value("size", "Number of cells: small 2,160, medium 6,144 (the default), large 20,736", choice_of(p.size, pipe_size_words));
    s.group("cells", p.cells, "Cells of your own, instead of a named size");
    s.value("blocks_along", p.blocks_along, "", "Blocks along the axis, five in each section", at_least(1));
    s.value("core_fraction", p.core_fraction, "1", "Half diagonal of the core over the radius", between(0.2, 0.8));
}

void describe(Schema& s, BoxGrid& p)
{
    s.required("size", p.size, "m", "Lengths of the edges; one corner is the origin", positive);
    s.required("cells", p.cells, "", "Cells along each edge", at_least(1));
    s.value("blocks", p.blocks, "", "Blocks along each edge; each divides the cells", at_least(1));
}

void describe(Schema& s, TurnKeys& p)
{
    s.required("angle", p.angle, "rad", "Angle of the turn, by the right-hand rule; negative turns the other way");
    s.value("axis", "Direction of its axis", direction_of(p.axis));
    s.value("point", p.point, "m", "A point of its axis");
}

void describe(Schema& s, Grid& p)
{
    s.exactly_one({"pipe", "box", "wavy_box", "annulus", "bent_pipe", "stepped_channel", "blocks"});
    s.group("pipe", p.pipe, "A straight round pipe");
    s.group("box", p.box, "A rectangular box");
    s.group("wavy_box", p.wavy_box, "A box bent to sine waves");
    s.group("annulus", p.annulus, "The space between two round pipes");
    s.group("bent_pipe", p.bent_pipe, "A round pipe along straight pieces and arcs");
    s.group("stepped_channel", p.stepped_channel, "A channel whose floor steps down; with periodic ends, one with a trench");
    s.group("blocks", p.blocks, "Blocks from a file");
    s.group("elliptic", p.elliptic, "Generate the insides of all blocks by a Poisson system, from what lies on their sides");
    s.group("turn", p.turn, "A turn that carries the domain onto itself: sides that it lays on each other are joined");
    s.value("periodic", "Axes along which the domain repeats", choices_of(p.periodic, axis_words));
}

} // namespace io
