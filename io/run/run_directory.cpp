// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/run_directory.hpp"

#include "core/base/error.hpp"
#include <fmt/format.h>

namespace io {

namespace fs = std::filesystem;

namespace {

void remove_earlier_run(const RunDirectory& run)
{
    for (const auto& path : {run.scene(), run.log(), run.metrics(), run.profile(), run.checkpoints(), run.results(), run.frames(),
                             run.trace(), run.report(), run.stop_file(), run.manifest()})
        fs::remove_all(path);
    for (int rank = 1; fs::remove(run.trace(rank)); ++rank) {}
}

void check_existing(const RunDirectory& run, RunDirectory::Existing existing)
{
    using core::ConfigError;
    const fs::path& root = run.root();
    const bool is_run = fs::exists(run.manifest());
    if (existing == RunDirectory::Existing::resume)
        return core::require<ConfigError>(is_run, fmt::format("{} has no run that could go on", root.string()));
    if (!fs::exists(root) || (fs::is_directory(root) && fs::is_empty(root))) return;
    core::require<ConfigError>(is_run, fmt::format("{} exists and is not a run of Isago; choose another folder "
                                                   "with -o",
                                                   root.string()));
    core::require<ConfigError>(existing == RunDirectory::Existing::replace,
                               fmt::format("{} has an earlier run: continue it with --restart, replace it with "
                                           "--force, or choose another folder with -o",
                                           root.string()));
}

} // namespace

fs::path default_run_directory(const fs::path& scene_file)
{
    const fs::path whole = fs::weakly_canonical(scene_file);
    const bool named_by_folder = whole.filename() == "scene.yaml";
    return fs::path("runs") / (named_by_folder ? whole.parent_path().filename() : whole.stem());
}

RunDirectory RunDirectory::create(const fs::path& root, Existing existing)
{
    const RunDirectory run(root);
    check_existing(run, existing);
    try {
        if (existing == Existing::replace) remove_earlier_run(run);
        for (const auto& folder : {run.checkpoints(), run.results(), run.frames()}) fs::create_directories(folder);
        fs::remove(run.stop_file()); // one left by an earlier run would end this one at once
    } catch (const fs::filesystem_error& error) {
        throw core::FileError(fmt::format("{} cannot be prepared: {}", root.string(), error.code().message()));
    }
    return run;
}

} // namespace io
