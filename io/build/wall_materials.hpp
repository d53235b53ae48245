// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What particles and walls of a scene are made of.
#include "io/scene/scene.hpp"

namespace io {

/// What a species is made of: what it says, or its own name.
[[nodiscard]] const std::string& material_of(const Species& species);

/// The materials of all walls, in the order of physics::ParticleParameters::walls.
class WallMaterials {
public:
    /// @pre scene.contact
    explicit WallMaterials(const Scene& scene);

    /// Each once; first that of walls that name none.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// The place of a wall's among the names.
    [[nodiscard]] int of(const WallKeys& wall) const { return place_of(wall.material); }
    /// The same of a side of the grid.
    [[nodiscard]] int of_side(const std::string& name) const;

private:
    void add(const std::string& material);
    [[nodiscard]] int place_of(const std::string& material) const;

    std::vector<ContactSide> sides_;
    std::vector<std::string> names_{std::string(wall_word)};
};

} // namespace io
