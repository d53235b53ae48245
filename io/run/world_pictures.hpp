// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures of a world while it runs: particles in the colours of their species between walls of glass, seen from the side.
#include "io/picture/picture_frame.hpp"
#include "io/picture/picture_worker.hpp"
#include "io/run/world.hpp"
#include "physics/particles/triangle_mesh.hpp"
#include <filesystem>

namespace io {

struct PictureStyle {
    enum class Slice { none, speed }; ///< the fluid's speed on the plane through the axis; particles before it are left out
    int width = 1600, height = 900;
    Slice slice = Slice::none;
};

/// Frames frame_<number>.png. Pictures never stop a run: what goes wrong is told once, and no more are made.
class WorldPictures {
public:
    /// @param folder  Of the frames; rank 0 makes it.
    WorldPictures(const World& world, std::filesystem::path folder, const PictureStyle& style = {});

    /// Gathers what is seen and leaves the drawing to a thread of rank 0. Collective.
    void draw(const World& world, std::int64_t number);
    /// Waits for the last picture.
    void finish();
    /// What went wrong since the last call, for the log of rank 0; empty if nothing did.
    [[nodiscard]] std::string take_warning();

private:
    /// A wall of the scene's own that has ends.
    struct OwnWall {
        physics::WallMotion motion;
        physics::TriangleMesh mesh;
        [[nodiscard]] Surface at(double time, const PictureFrame& frame) const;
    };
    [[nodiscard]] std::vector<ColouredQuad> slice(const World& world, const ColourBar& bar) const;

    std::filesystem::path folder_;
    PictureStyle style_;
    PictureFrame frame_;
    PictureScene still_; ///< camera, walls and legend: the same in all pictures
    std::vector<OwnWall> own_walls_;
    std::unique_ptr<PictureWorker> worker_;
};

} // namespace io
