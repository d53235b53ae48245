// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A wall on its way: where it is in a sub-step, and how far it has gone since lists of what is near it were made.
#include "core/particles/bin_lattice.hpp"
#include "physics/particles/wall_motion.hpp"

#include <optional>

namespace physics {

/// When forces of a sub-step act: at `time`; velocities are known `half_step` earlier [s]. Without a time walls stand at their
/// places of t = 0.
struct WallTime {
    std::optional<double> time;
    double half_step = 0.0;
};

class WallFrame {
public:
    WallFrame() { stand(); }
    explicit WallFrame(const WallMotion& motion) : motion_(motion), moves_(motion.moves()) { stand(); }

    [[nodiscard]] bool moves() const { return moves_; }
    [[nodiscard]] const WallPose& now() const { return now_; }
    /// Half a step ago.
    [[nodiscard]] const WallPose& before() const { return before_; }

    void move_to(const WallTime& at)
    {
        if (!moves_) return;
        if (!at.time) return stand();
        now_ = motion_.at(*at.time);
        before_ = motion_.at(*at.time - at.half_step);
    }
    /// From here on way() and near_way() count.
    void mark_listed() { listed_ = now_; }
    void mark_chosen() { chosen_ = now_; }
    /// How far the wall has gone, where it can meet what is in `box`, since it was listed (upper bound) [m].
    [[nodiscard]] double way(const core::Bounds& box) const { return moves_ ? way_between(listed_, now_, box.low, box.high) : 0.0; }
    [[nodiscard]] double near_way(const core::Bounds& box) const { return moves_ ? way_between(chosen_, now_, box.low, box.high) : 0.0; }

private:
    void stand()
    {
        now_ = WallPose{};
        now_.axis_point = motion_.axis_point;
        before_ = now_;
    }

    WallMotion motion_;
    bool moves_ = false;
    WallPose now_, before_, listed_, chosen_;
};

} // namespace physics
