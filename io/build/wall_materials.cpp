// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/wall_materials.hpp"

namespace io {

const std::string& material_of(const Species& species) { return species.material.empty() ? species.name : species.material; }

WallMaterials::WallMaterials(const Scene& scene) : sides_(scene.contact->sides)
{
    for (const ContactSide& side : sides_) add(side.material);
    for (const WallKeys& wall : scene.walls) add(wall.material);
}

void WallMaterials::add(const std::string& material)
{
    if (!material.empty() && std::find(names_.begin(), names_.end(), material) == names_.end()) names_.push_back(material);
}

int WallMaterials::place_of(const std::string& material) const
{
    return material.empty() ? 0 : int(std::find(names_.begin(), names_.end(), material) - names_.begin());
}

int WallMaterials::of_side(const std::string& name) const
{
    for (const ContactSide& side : sides_)
        if (side.at == name) return place_of(side.material);
    return 0;
}

} // namespace io
