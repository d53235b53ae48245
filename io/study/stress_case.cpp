// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/stress_case.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace io {

static void describe(Schema& s, StressCriteria& p)
{
    for (std::size_t m = 0; m < measures.size(); ++m) s.value(measures[m].word, p.bounds[m], measures[m].unit, measures[m].meaning);
}

static void describe(Schema& s, StressVariant& p)
{
    s.required("name", p.name, "", "What differs");
    s.required("set", "Overrides of the scene, key.path=value", list_value(p.set, ""));
    s.value("refused", p.refused, "", "This run must end in an error with this text");
}

static void describe(Schema& s, StressContinuation& p)
{
    s.required("set", "Overrides of the scene, key.path=value", list_value(p.set, ""));
    s.required("steps", p.steps, "", "Steps to make", at_least(1));
}

void describe(Schema& s, StressCase& p)
{
    s.required("name", p.name, "", "Name of the case, that of the file");
    s.required("source", p.source, "", "Where the case comes from");
    s.required("meaning", p.meaning, "", "What would go wrong, and what must happen instead");
    s.required("scene", "The scene, or the path of its file or folder", scene_value(p.scene));
    s.value("steps", p.steps, "", "Steps to run, instead of run.until", at_least(1));
    s.value("squeeze", p.squeeze, "1", "Factor for the distances between the particles at the start", not_negative);
    s.list("variants", p.variants, "Runs that differ in some keys; all must pass");
    s.value("halve_dt", p.halve_dt, "", "How often the run is repeated, each time with half the time step", at_least(0));
    s.group("go_on", p.go_on, "Steps from a checkpoint of the end, as a scene with other keys");
    s.group("criteria", p.criteria, "What must hold: at most one value, or between two");
    s.value("same_bits", "Executors with which, or 'restart' after which, the final state must be the same", list_value(p.same_bits, ""));
    s.value("refused", p.refused, "", "The run must end in an error with this text");
}

Value value_of(Bounds& place, std::string_view unit, Range range)
{
    Value value = value_of(place.high, unit, range);
    value.read = [&place, u = std::string(unit), range](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::list) return value_of(place.high, u, range).read(node, reading);
        if (node.items.size() != 2) return reading.problems.add(node.mark, "one value or [low, high] is needed here");
        value_of(place.low, u, range).read(node.items[0], reading);
        value_of(place.high, u, range).read(node.items[1], reading);
    };
    return value;
}

std::vector<StressCase> read_stress_cases(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
    namespace fs = std::filesystem;
    core::require<core::ConfigError>(fs::is_directory(folder), fmt::format("there is no folder {}; give --cases", folder.string()));
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".yaml") found.push_back(entry.path().stem().string());
    std::sort(found.begin(), found.end());
    core::require<core::ConfigError>(!found.empty(), fmt::format("{} has no cases", folder.string()));
    for (const std::string& name : names)
        core::require<core::ConfigError>(std::binary_search(found.begin(), found.end(), name),
                                         fmt::format("there is no case '{}'; {}", name, suggestion(name, found)));
    std::vector<StressCase> cases;
    for (const std::string& name : names.empty() ? found : names) cases.push_back(read_described<StressCase>(folder / (name + ".yaml")));
    return cases;
}

} // namespace io
