// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What particles do to the walls of a scene's own, for metrics.csv.
#include "io/run/metric_groups.hpp"
#include <algorithm>
#include <span>

namespace io {

MetricGroup wall_metrics(World& world)
{
    std::vector<std::string> names;
    for (const WallKeys& wall : world.scene().walls)
        for (const char* what : {"force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z", "power"})
            names.push_back(wall.name + "_" + what);
    return {names, [&world] {
                std::vector<core::ExactSum::Digits> digits;
                for (const physics::WallLoad& load : world.grains()->loads())
                    for (const core::ExactSum& sum : load.sum) digits.push_back(sum.parts());
                world.ranks().sum(std::span(digits.front().data(), digits.size() * digits.front().size()));
                std::vector<double> values;
                for (const auto& parts : digits) {
                    core::ExactSum sum;
                    sum.add(parts);
                    values.push_back(sum.value() / std::max(1, world.grains()->load_steps()));
                }
                return values;
            }};
}

} // namespace io
