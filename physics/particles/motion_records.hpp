// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Position, velocity, spin and radius of each particle side by side: what a contact reads comes from two cache lines.
#include "core/particles/particle_set.hpp"

#include <span>

namespace physics {

/// A copy of the particles' columns, brought up to date by whoever moves particles.
class MotionRecords {
public:
    /// Of one particle: (x, y, z, 0), (vx, vy, vz, 0), (wx, wy, wz, radius).
    struct alignas(32) Record {
        double position[4], velocity[4], spin[4];
    };

    void resize(int particles) { records_.resize(std::size_t(particles)); }
    /// Copies particles [begin, end).
    void update(const core::ParticleSet& p, int begin, int end)
    {
        for (auto i = std::size_t(begin); i < std::size_t(end); ++i)
            records_[i] = {{p.position[0][i], p.position[1][i], p.position[2][i], 0.0},
                           {p.velocity[0][i], p.velocity[1][i], p.velocity[2][i], 0.0},
                           {p.spin[0][i], p.spin[1][i], p.spin[2][i], p.radius[i]}};
    }
    [[nodiscard]] const Record* data() const { return records_.data(); }

private:
    std::vector<Record> records_;
};

} // namespace physics
