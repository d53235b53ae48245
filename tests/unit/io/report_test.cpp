// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/study/line_plot.hpp"
#include "io/study/report.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <doctest/doctest.h>
#include <fstream>

namespace {

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

} // namespace

TEST_CASE("a line plot keeps the extremes of a long curve and survives curves without any extent")
{
    std::vector<double> x, y;
    for (int n = 0; n < 100000; ++n) {
        x.push_back(n);
        y.push_back(n == 54321 ? 1.0 : 0.0);
    }
    const std::string svg = io::to_svg(io::LinePlot{"a < b", "time", "", {{"one", x, y}}});
    CHECK(svg.find("a &lt; b") != std::string::npos);
    CHECK(svg.size() < 60000);
    CHECK(svg.find(" 54.9") != std::string::npos); // the peak, with six percent of room above it
    for (const double value : {0.0, 3.0, -1e-12})
        CHECK(io::to_svg(io::LinePlot{"", "", "", {{"flat", {1.0, 1.0}, {value, value}}}}).find("nan") == std::string::npos);
    CHECK(io::to_svg(io::LinePlot{}).find("</svg>") != std::string::npos);
}

TEST_CASE("a report holds scene, curves and at most twelve pictures, and points to nothing outside")
{
    const TemporaryFolder folder;
    const io::RunDirectory run(folder.path());
    CHECK_THROWS_AS((void)io::report_html(run), core::ConfigError);
    std::filesystem::create_directories(run.frames());
    std::ofstream(run.manifest()) << R"({"version": "1.2.3"})";
    std::ofstream(run.scene()) << "name: a < b\n";
    std::ofstream(run.metrics()) << "time,step,mean_height_S,mean_height_L\n0,0,1,2\n1,1,3,4\n";
    for (int n = 0; n < 40; ++n) std::ofstream(run.frames() / ("frame_" + std::to_string(100 + n) + ".png")) << (n % 2 ? "Man" : "Ma");
    std::ofstream(run.log()) << "[ 1.0 s] coupling: 3 steps coarse\n[ 1.0 s] rank 0: 3 steps, lanes overlap 2 ms\n[ 1.0 s] memory: 1 MB\n";
    const std::string page = io::report_html(run);
    CHECK(page.find("coupling: 3 steps coarse") != std::string::npos);
    CHECK(page.find("lanes overlap 2 ms") != std::string::npos);
    CHECK(page.find("memory: 1 MB") == std::string::npos);
    CHECK(page.find("1.2.3") != std::string::npos);
    CHECK(page.find("a &lt; b") != std::string::npos);
    CHECK(count(page, "<svg") == 1);
    CHECK(count(page, "<img") == 12);
    CHECK(page.find("frame_100<") != std::string::npos);
    CHECK(page.find("frame_139<") != std::string::npos);
    CHECK(page.find("base64,TWFu\"") != std::string::npos); // RFC 4648
    CHECK(page.find("base64,TWE=\"") != std::string::npos);
    CHECK(count(page, "http") == 1); // the name space of the SVG
}
