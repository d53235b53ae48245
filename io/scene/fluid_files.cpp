// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Files that the fluid of a scene refers to.
#include "core/base/error.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/table_file.hpp"
#include <fmt/format.h>

namespace io {

void read_fluid_files(Fluid& fluid, const std::filesystem::path& folder, Locations& locations, Problems& problems)
{
    if (fluid.drive && fluid.drive->over_time)
        read_course_file(*fluid.drive->over_time, "fluid.drive.over_time", folder, locations, problems);
    for (std::size_t n = 0; n < fluid.boundaries.size(); ++n) {
        Boundary& boundary = fluid.boundaries[n];
        const std::string path = fmt::format("fluid.boundaries.{}", n);
        if (boundary.over_time) read_course_file(*boundary.over_time, path + ".over_time", folder, locations, problems);
        if (boundary.profile_file.empty() || !locations.good(path + ".profile_file")) continue;
        boundary.profile_file = std::filesystem::absolute(folder / boundary.profile_file).lexically_normal().string();
        try {
            constexpr std::size_t place_and_velocity = 6;
            (void)read_table_file(boundary.profile_file, place_and_velocity);
        } catch (const core::ConfigError& error) {
            problems.add(locations.at(path + ".profile_file"), error.what(), "");
            locations.spoil(path);
        }
    }
}

} // namespace io
