// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a value of a scene changes in time, as the user describes it: a factor that is harmonic, or given by a table.
#include "io/scene/problems.hpp"
#include "physics/fluid/time_course.hpp"
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;
class Locations;

enum class BetweenPoints { linear, cubic };
inline constexpr std::array<std::string_view, 2> between_points_words{"linear", "cubic"};

enum class BeyondTable { hold, repeat };
inline constexpr std::array<std::string_view, 2> beyond_table_words{"hold", "repeat"};

/// Points [time in s, factor] of a table.
using CoursePoints = std::vector<std::array<double, 2>>;

/// Exactly one of frequency, table and file is given; a file becomes the table when the scene is read.
struct CourseKeys {
    std::optional<double> frequency;       ///< [Hz]
    std::optional<double> mean, amplitude; ///< 0 and 1 without them
    std::optional<double> phase;           ///< [rad]; 0 without it
    CoursePoints table;
    std::string file;                     ///< relative to the scene's folder
    std::optional<BetweenPoints> between; ///< linear without it
    std::optional<BeyondTable> beyond;
    bool operator==(const CourseKeys&) const = default;
};

void describe(Schema& s, CourseKeys& p);

/// Reads the file of a table, if there is one.
/// @param path    Of the keys in the scene.
/// @param folder  That the file is relative to.
void read_course_file(CourseKeys& keys, const std::string& path, const std::filesystem::path& folder, Locations& locations,
                      Problems& problems);

/// Finds what only several keys together show.
/// @param until  Time at which the run ends [s].
void check_course(const CourseKeys& keys, const std::string& path, double until, const Locations& locations, Problems& problems);

[[nodiscard]] physics::TimeCourse course_of(const CourseKeys& keys);

} // namespace io
