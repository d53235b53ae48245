// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes in boxes side by side whose points need not match, which they read from a file as users do.
#include "core/grid/box.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/shared_folder.hpp"
#include <fmt/format.h>
#include <fstream>

namespace test {

/// A file of boxes, on all ranks.
class BoxesFile {
public:
    BoxesFile(const core::Communicator& ranks, const std::vector<core::Box>& boxes) : folder_(ranks)
    {
        if (ranks.rank() == 0) write(boxes);
        ranks.barrier();
    }
    [[nodiscard]] std::string path() const { return folder_.path() + "/boxes.p3d"; }
    /// The scene's grid, as text.
    [[nodiscard]] std::string grid(const std::string& periodic) const
    {
        return fmt::format("grid: {{ blocks: {{ file: '{}', other_sides: wall }}, periodic: [{}] }}\n", path(), periodic);
    }

private:
    void write(const std::vector<core::Box>& boxes) const
    {
        std::vector<core::Vertices> blocks;
        for (const core::Box& box : boxes)
            for (auto& block : core::make_box(box).blocks) blocks.push_back(std::move(block));
        std::ofstream file(path());
        file << blocks.size() << '\n';
        for (const auto& v : blocks) file << fmt::format("{} {} {}\n", v.extents().ni, v.extents().nj, v.extents().nk);
        for (const auto& v : blocks)
            for (int m = 0; m < 3; ++m)
                for (const core::Vec3& x : v.data()) file << fmt::format("{}\n", x[m]);
    }

    support::SharedFolder folder_;
};

/// Grains of two kinds in oil that is driven, over boxes that touch along x.
inline io::Scene bed_across_a_side(const BoxesFile& file, const std::string& mode)
{
    return scene_from_text("name: bed across a side\n" + file.grid("x, z") + R"(fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
  drive: { pressure_gradient: 2 kPa/m }
gravity: { direction: -y }
particles:
  - { name: heavy, count: 80, diameter: 1.5 mm, density: 2000 kg/m3 }
  - { name: light, count: 40, diameter: 1.2 mm, density: 1100 kg/m3 }
contact: { stiffness: 500 N/m, restitution: 0.6, friction: 0.4 }
coupling: { added_mass: on, lift: on, torque: on, mode: )" +
                           mode + R"( }
run: { settle: 50 ms, until: 1 s, time_step: 1 ms }
)");
}

} // namespace test
