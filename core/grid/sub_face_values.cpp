// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/sub_face_values.hpp"
#include "core/grid/side_stencil.hpp"
#include <map>

namespace core {

std::vector<HaloSource> centre_sources(const Topology& topology, const JoinedSubFace& face)
{
    auto sources = layer_stencil(topology, face.on_a, 0);
    for (HaloSource& s : sources) s.weight *= 1 - face.weight;
    for (HaloSource s : layer_stencil(topology, face.on_b, 0)) {
        s.weight *= face.weight;
        sources.push_back(s);
    }
    return sources;
}

SubFaceValues sub_face_values(const Topology& topology, BlockId block)
{
    SubFaceValues values;
    std::map<std::tuple<BlockId, int, int, int>, int> numbers; // of the cells beyond
    const auto add = [&](const SubFaceInterface& joint, const JoinedSubFace& face, bool is_a) {
        const BlockId other = is_a ? joint.contact.b : joint.contact.a;
        const Index3 beyond = is_a ? face.b : face.a;
        const auto [place, is_new] = numbers.try_emplace({other, beyond.i, beyond.j, beyond.k}, int(values.cells.size()));
        if (is_new) values.cells.push_back({other, beyond, Motion(), 1});
        const Side side = is_a ? joint.contact.side_a : joint.contact.side_b;
        values.faces.push_back({&face, is_a, side, is_a ? face.a : face.b, place->second, 0});
    };
    for (const SubFaceInterface& joint : topology.joints.interfaces)
        for (const bool is_a : {true, false}) {
            if ((is_a ? joint.contact.a : joint.contact.b) != block) continue;
            for (const JoinedSubFace& face : joint.faces) add(joint, face, is_a);
        }
    for (std::size_t n = 0; n < values.faces.size(); ++n) values.faces[n].at_centre = int(values.cells.size() + n);
    return values;
}

} // namespace core
