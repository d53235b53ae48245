// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The folder of one run and the names in it.
#include <filesystem>
#include <string>

namespace io {

/// runs/<name>, named after the folder of a scene.yaml or after the scene file.
[[nodiscard]] std::filesystem::path default_run_directory(const std::filesystem::path& scene_file);

class RunDirectory {
public:
    /// What to do with results that are there already.
    enum class Existing { refuse, replace, resume };

    /// Makes the folder and its parts. Only one rank may call this.
    /// `replace` removes what an earlier run wrote, and nothing else; `resume` keeps it.
    /// @throws core::ConfigError if there is an earlier run and `refuse`, none and `resume`, or if the folder has other
    ///         contents and no manifest.json.
    static RunDirectory create(const std::filesystem::path& root, Existing existing);
    /// The names of a run that exists, without touching it.
    explicit RunDirectory(std::filesystem::path root) : root_(std::move(root)) {}

    [[nodiscard]] const std::filesystem::path& root() const { return root_; }
    [[nodiscard]] std::filesystem::path scene() const { return root_ / "scene.yaml"; }
    [[nodiscard]] std::filesystem::path manifest() const { return root_ / "manifest.json"; }
    [[nodiscard]] std::filesystem::path log() const { return root_ / "log.txt"; }
    [[nodiscard]] std::filesystem::path metrics() const { return root_ / "metrics.csv"; }
    [[nodiscard]] std::filesystem::path profile() const { return root_ / "profile.csv"; }
    [[nodiscard]] std::filesystem::path checkpoints() const { return root_ / "checkpoints"; }
    [[nodiscard]] std::filesystem::path results() const { return root_ / "results"; }
    [[nodiscard]] std::filesystem::path frames() const { return root_ / "frames"; }
    [[nodiscard]] std::filesystem::path trace(int rank = 0) const
    {
        return root_ / (rank == 0 ? std::string("trace.json") : "trace_" + std::to_string(rank) + ".json");
    }
    [[nodiscard]] std::filesystem::path report() const { return root_ / "report.html"; }
    /// A file of this name, made by the user, ends the run with a checkpoint.
    [[nodiscard]] std::filesystem::path stop_file() const { return root_ / "stop"; }

private:
    std::filesystem::path root_;
};

} // namespace io
