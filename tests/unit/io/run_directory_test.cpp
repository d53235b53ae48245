// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/run/manifest.hpp"
#include "io/run/metrics.hpp"
#include "io/run/run_directory.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <cmath>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using Existing = io::RunDirectory::Existing;
namespace fs = std::filesystem;

TEST_CASE("a run never overwrites another one unless told to, and never removes what is not its own")
{
    const TemporaryFolder folder;
    const fs::path root = folder.path() / "runs" / "pipe";
    const auto run = io::RunDirectory::create(root, Existing::refuse);
    CHECK(fs::is_directory(run.checkpoints()));
    write_file(run.manifest(), "{}");
    write_file(run.results() / "step.hdf", "data");
    write_file(root / "notes.txt", "mine");

    CHECK_THROWS_AS(io::RunDirectory::create(root, Existing::refuse), core::ConfigError);
    CHECK(fs::exists(run.results() / "step.hdf"));
    CHECK_NOTHROW(io::RunDirectory::create(root, Existing::resume));
    CHECK(fs::exists(run.results() / "step.hdf"));
    CHECK_NOTHROW(io::RunDirectory::create(root, Existing::replace));
    CHECK(!fs::exists(run.results() / "step.hdf"));
    CHECK(text_of_file(root / "notes.txt") == "mine");
}

TEST_CASE("a folder with other contents is refused even by force, and a restart needs a run")
{
    const TemporaryFolder folder;
    write_file(folder.path() / "thesis.tex", "x");
    CHECK_THROWS_AS(io::RunDirectory::create(folder.path(), Existing::replace), core::ConfigError);
    CHECK_THROWS_AS(io::RunDirectory::create(folder.path() / "none", Existing::resume), core::ConfigError);
    CHECK_NOTHROW(io::RunDirectory::create(folder.path() / "none", Existing::replace));
}

TEST_CASE("a run is named after its scene")
{
    CHECK(io::default_run_directory("configs/settling_bed/scene.yaml") == "runs/settling_bed");
    CHECK(io::default_run_directory("some/where/bed.yaml") == "runs/bed");
}

TEST_CASE("the manifest is JSON with versions, commit, machine and command")
{
    const auto json = nlohmann::json::parse(io::manifest_text({{"isago", "run", "a \"b\""}, 2, 3, "tbb"}));
    CHECK(json.at("command").at(2) == "a \"b\"");
    CHECK(json.at("ranks") == 2);
    CHECK(json.at("threads") == 3);
    CHECK(json.at("version") == ISAGO_VERSION);
    CHECK(!json.at("commit").get<std::string>().empty());
    CHECK(json.at("libraries").contains("HDF5"));
    CHECK(json.at("machine").at("cores") >= 1);
    CHECK(json.at("started").get<std::string>().size() == std::string("2001-01-01T00:00:00Z").size());
}

TEST_CASE("metrics after a restart are those of a run without one, bit for bit")
{
    const TemporaryFolder folder;
    const std::vector<std::string> columns{"time", "energy"};
    auto row = [](int n) { return std::array{0.1 * n, std::sin(0.1 * n) / 3.0}; };
    {
        io::MetricsWriter whole(folder.path() / "whole.csv", columns);
        for (int n = 0; n < 10; ++n) whole.add(row(n));
    }
    const fs::path file = folder.path() / "restarted.csv";
    {
        io::MetricsWriter first(file, columns);
        for (int n = 0; n < 7; ++n) first.add(row(n));
    }
    write_file(folder.path() / "torn.csv", text_of_file(file) + "0.7000,0.2"); // stopped in the middle of a row
    fs::rename(folder.path() / "torn.csv", file);
    {
        io::MetricsWriter second(file, columns, 0.1 * 4);
        for (int n = 5; n < 10; ++n) second.add(row(n));
    }
    CHECK(text_of_file(file) == text_of_file(folder.path() / "whole.csv"));
    const auto table = io::read_metrics(file);
    CHECK(table.columns == columns);
    CHECK(table.rows.at(9).at(1) == std::sin(0.1 * 9) / 3.0);
}

TEST_CASE("metrics keep nan, refuse other columns and rows of another length")
{
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "metrics.csv";
    {
        io::MetricsWriter writer(file, {"time", "x"});
        writer.add(std::array{0.0, std::nan("")});
        CHECK_THROWS(writer.add(std::array{0.0}));
    }
    CHECK(std::isnan(io::read_metrics(file).rows.at(0).at(1)));
    CHECK_THROWS_AS(io::MetricsWriter(file, {"time", "y"}, 1.0), core::FileError);
    write_file(file, "time,x\n1\n");
    CHECK_THROWS_AS(io::read_metrics(file), core::FileError);
}
