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

} // namespace test
