// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/stress_run.hpp"
#include "io/run/state_file.hpp"
#include "io/study/stress_probes.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdlib.h>

namespace io {
namespace {

/// A folder for checkpoints, removed at the end.
class Scratch {
public:
    Scratch()
    {
        std::string name = (std::filesystem::temp_directory_path() / "isago_stress_XXXXXX").string();
        core::require<core::FileError>(mkdtemp(name.data()) != nullptr, "no folder for checkpoints can be made at " + name);
        path_ = name;
    }
    ~Scratch()
    {
        std::error_code ignored; // what is left of a scratch folder harms nobody
        std::filesystem::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

/// Moves all particles towards their mean place.
void squeeze(World& world, double factor)
{
    core::ParticleSet& p = world.grains()->particles;
    core::Vec3 mean = core::Vec3::Zero();
    for (int i = 0; i < p.owned; ++i) mean += p.position_of(i) / p.owned;
    for (std::size_t a = 0; a < 3; ++a)
        for (double& x : p.position[a]) x = mean[int(a)] + factor * (x - mean[int(a)]);
}

/// Velocity of the fluid in all cells of this rank, component after component, and the largest pressure.
struct FlowState {
    std::vector<double> velocity;
    double pressure = 0;
};

FlowState flow_state(World& world)
{
    FlowState state;
    const auto& fluid = std::as_const(world.fluid()->state());
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
            for (int c = 0; c < 3; ++c) state.velocity.push_back(fluid.velocity.on(b).component(c)(i, j, k));
            state.pressure = std::max(state.pressure, std::abs(fluid.pressure.on(b)(i, j, k)));
        });
    return state;
}

/// A world and who runs it.
class StressRun {
public:
    StressRun(const StressCase& stress, const Scene& scene, const std::string& executor, const std::string& checkpoint = "")
        : ranks_(core::Communicator::self()), world_(scene, ranks_), steps_(stress.steps)
    {
        if (stress.squeeze && world_.grains()) squeeze(world_, *stress.squeeze);
        if (checkpoint.empty()) world_.settle(core::SerialTeam());
        else load_state(CheckpointReader(checkpoint, ranks_), world_);
        const tasks::ExecutorOptions options{executor, executor == "serial" ? 1 : 2, nullptr};
        world_.run_other_modes_with(options);
        executor_ = tasks::make_executor(options, world_.compile());
    }

    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] bool done() const
    {
        return steps_ ? world_.clock().step >= *steps_ : world_.time() >= world_.scene().run.until * (1 - 1e-9);
    }
    void step() { world_.step(*executor_); }
    [[nodiscard]] std::string digest()
    {
        const Scratch scratch;
        return CheckpointReader(save_state(world_, scratch.path(), 1), ranks_).digest();
    }

private:
    core::Communicator ranks_;
    World world_;
    std::optional<int> steps_;
    std::unique_ptr<tasks::Executor> executor_;
};

/// All that is asked of one variant.
class StressJudge {
public:
    StressJudge(const StressCase& stress, std::vector<StressVerdict>& verdicts) : stress_(stress), verdicts_(verdicts) {}

