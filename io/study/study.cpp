// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study.hpp"
#include "core/base/error.hpp"
#include <fmt/format.h>

namespace io {

static void describe(Schema& s, StudyKnob& p)
{
    s.required("name", p.name, "", "What this is, in the table");
    s.required("set", "Overrides of the scene, key.path=value: one for each choice", list_value(p.set, ""));
}

static void describe(Schema& s, StudyVariation& p)
{
    s.value("cells", "Cells of a pipe: [across, along] for each choice", list_value(p.cells, "", at_least(1)));
    s.value("steps_per_period", "Time steps in a period of the drive", list_value(p.steps_per_period, "", at_least(4)));
    s.list("knobs", p.knobs, "Anything else in the scene");
    s.value("seeds", p.seeds, "", "Runs of each case of an ensemble, with run.random_seed from 1 on", at_least(0));
}

namespace {

struct Choice {
    std::string label;
    std::vector<std::string> overrides;
};

struct Dimension {
    std::string name;
    std::vector<Choice> choices;
};

std::vector<Dimension> axes_of(const Study& study, const Scene& base)
{
    std::vector<Dimension> axes;
    Dimension cells{"cells", {}}, steps{"steps", {}};
    for (const CellPair& n : study.vary.cells) {
        const std::string across = fmt::format("grid.pipe.cells.across={}", n.across),
                          along = fmt::format("grid.pipe.cells.along={}", n.along);
        cells.choices.push_back({fmt::format("{}x{}", n.across, n.along), {across, along}});
    }
    const double period = base.fluid && base.fluid->drive ? 1.0 / base.fluid->drive->frequency.value_or(1.0) : 1.0;
    for (const int n : study.vary.steps_per_period)
        steps.choices.push_back({std::to_string(n), {fmt::format("run.time_step={} s", number_text(period / n))}});
    if (study.error == StudyError::womersley)
        for (Choice& c : steps.choices) c.overrides.push_back(fmt::format("run.until={} s", number_text(study.periods * period)));
    if (!cells.choices.empty()) axes.push_back(cells);
    if (!steps.choices.empty()) axes.push_back(steps);
    for (const StudyKnob& knob : study.vary.knobs) {
        axes.push_back({knob.name, {}});
        for (const std::string& text : knob.set) axes.back().choices.push_back({text.substr(text.find('=') + 1), {text}});
    }
    Dimension seeds{std::string(seed_axis), {}};
    for (int n = 1; n <= study.vary.seeds; ++n) seeds.choices.push_back({std::to_string(n), {fmt::format("run.random_seed={}", n)}});
    if (!seeds.choices.empty()) axes.push_back(seeds);
    return axes;
}

/// Counts through all choices, the last axis fastest. @return false after the last.
bool next(std::vector<int>& choice, const std::vector<Dimension>& axes)
{
    for (std::size_t n = axes.size(); n-- > 0;) {
        if (++choice[n] < int(axes[n].choices.size())) return true;
        choice[n] = 0;
    }
    return false;
}

void check(const Study& study, const Scene& base)
{
    using core::ConfigError;
    const bool harmonic = base.fluid && base.fluid->drive && base.fluid->drive->frequency;
    core::require<ConfigError>(study.vary.steps_per_period.empty() || harmonic,
                               "vary.steps_per_period needs fluid.drive.frequency in the scene");
    core::require<ConfigError>((study.error == StudyError::ensemble) == (study.vary.seeds > 0),
                               "error: ensemble and vary.seeds need each other: write both, or neither");
    core::require<ConfigError>(study.vary.seeds != 1, "vary.seeds: one run has no confidence interval; write 2 or more, better 10");
    core::require<ConfigError>(study.error != StudyError::ensemble || !base.particles.empty(),
                               "error: ensemble needs particles: without them nothing in a scene is random");
    if (study.error != StudyError::womersley) return;
    core::require<ConfigError>(
        harmonic && base.fluid->drive->pressure_gradient && base.grid.pipe && base.particles.empty() && base.fluid->material.viscosity > 0,
        "error: womersley needs a scene of a pipe with fluid.drive.pressure_gradient and frequency, a viscosity and no particles");
    core::require<ConfigError>(!study.vary.steps_per_period.empty(), "error: womersley needs vary.steps_per_period");
}

} // namespace

Value value_of(CellPair& place, std::string_view unit, Range range)
{
    Value value = value_of(place.across, unit, range);
    value.read = [&place, range](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::list || node.items.size() != 2)
            return reading.problems.add(node.mark, "two whole numbers [across, along] are needed here", "write [24, 4]");
        value_of(place.across, "", range).read(node.items[0], reading);
        value_of(place.along, "", range).read(node.items[1], reading);
    };
    value.write = [&place] { return fmt::format("[{}, {}]", place.across, place.along); };
    return value;
}

void describe(Schema& s, Study& p)
{
    s.required("name", p.name, "", "What the study shows");
    s.required("scene", "The scene, or the path of its file or folder", scene_value(p.scene));
    s.required(
        "error",
        "womersley: against the exact oscillating flow, started from it; self: against the finest case; ensemble: none, but means over "
        "vary.seeds with 95 % confidence",
        choice_of(p.error, study_error_words));
    s.value("periods", p.periods, "", "Periods of the drive to run; the error is that of the last", at_least(1));
    s.value("repeats", p.repeats, "", "Runs of each case, of which the fastest counts", at_least(1));
    s.required_group("vary", p.vary, "What is varied: all combinations are run");
}

StudyPlan read_study(const std::filesystem::path& file)
{
    StudyPlan plan{read_described<Study>(file), {}, {}};
    const Scene base = plan.study.scene.read({});
    check(plan.study, base);
    const std::vector<Dimension> axes = axes_of(plan.study, base);
    core::require<core::ConfigError>(!axes.empty(), file.string() + ": 'vary' names nothing to vary");
    for (const Dimension& axis : axes) plan.axes.push_back(axis.name);
    std::vector<int> choice(axes.size(), 0);
    do {
        StudyCase one{choice, {}, {}};
        std::vector<std::string> overrides;
        for (std::size_t n = 0; n < axes.size(); ++n) {
            const Choice& c = axes[n].choices[std::size_t(choice[n])];
            one.labels.push_back(c.label);
            overrides.insert(overrides.end(), c.overrides.begin(), c.overrides.end());
        }
        one.scene = plan.study.scene.read(overrides);
        plan.cases.push_back(std::move(one));
    } while (next(choice, axes));
    return plan;
}

} // namespace io
