// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/sub_face_values.hpp"
#include "core/grid/side_stencil.hpp"
#include <map>

namespace core {
namespace {

/// Linear between the two layers of cells beside the sub-face, each interpolated to its centre.
std::vector<HaloSource> centre_row(const Topology& topology, const JoinedSubFace& face)
{
    auto row = layer_stencil(topology, face.on_a, 0);
    for (HaloSource& s : row) s.weight *= 1 - face.weight;
    for (HaloSource s : layer_stencil(topology, face.on_b, 0)) {
        s.weight *= face.weight;
        row.push_back(s);
    }
    return row;
}

} // namespace

SubFaceValues sub_face_values(const Topology& topology, BlockId block)
{
    SubFaceValues values;
    std::map<std::tuple<BlockId, int, int, int>, int> numbers; // of the cells beyond
    const auto add = [&](const SubFaceInterface& joint, const JoinedSubFace& face, bool is_a) {
        const BlockId other = is_a ? joint.contact.b : joint.contact.a;
        const Index3 beyond = is_a ? face.b : face.a;
        const auto [place, is_new] = numbers.try_emplace({other, beyond.i, beyond.j, beyond.k}, int(values.rows.size()));
        if (is_new) values.rows.push_back({{other, beyond, Vec3::Zero(), 1}});
        values.faces.push_back({&face, is_a, is_a ? joint.contact.side_a : joint.contact.side_b, is_a ? face.a : face.b, place->second,
                                int(values.rows.size())});
        values.rows.push_back(centre_row(topology, face));
    };
    for (const SubFaceInterface& joint : topology.joints.interfaces)
        for (const bool is_a : {true, false}) {
            if ((is_a ? joint.contact.a : joint.contact.b) != block) continue;
            for (const JoinedSubFace& face : joint.faces) add(joint, face, is_a);
        }
    return values;
}

} // namespace core