    /// @return the largest pressure of the run [Pa].
    double judge(const StressVariant& variant)
    {
        variant_ = variant.name;
        const auto& refused = variant.refused ? variant.refused : stress_.refused;
        try {
            const Scene scene = stress_.scene.read(variant.set);
            if (refused) {
                run_to_end(scene);
                add("refused", "ran to the end", *refused, false);
                return 0;
            }
            const double pressure = judge_run(scene, variant.set);
            if (!stress_.same_bits.empty()) judge_bits(scene);
            return pressure;
        } catch (const std::exception& error) {
            const std::string text = error.what();
            const bool holds = refused && text.find(*refused) != std::string::npos;
            if (refused) add("refused", holds ? "as it must be" : text, *refused, holds);
            else add("runs", text, "to the end", false);
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

    void add(const std::string& criterion, const std::string& measured, const std::string& bound, bool passed)
    {
        verdicts_.push_back({stress_.name, variant_, criterion, measured, bound, passed});
    }
    void add(Measure m, double value)
    {
        const auto& [word, unit, meaning] = measures[std::size_t(m)];
        const Bounds& bounds = *stress_.criteria.of(m);
        const std::string low = std::isfinite(bounds.low) ? fmt::format("{:.4g} to ", bounds.low) : "at most ";
        add(std::string(word), fmt::format("{:.4g}", value), fmt::format("{}{:.4g} {}", low, bounds.high, unit == "1" ? "" : unit),
            bounds.hold(value));
    }

private:
    void run_to_end(const Scene& scene) const
    {
        StressRun run(stress_, scene, "serial");
        while (!run.done()) run.step();
    }

    double judge_run(const Scene& scene, const std::vector<std::string>& overrides)
    {
        StressRun run(stress_, scene, "serial");
        StressProbes probes(run.world(), stress_.criteria);
        while (!run.done()) {
            run.step();
            probes.after_step();
        }
        probes.finish();
        int particles = 0;
        for (const Species& s : scene.particles) particles += s.count.value_or(0);
        const int kept = run.world().grains() ? run.world().grains()->particles.owned : 0;
        add("particles", std::to_string(kept), std::to_string(particles), kept == particles);
        for (std::size_t m = 0; m < measures.size(); ++m)
            if (stress_.criteria.bounds[m] && !StressCriteria::of_the_end(Measure(m))) add(Measure(m), probes.value(Measure(m)));
        if (stress_.go_on) judge_continuation(run, overrides);
        return probes.value(Measure::pressure);
    }

    void judge_continuation(StressRun& run, std::vector<std::string> overrides)
    {
        const Scratch scratch;
        const FlowState before = flow_state(run.world());
        overrides.insert(overrides.end(), stress_.go_on->set.begin(), stress_.go_on->set.end());
        StressRun again(stress_, stress_.scene.read(overrides), "serial", save_state(run.world(), scratch.path(), 1));
        for (int n = 0; n < stress_.go_on->steps; ++n) again.step();
        const FlowState after = flow_state(again.world());
        double change = 0;
        for (std::size_t n = 0; n < after.velocity.size(); ++n) change = std::max(change, std::abs(after.velocity[n] - before.velocity[n]));
        if (stress_.criteria.of(Measure::continued_change)) add(Measure::continued_change, change);
        if (stress_.criteria.of(Measure::continued_pressure)) add(Measure::continued_pressure, after.pressure / before.pressure);
    }

    void judge_bits(const Scene& scene)
    {
        const Scratch scratch;
        StressRun first(stress_, scene, "serial");
        std::string checkpoint;
        while (!first.done()) {
            first.step();
            if (checkpoint.empty()) checkpoint = save_state(first.world(), scratch.path(), 1);
        }
        const std::string expected = first.digest();
        for (const std::string& way : stress_.same_bits) {
            const bool restart = way == "restart";
            StressRun again(stress_, scene, restart ? "serial" : way, restart ? checkpoint : "");
            while (!again.done()) again.step();
            const std::string digest = again.digest();
            add("same bits, " + way, digest, expected, digest == expected);
        }
    }

    const StressCase& stress_;
    std::vector<StressVerdict>& verdicts_;
    std::string variant_;
};

std::vector<StressVariant> variants_of(const StressCase& stress)
{
    std::vector<StressVariant> all = stress.variants;
    if (all.empty()) all.emplace_back();
    if (stress.halve_dt == 0) return all;
    std::vector<StressVariant> halved;
    for (const StressVariant& v : all) {
        const Scene scene = stress.scene.read(v.set);
        core::require<core::ConfigError>(scene.run.time_step.has_value(), stress.name + ": halve_dt needs run.time_step in the scene");
        double dt = *scene.run.time_step;
        for (int n = 0; n <= stress.halve_dt; ++n, dt *= 0.5) {
            halved.push_back(v);
            halved.back().name += fmt::format("{}dt = {:.3g} s", v.name.empty() ? "" : ", ", dt);
            halved.back().set.push_back(fmt::format("run.time_step={} s", number_text(dt)));
        }
    }
    return halved;
}

} // namespace

std::vector<StressVerdict> run_stress_case(const StressCase& stress)
{
    std::vector<StressVerdict> verdicts;
    StressJudge judge(stress, verdicts);
    double first = std::numeric_limits<double>::quiet_NaN(), growth = 1.0;
    for (const StressVariant& variant : variants_of(stress)) {
        const double pressure = judge.judge(variant);
        if (std::isnan(first)) first = pressure;
        growth = std::max(growth, pressure / first);
    }
    if (stress.criteria.of(Measure::pressure_growth)) judge.add(Measure::pressure_growth, growth);
    return verdicts;
}

std::string table_text(const std::vector<StressVerdict>& verdicts)
{
    std::string text;
    for (const StressVerdict& v : verdicts)
        text += fmt::format("{:4} {:24} {:22} {:22} {:>18}  {}\n", v.passed ? "pass" : "FAIL", v.stress_case, v.variant, v.criterion,
                            v.measured, v.bound);
    return text;
}

} // namespace io
