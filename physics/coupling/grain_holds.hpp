// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far contacts hold each grain in the pass that is being made: their share of its load, or, where a pass is repeated, of what
// its load changed by (contact_share.hpp).
#include "physics/coupling/grain_places.hpp"
#include <span>
#include <unordered_map>
#include <vector>

namespace physics {

/// Impulses on a grain over a step [N s].
struct GrainImpulses {
    core::Vec3 contact = core::Vec3::Zero(); ///< of its contacts
    core::Vec3 applied = core::Vec3::Zero(); ///< of all else
};

class GrainHolds {
public:
    /// The next pass is the first of a step.
    void forget() { before_.clear(); }
    /// Hold of each grain, in the order of `now`. What a grain received in another block in the pass before is not known here: blocks,
    /// not ranks, decide, so that the bits are those of one rank.
    /// @param ids  Of the grains.
    void find(std::span<const std::int64_t> ids, const GrainPlaces& places, std::vector<GrainImpulses> now);
    /// Keeps what was found last for the pass that follows.
    void remember(std::span<const std::int64_t> ids, const GrainPlaces& places);

    [[nodiscard]] double operator[](int grain) const { return hold_[std::size_t(grain)]; }

private:
    struct Record {
        core::BlockId block;
        GrainImpulses impulses;
    };
    [[nodiscard]] double changed(const GrainImpulses& now, core::BlockId block, std::int64_t id, double share) const;

    std::vector<GrainImpulses> now_;
    std::vector<double> hold_;
    std::unordered_map<std::int64_t, Record> before_;
};

} // namespace physics
