// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_profile.hpp"
#include "io/files/rank_zero.hpp"

namespace io {

WorldProfile::WorldProfile(const World& world, const std::filesystem::path& file, std::optional<double> restart_time) : bed_(world)
{
    std::vector<std::string> columns{"time", "height", "fraction", "speed"};
    for (const Species& species : world.scene().particles) columns.push_back("fraction_" + species.name);
    on_rank_zero<core::FileError>(world.ranks(), [&] { writer_.emplace(file, columns, restart_time); });
}

void WorldProfile::write(const World& world)
{
    const BedLayers layers = bed_.of(world);
    if (!writer_) return;
    std::size_t count = layers.count();
    while (count > 0 && layers.solid[count - 1] == 0) --count;
    for (std::size_t n = 0; n < count; ++n) {
        std::vector<double> row{world.time(), layers.middle(n), layers.fraction(n), layers.speed(n)};
        for (const auto& solid : layers.solid_of) row.push_back(layers.room[n] > 0 ? solid[n] / layers.room[n] : 0.0);
        writer_->add(row);
    }
}

void WorldProfile::flush()
{
    if (writer_) writer_->flush();
}

} // namespace io
