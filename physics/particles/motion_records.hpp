// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Position, velocity, spin and radius of each particle side by side: what a contact reads comes from two cache lines.
#include "core/base/four.hpp"
#include "core/particles/particle_set.hpp"

#include <span>

namespace physics {

/// A copy of the particles' columns, brought up to date by whoever moves particles.
class MotionRecords {
public:
    /// Of one particle: (x, y, z, 1 / mass, vx, vy, vz, 0), (wx, wy, wz, radius).
    struct alignas(32) Record {
        double motion[8], spin[4];
    };

    void resize(int particles) { records_.resize(std::size_t(particles)); }
    /// Copies particles [begin, end).
    void update(const core::ParticleSet& p, int begin, int end)
    {
        auto i = std::size_t(begin);
        for (; i + 4 <= std::size_t(end); i += 4) update_four(p, i);
        for (; i < std::size_t(end); ++i)
            records_[i] = {{p.position[0][i], p.position[1][i], p.position[2][i], 1.0 / p.mass[i], p.velocity[0][i], p.velocity[1][i],
                            p.velocity[2][i], 0.0},
                           {p.spin[0][i], p.spin[1][i], p.spin[2][i], p.radius[i]}};
    }
    [[nodiscard]] const Record* data() const { return records_.data(); }

private:
    void update_four(const core::ParticleSet& p, std::size_t i)
    {
        const auto four = [i](const core::Column& column) { return core::load_four(column.data() + i); };
        core::Four x[] = {four(p.position[0]), four(p.position[1]), four(p.position[2]), 1.0 / four(p.mass)};
        core::Four v[] = {four(p.velocity[0]), four(p.velocity[1]), four(p.velocity[2]), core::Four{}};
        core::Four w[] = {four(p.spin[0]), four(p.spin[1]), four(p.spin[2]), four(p.radius)};
        for (auto* rows : {x, v, w}) core::transpose(rows[0], rows[1], rows[2], rows[3]);
        for (std::size_t k = 0; k < 4; ++k) {
            core::store_four(records_[i + k].motion, x[k]);
            core::store_four(records_[i + k].motion + 4, v[k]);
            core::store_four(records_[i + k].spin, w[k]);
        }
    }
    std::vector<Record> records_;
};

} // namespace physics
