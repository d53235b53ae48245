// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/course_keys.hpp"
#include "core/base/error.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/schema.hpp"
#include "io/scene/table_file.hpp"
#include <fmt/format.h>
#include <numbers>

namespace io {
namespace {

/// Keys that say nothing beside the one that was chosen.
void check_idle_keys(const CourseKeys& keys, const std::string& path, const Locations& locations, Problems& problems)
{
    const auto check = [&](const char* key, bool idle, const char* other) {
        if (idle) problems.add(locations.at(path + "." + key), fmt::format("'{}' means nothing beside '{}'", key, other), "remove it");
    };
    check("between", keys.frequency && keys.between, "frequency");
    check("beyond", keys.frequency && keys.beyond, "frequency");
    check("mean", !keys.frequency && keys.mean, "table");
    check("amplitude", !keys.frequency && keys.amplitude, "table");
    check("phase", !keys.frequency && keys.phase, "table");
}

} // namespace

void describe(Schema& s, CourseKeys& p)
{
    s.exactly_one({"frequency", "table", "file"});
    s.value("frequency", p.frequency, "Hz", "Makes the factor mean + amplitude cos(2 pi frequency t + phase)", positive);
    s.value("mean", p.mean, "1", "With a frequency: mean of the factor; 0 without it");
    s.value("amplitude", p.amplitude, "1", "With a frequency: amplitude of the factor; 1 without it");
    s.value("phase", p.phase, "rad", "With a frequency: phase at t = 0; 0 without it");
    s.value("table", p.table, "s", "Points in time and the factor there");
    s.value("file", p.file, "", "A text file with such a point on each line, time in s and factor with a comma or blank between");
    s.value("between", "Between points of the table: straight lines, as without it, or cubics without extremes of their own",
            choice_of(p.between, between_points_words));
    s.value("beyond",
            "Where the run goes on beyond the table: hold its last value, or repeat it; without it, the table must reach to the end",
            choice_of(p.beyond, beyond_table_words));
}

void read_course_file(CourseKeys& keys, const std::string& path, const std::filesystem::path& folder, Locations& locations,
                      Problems& problems)
{
    if (keys.file.empty() || !locations.good(path)) return;
    try {
        for (const std::vector<double>& row : read_table_file(folder / keys.file, 2)) keys.table.push_back({row[0], row[1]});
        keys.file.clear();
    } catch (const core::ConfigError& error) {
        problems.add(locations.at(path + ".file"), error.what(), "");
        locations.spoil(path);
    }
}

void check_course(const CourseKeys& keys, const std::string& path, double until, const Locations& locations, Problems& problems)
{
    if (!locations.good(path)) return;
    check_idle_keys(keys, path, locations, problems);
    if (keys.frequency) return;
    const auto complain = [&](const std::string& message, const std::string& hint) { problems.add(locations.at(path), message, hint); };
    try {
        (void)course_of(keys);
    } catch (const core::ConfigError& error) {
        return complain(error.what(), "");
    }
    if (!keys.beyond && keys.table.back()[0] < until)
        complain(fmt::format("the table ends at {} s, before the run does at {} s", number_text(keys.table.back()[0]), number_text(until)),
                 "add beyond: hold, to go on with its last value, or beyond: repeat");
    if (!keys.beyond && keys.table.front()[0] > 0)
        complain(fmt::format("the table begins at {} s, after the run", number_text(keys.table.front()[0])),
                 "add a point at 0 s, or beyond: hold");
}

physics::TimeCourse course_of(const CourseKeys& keys)
{
    using physics::TableCourse;
    if (keys.frequency)
        return physics::HarmonicCourse{keys.mean.value_or(0), keys.amplitude.value_or(1), 2 * std::numbers::pi * *keys.frequency,
                                       keys.phase.value_or(0)};
    std::vector<TableCourse::Point> points;
    for (const auto& [time, value] : keys.table) points.push_back({time, value});
    return TableCourse(std::move(points), keys.between == BetweenPoints::cubic ? TableCourse::Between::cubic : TableCourse::Between::linear,
                       keys.beyond == BeyondTable::repeat ? TableCourse::Beyond::repeat : TableCourse::Beyond::hold);
}

} // namespace io
