// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/grain_file.hpp"
#include "core/base/error.hpp"
#include "io/files/checkpoint.hpp"
#include "io/scene/problems.hpp"
#include "io/scene/table_file.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace io {
namespace {

constexpr std::size_t at_rest = 6, moving = 9; // columns
constexpr std::size_t species_column = 5;

/// A line of a table, which knows where it stands.
struct Line {
    const std::filesystem::path& file;
    int number;
    std::vector<Word> words;

    [[noreturn]] void refuse(std::size_t word, const std::string& message) const
    {
        throw core::ConfigError(
            fmt::format("{}:{}:{}: {}", file.string(), number, words[std::min(word, words.size() - 1)].column, message));
    }
    [[nodiscard]] double number_at(std::size_t word) const
    {
        double value = 0;
        if (!is_number(words[word].text, value)) refuse(word, fmt::format("'{}' is not a number", words[word].text));
        return value;
    }
};

std::int32_t species_of(const Line& line, const std::vector<std::string>& names)
{
    const std::string& word = line.words[species_column].text;
    const auto named = std::find(names.begin(), names.end(), word);
    if (named != names.end()) return std::int32_t(named - names.begin());
    double number = -1;
    if (is_number(word, number) && number == std::floor(number) && number >= 0 && number < double(names.size()))
        return std::int32_t(number);
    line.refuse(species_column, fmt::format("the scene has no species '{}'; {}", word, suggestion(word, names)));
}

core::Sphere grain_of(const Line& line, const std::vector<std::string>& names)
{
    core::Sphere sphere;
    sphere.position = {line.number_at(0), line.number_at(1), line.number_at(2)};
    sphere.radius = 0.5 * line.number_at(3);
    sphere.density = line.number_at(4);
    sphere.species = species_of(line, names);
    if (line.words.size() == moving) sphere.velocity = {line.number_at(6), line.number_at(7), line.number_at(8)};
    if (sphere.radius <= 0) line.refuse(3, "a diameter must be positive");
    if (sphere.density <= 0) line.refuse(4, "a density must be positive");
    return sphere;
}

} // namespace

bool is_checkpoint(const std::filesystem::path& path) { return path.extension() == ".h5" || std::filesystem::is_directory(path); }

std::vector<core::Sphere> grains_of_table(const std::filesystem::path& file, const std::vector<std::string>& names)
{
    std::vector<core::Sphere> grains;
    for_each_line(file, [&](int number, const std::string&, std::vector<Word> words) {
        const Line line{file, number, std::move(words)};
        double unused = 0;
        if (grains.empty() && number == 1 && !is_number(line.words.front().text, unused)) return; // names of the columns
        if (line.words.size() != at_rest && line.words.size() != moving)
            line.refuse(0, fmt::format("{} or {} columns are needed (x y z diameter density species, and a velocity), not {}", at_rest,
                                       moving, line.words.size()));
        grains.push_back(grain_of(line, names));
    });
    core::require<core::ConfigError>(!grains.empty(), fmt::format("{} has no particles", file.string()));
    return grains;
}

std::vector<core::Sphere> grains_of_checkpoint(const std::filesystem::path& path, const core::Communicator& ranks)
{
    std::string file = path.string();
    if (std::filesystem::is_directory(path)) file = newest_good_checkpoint(file, ranks).path;
    core::require<core::ConfigError>(!file.empty(), fmt::format("{} has no good checkpoint", path.string()));
    const CheckpointReader reader(file, ranks);
    core::require<core::ConfigError>(reader.has_rows("particles/id"), fmt::format("{} has no particles", file));
    const std::int64_t count = reader.row_count("particles/id");
    const auto column = [&](const char* name) { return reader.rows<double>(std::string("particles/") + name, 0, count); };
    const auto position = column("position"), velocity = column("velocity"), spin = column("spin"), radius = column("radius"),
               mass = column("mass");
    const auto species = reader.rows<std::int64_t>("particles/species", 0, count);
    std::vector<core::Sphere> grains{std::size_t(count)};
    const auto vector = [](const std::vector<double>& values, std::size_t n) {
        return core::Vec3(values[3 * n], values[3 * n + 1], values[3 * n + 2]);
    };
    for (std::size_t n = 0; n < grains.size(); ++n) {
        core::Sphere& g = grains[n];
        g.position = vector(position, n);
        g.velocity = vector(velocity, n);
        g.spin = vector(spin, n);
        g.radius = radius[n];
        g.density = mass[n] / (4.0 / 3.0 * std::numbers::pi * std::pow(g.radius, 3));
        g.species = std::int32_t(species[n]);
    }
    return grains;
}

} // namespace io
