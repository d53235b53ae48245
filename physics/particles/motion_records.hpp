// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Position, velocity, spin and radius of each particle side by side: what a contact reads comes from two cache lines.
#include "core/particles/chunk_windows.hpp"

namespace physics {

/// Copies of the particles' columns, for as long as contacts read them.
class MotionRecords {
public:
    /// Of one particle: (x, y, z, 1 / mass, vx, vy, vz, 0), (wx, wy, wz, radius).
    struct alignas(32) Record {
        double motion[8], spin[4];
    };
    /// What the pairs of one segment see.
    struct View {
        const Record* records;
        const int* offset;
        /// Of particle i of the set. @pre it is in the window
        [[nodiscard]] const Record& operator[](int i) const
        {
            return records[i + offset[unsigned(i) / unsigned(core::particles_per_chunk)]];
        }
    };

    /// Makes room, and copies the ghosts. @param chunks  How the chunks of `pairs` will run.
    void plan(const core::ParticleSet& particles, const core::PairList& pairs, const core::ChunkPlan& chunks);
    /// Copies ghosts that have moved.
    void update_ghosts(const core::ParticleSet& particles);
    /// Copies what the pairs of `chunk` are the first of its segment to read.
    void enter(const core::ParticleSet& particles, int segment, int chunk)
    {
        for (const int next : windows_.enter[std::size_t(chunk)]) copy(particles, segment, next);
    }
    /// Copies a chunk in the place of those that have left its segment's window. @pre the pairs of the segment are done
    void copy(const core::ParticleSet& particles, int segment, int chunk);
    [[nodiscard]] View seen_by(int segment) const { return {records_.data(), windows_.offset[std::size_t(segment)].data()}; }
    [[nodiscard]] std::size_t bytes() const { return records_.capacity() * sizeof(Record); }

private:
    void update(const core::ParticleSet& particles, int begin, int end, int offset);
    core::ChunkWindows windows_;
    std::vector<Record> records_;
};

} // namespace physics
