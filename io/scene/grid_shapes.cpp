// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/grid_shapes.hpp"
#include "io/scene/scene_source.hpp"

namespace io {

/// A list that may be left out.
static Value optional_list(std::vector<std::string>& place)
{
    Value value = list_value(place, "");
    value.write = [&place, write = value.write] { return place.empty() ? std::string() : write(); };
    return value;
}

void describe(Schema& s, SpacingKeys& p)
{
    s.required("boundary", p.boundary, "", "Name of the boundary, as `isago plan` lists it");
    s.required("first_cell", p.first_cell, "m", "Height of the cells at the boundary", positive);
    s.value("growth", p.growth, "1", "Largest ratio of one cell to the next; where walls curve, a little more if the height needs it",
            at_least(1.0));
}

void describe(Schema& s, AttractionKeys& p)
{
    s.value("block", p.block, "", "Number of the block", at_least(0));
    s.value("i", p.i, "1", "Index of the vertex along i; without it, all along i", not_negative);
    s.value("j", p.j, "1", "Index of the vertex along j; without it, all along j", not_negative);
    s.value("k", p.k, "1", "Index of the vertex along k; without it, all along k", not_negative);
    s.value("strength", p.strength, "1", "Logarithm of the growth of the cells next to the place; negative pushes lines away");
    s.value("reach", p.reach, "1", "Cells over which the pull falls to 1/e", positive);
}

void describe(Schema& s, EllipticKeys& p)
{
    s.list("spacing", p.spacing, "Heights of the cells at boundaries");
    s.list("attract", p.attract, "Places in index space that pull grid lines together: surfaces, lines and points");
    s.value("smooth", "Names of plane boundaries whose own vertices are generated too", optional_list(p.smooth));
    s.value("curvature", "spline: second order, as in Ushijima & Nezu (2001); compact: fourth order",
            choice_of(p.curvature, curvature_words));
}

void describe(Schema& s, WavyBoxGrid& p)
{
    s.required("size", p.size, "m", "Lengths of the edges of the box before it is bent; one corner is the origin", positive);
    s.required("cells", p.cells, "", "Cells along each edge", at_least(1));
    s.value("blocks", p.blocks, "", "Blocks along each edge; each divides the cells", at_least(1));
    s.required("amplitude", p.amplitude, "m", "Height of the waves: x moves by a sine of y, y by one of z, z by one of x", not_negative);
    s.value("waves", p.waves, "", "Waves along each edge", at_least(1));
}

void describe(Schema& s, AnnulusGrid& p)
{
    s.required("inner_diameter", p.inner_diameter, "m", "Diameter of the inner wall", positive);
    s.required("outer_diameter", p.outer_diameter, "m", "Diameter of the outer wall", positive);
    s.required("length", p.length, "m", "Length along the axis, which is x", positive);
    s.value("cells_along", p.cells_along, "", "Cells along the axis", at_least(1));
    s.value("cells_outwards", p.cells_outwards, "", "Cells from the inner to the outer wall", at_least(1));
    s.value("cells_around", p.cells_around, "", "Cells around the axis", at_least(3));
    s.value("blocks_along", p.blocks_along, "", "Blocks along the axis", at_least(1));
    s.value("blocks_outwards", p.blocks_outwards, "", "Blocks from the inner to the outer wall", at_least(1));
    s.value("blocks_around", p.blocks_around, "", "Blocks around the axis", at_least(1));
    s.value("growth", p.growth, "1", "Size of the outermost cell over that of the innermost", positive);
    s.value("angle", p.angle, "rad", "Angle of a sector, from y towards z, with 'grid.turn' to join its ends; without it, all round",
            positive);
}

void describe(Schema& s, PipePieceGrid& p)
{
    s.value("length", p.length, "m", "Length of a straight piece", positive);
    s.value("angle", p.angle, "rad", "Angle of an arc", positive);
    s.value("radius", p.radius, "m", "Radius of the axis of an arc, more than half the diameter", positive);
    s.value("towards", "Side to which an arc bends", direction_of(p.towards));
    s.value("cells", p.cells, "", "Cells along the piece", at_least(1));
    s.value("blocks", p.blocks, "", "Blocks along the piece, five in each section", at_least(1));
}

void describe(Schema& s, BentPipeGrid& p)
{
    s.required("diameter", p.diameter, "m", "Inner diameter", positive);
    s.value("across", p.across, "", "Cells over the diameter, a multiple of 4: half of them in the core", at_least(4));
    s.value("core_fraction", p.core_fraction, "1", "Half diagonal of the core over the radius", between(0.2, 0.8));
    s.list("pieces", p.pieces, "Straight pieces and arcs; the first begins at the origin and runs along x");
}

void describe(Schema& s, SteppedChannelGrid& p)
{
    s.required("shallow_length", p.shallow_length, "m", "Length of the shallow part along x", positive);
    s.required("deep_length", p.deep_length, "m", "Length of the deep part along x", positive);
    s.required("height", p.height, "m", "Height of the shallow part", positive);
    s.required("step", p.step, "m", "By which the deep part is deeper; its floor is y = 0", positive);
    s.required("width", p.width, "m", "Width along z", positive);
    s.value("cells_shallow", p.cells_shallow, "", "Cells along the shallow part", at_least(1));
    s.value("cells_deep", p.cells_deep, "", "Cells along the deep part", at_least(1));
    s.value("cells_height", p.cells_height, "", "Cells over the height of the shallow part", at_least(1));
    s.value("cells_step", p.cells_step, "", "Cells over the step", at_least(1));
    s.value("cells_across", p.cells_across, "", "Cells over the width", at_least(1));
    s.value("deep_cells_height", p.deep_cells_height, "",
            "Cells of the deep part over the height of the shallow one, if not as many: points of the "
            "two parts then need not match",
            at_least(1));
    s.value("deep_cells_across", p.deep_cells_across, "", "Cells of the deep part over the width, if not as many", at_least(1));
    s.value("blocks_shallow", p.blocks_shallow, "", "Blocks along the shallow part", at_least(1));
    s.value("blocks_deep", p.blocks_deep, "", "Blocks along the deep part", at_least(1));
    s.value("blocks_across", p.blocks_across, "", "Blocks over the width", at_least(1));
}

void describe(Schema& s, NamedSides& p)
{
    s.required("name", p.name, "", "Name of the boundary");
    s.required("sides",
               "Its sides, such as [0.k_low, 3.k_low]: number of the block in the file, from 0, and one of i_low, i_high, j_low, "
               "j_high, k_low, k_high",
               list_value(p.sides, ""));
}

void describe(Schema& s, ImportedGrid& p)
{
    s.required("file", p.file, "", "Plot3D file, text or binary, one block or many; relative to the folder of the scene");
    s.value("unit", p.unit, "m", "Length that the number 1 in the file stands for", positive);
    s.value("tolerance", p.tolerance, "1", "Points of sides that meet are at most this share of the side's smallest edge apart",
            between(1e-12, 0.2));
    s.value("period", p.period, "m", "Lengths after which the domain repeats along its periodic axes; without it, the extent of the grid");
    s.list("boundaries", p.boundaries, "Names of sides that meet no other");
    s.value("other_sides", p.other_sides, "", "Name of all sides that meet no other and have no name; without it, each must be named");
}

} // namespace io
