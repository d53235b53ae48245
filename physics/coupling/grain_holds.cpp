// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/grain_holds.hpp"
#include "physics/coupling/contact_share.hpp"

namespace physics {

double GrainHolds::changed(const GrainImpulses& now, core::BlockId block, std::int64_t id, double share) const
{
    const auto found = before_.find(id);
    if (found == before_.end() || found->second.block != block) return share;
    const core::Vec3 contact = now.contact - found->second.impulses.contact, applied = now.applied - found->second.impulses.applied;
    return changed_share(share, contact.dot(applied), applied.squaredNorm(), now.applied.squaredNorm());
}

void GrainHolds::find(std::span<const std::int64_t> ids, const GrainPlaces& places, std::vector<GrainImpulses> now)
{
    now_ = std::move(now);
    hold_.resize(now_.size());
    for (std::size_t g = 0; g < now_.size(); ++g) {
        const double share = contact_share(now_[g].contact.dot(now_[g].applied), now_[g].applied.squaredNorm());
        hold_[g] = before_.empty() ? share : changed(now_[g], places.location(int(g)).block, ids[g], share);
    }
}

void GrainHolds::remember(std::span<const std::int64_t> ids, const GrainPlaces& places)
{
    before_.clear();
    for (std::size_t g = 0; g < now_.size(); ++g) before_[ids[g]] = {places.location(int(g)).block, now_[g]};
}

} // namespace physics
