// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grids from Plot3D files: every way of writing one, and blocks of any orientation.
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/mesh.hpp"
#include "io/build/imported_blocks.hpp"
#include "io/files/plot3d.hpp"
#include "tests/support/relative.hpp"
#include "tests/unit/io/scene_text.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <algorithm>
#include <cstring>
#include <doctest/doctest.h>
#include <utility>

using core::MultiBlock, core::Vec3, core::Vertices;

namespace {

/// How a test writes a file.
struct Writing {
    bool big_endian = false, records = false, counted = true, blanked = false, single = false;
};

class Writer {
public:
    explicit Writer(const Writing& how) : how_(how) {}

    template <class T>
    void put(T value)
    {
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), &value, sizeof(T));
        if (how_.big_endian) std::reverse(raw.begin(), raw.end());
        record_.append(raw.data(), raw.size());
    }
    void real(double x) { how_.single ? put(float(x)) : put(x); }
    void end()
    {
        const std::string record = std::exchange(record_, "");
        const auto length = std::uint32_t(record.size());
        if (how_.records) put(length);
        bytes += std::exchange(record_, "") + record;
        if (how_.records) put(length);
        bytes += std::exchange(record_, "");
    }
    std::string bytes;

private:
    Writing how_;
    std::string record_;
};

std::string binary(const std::vector<Vertices>& blocks, const Writing& how)
{
    Writer writer(how);
    if (how.counted) {
        writer.put(std::int32_t(blocks.size()));
        writer.end();
    }
    for (const Vertices& v : blocks)
        for (int m = 0; m < 3; ++m) writer.put(std::int32_t(v.extents()[m]));
    writer.end();
    for (const Vertices& v : blocks) {
        for (int m = 0; m < 3; ++m)
            for (const Vec3& x : v.data()) writer.real(x[m]);
        if (how.blanked)
            for (std::size_t n = 0; n < v.data().size(); ++n) writer.put(std::int32_t(1));
        writer.end();
    }
    return writer.bytes;
}

std::string as_text(const std::vector<Vertices>& blocks)
{
    std::string all = fmt::format("{}\n", blocks.size());
    for (const Vertices& v : blocks) all += fmt::format("{} {} {}\n", v.extents().ni, v.extents().nj, v.extents().nk);
    for (const Vertices& v : blocks)
        for (int m = 0; m < 3; ++m)
            for (const Vec3& x : v.data()) all += fmt::format("{:.17g}\n", x[m]);
    return all;
}

MultiBlock two_boxes()
{
    return core::make_box({{0, 0, 0}, {2, 1, 1}, {4, 3, 5}, {2, 1, 1}, {false, false, false}},
                          [](const Vec3& x) { return Vec3(x + 0.05 * Vec3(x.y() * x.z(), x.x() * x.z(), x.x() * x.y())); });
}

/// The block with its indices permuted and reversed: any of 48 orientations, half of them left-handed.
Vertices oriented(const Vertices& v, int way)
{
    constexpr std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    const auto order = orders[std::size_t(way / 8)];
    const auto n = v.extents();
    Vertices other({n[order[0]], n[order[1]], n[order[2]]}, 0, Vec3::Zero());
    core::for_each_cell(other.extents(), [&](int i, int j, int k) {
        const core::Index3 here{i, j, k};
        core::Index3 there;
        for (int m = 0; m < 3; ++m) {
            const int c = here[m], last = other.extents()[m] - 1;
            there[order[std::size_t(m)]] = (way >> m & 1) != 0 ? last - c : c;
        }
        other(i, j, k) = v.view()[there];
    });
    return other;
}

io::ImportedGrid imported(const std::filesystem::path& file)
{
    io::ImportedGrid grid;
    grid.file = file.string();
    grid.other_sides = "wall";
    return grid;
}

} // namespace

TEST_CASE("a grid is read the same however it was written")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.xyz";
    const MultiBlock box = two_boxes();
    for (int way = 0; way < 32; ++way) {
        const Writing how{(way & 1) != 0, (way & 2) != 0, (way & 4) != 0, (way & 8) != 0, (way & 16) != 0};
        const std::vector<Vertices> blocks(box.blocks.begin(), box.blocks.begin() + (how.counted ? 2 : 1));
        write_file(file, binary(blocks, how));
        const io::Plot3d grid = io::read_plot3d(file);
        CAPTURE(grid.form);
        REQUIRE(grid.blocks.size() == blocks.size());
        for (std::size_t b = 0; b < blocks.size(); ++b)
            for (std::size_t n = 0; n < blocks[b].data().size(); ++n)
                CHECK((grid.blocks[b].data()[n] - blocks[b].data()[n]).norm() <= (how.single ? 2e-7 : 0.0)); // 24 bits of numbers up to 2
    }
    write_file(file, as_text(box.blocks));
    const io::Plot3d grid = io::read_plot3d(file);
    CHECK(grid.form == "text");
    CHECK(grid.blocks[1].data() == box.blocks[1].data());
    write_file(file, "2 2 2\n4*0.0 4*1.D0, 2*0 2*1 2*0 2*1\n0 1 0 1 0 1 0 1");
    CHECK((io::read_plot3d(file).blocks[0](1, 1, 1) - Vec3(1, 1, 1)).norm() == 0);
}

TEST_CASE("a torn, foreign or blanked file is refused with its name")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.xyz";
    const auto message = [&](const std::string& content) -> std::string {
        write_file(file, content);
        try {
            static_cast<void>(io::read_plot3d(file));
        } catch (const core::ConfigError& error) {
            return error.what();
        }
        return "";
    };
    const std::string good = binary(two_boxes().blocks, {});
    CHECK(message(good.substr(0, good.size() - 1)).find("it may be torn") != std::string::npos);
    CHECK(message(good + "x").starts_with(file.string()));
    CHECK(message("1 2 2 2 0 0 0").find("7 numbers are not those") != std::string::npos);
    CHECK(message("1 2 2 2 zero").find("'zero' is not a number (word 5 of the file)") != std::string::npos);
    CHECK(message("2 2 1\n12*0").find("each direction needs two or more") != std::string::npos);
    CHECK(message("2 2 2\n24*0 7*1 0").find("point 7 of block 0 is blanked") != std::string::npos);
    CHECK(message("2 2 2\n23*0 nan").find("point 7 of block 0 is not finite") != std::string::npos);
}

TEST_CASE("blocks meet in any of their 48 orientations, left-handed ones too")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.xyz";
    const MultiBlock box = two_boxes();
    const double volume = core::Mesh(box, 0, 1).total_volume();
    for (int way = 0; way < 48; ++way) {
        write_file(file, binary({oriented(box.blocks[0], way), oriented(box.blocks[1], (7 * way + 5) % 48)}, {.single = way % 2 == 0}));
        io::ImportedGrid grid = imported(file);
        grid.tolerance = 1e-5; // half of the files have 24 bits
        const core::Mesh mesh(io::import_blocks(grid, {false, false, false}), 0, 1);
        CHECK(mesh.topology().interfaces.size() == 1);
        CHECK(mesh.topology().boundaries.size() == 10);
        CHECK(mesh.total_volume() == test::relative(volume).epsilon(way % 2 == 0 ? 1e-6 : 1e-13)); // 24 bits in half of the files
    }
}

TEST_CASE("every side that meets no other must be named, in the counting of the file")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.xyz";
    const MultiBlock box = two_boxes();
    write_file(file, as_text({box.blocks[0], oriented(box.blocks[1], 4)})); // k reversed: left-handed
    io::ImportedGrid grid = imported(file);
    grid.unit = 1e-3;
    grid.boundaries = {{"inlet", {"0.i_low"}}, {"floor", {"0.k_low", "1.k_high"}}};
    const core::Mesh mesh(io::import_blocks(grid, {false, false, false}), 0, 1);
    for (const auto& b : mesh.topology().boundaries) {
        const bool low_z = std::abs(mesh.vertices(b.block)(0, 0, b.side == core::Side::k_low ? 0 : 5).z()) < 1e-12;
        if (core::axis_of(b.side) == 2) CHECK(b.name == (low_z ? "floor" : "wall"));
        if (b.side == core::Side::i_low) CHECK(b.name == "inlet");
    }
    grid.other_sides.reset();
    CHECK_THROWS_WITH_AS(static_cast<void>(io::import_blocks(grid, {false, false, false})),
                         doctest::Contains("side 1.k_low meets no other and has no name: within (0.001"), core::ConfigError);
    grid.boundaries = {{"inlet", {"0.i_high"}}};
    CHECK_THROWS_WITH_AS(static_cast<void>(io::import_blocks(grid, {false, false, false})),
                         doctest::Contains("side 0.i_high is in boundary 'inlet', but meets block 1"), core::ConfigError);
    grid.boundaries = {{"inlet", {"2.i_high"}}};
    CHECK_THROWS_WITH_AS(static_cast<void>(io::import_blocks(grid, {false, false, false})), doctest::Contains("it has 2, counted from 0"),
                         core::ConfigError);
}

TEST_CASE("sides that lie on each other without matching points are joined at sub-faces")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.xyz";
    const auto box = [](double low, double high, int across, double top = 1) {
        return core::make_box({{low, 0, 0}, {high, top, 1}, {4, across, 4}, {1, 1, 1}, {false, false, false}}).blocks.front();
    };
    const auto joints = [&](const std::array<bool, 3>& periodic) {
        return core::Mesh(io::import_blocks(imported(file), periodic), 0, 1).topology().joints.interfaces;
    };
    write_file(file, as_text({box(0, 1, 4), oriented(box(1, 2, 6), 4)}));
    CHECK(joints({false, false, false}).size() == 1);
    // Through the period, too: here only the outer ends differ.
    write_file(file, as_text({box(0, 1, 4), box(1, 2, 4), box(2, 3, 6)}));
    CHECK(joints({true, false, false}).size() == 2);
    // A step: the first block is cut at the edge of the second, and all of its pieces are boundaries or joined as a whole.
    write_file(file, as_text({box(0, 1, 8, 2), box(1, 2, 6)}));
    const io::ImportedGrid step = imported(file);
    const core::Mesh mesh(io::import_blocks(step, {false, false, false}), 0, 1);
    CHECK(mesh.blocks() == 3);
    CHECK(mesh.topology().joints.interfaces.size() == 1);
    write_file(file, as_text({box(0, 1, 5, 2), box(1, 2, 6)})); // here the edge lies within a face
    CHECK_THROWS_WITH_AS(static_cast<void>(io::import_blocks(step, {false, false, false})),
                         doctest::Contains("side i_high of block 0: others cover 50 % of its face (2, 0)"), core::ConfigError);
    io::ImportedGrid named = step;
    named.boundaries = {{"inlet", {"1.i_low"}}};
    write_file(file, as_text({box(0, 1, 8, 2), box(1, 2, 6)}));
    CHECK_THROWS_WITH_AS(static_cast<void>(io::import_blocks(named, {false, false, false})),
                         doctest::Contains("side 1.i_low is in boundary 'inlet', but others lie on all of it"), core::ConfigError);
    // A thin block has its own two sides close together, which is no fault.
    const auto thin = core::make_box({{0, 0, 0}, {1, 1, 0.004}, {4, 5, 1}, {1, 1, 1}, {false, false, false}}).blocks.front();
    write_file(file, as_text({thin}));
    CHECK(io::import_blocks(imported(file), {false, false, false}).blocks.size() == 1);
}

TEST_CASE("a scene takes its blocks from a file beside it, and mistakes are told at the key")
{
    const TemporaryFolder folder;
    write_file(folder.path() / "grid.xyz", as_text(two_boxes().blocks));
    const std::string scene =
        "name: t\ngrid:\n  blocks: { file: grid.xyz, other_sides: wall }\nfluid: { water: { density: 1 kg/m3, viscosity: 1 m2/s } }\n"
        "run: { until: 1 s }\n";
    write_file(folder.path() / "scene.yaml", scene);
    const io::Scene read = io::read_scene(folder.path());
    CHECK(read.grid.blocks->file == (folder.path() / "grid.xyz").string());
    CHECK(read.grid.volume() == test::relative(core::Mesh(two_boxes(), 0, 1).total_volume()));
    write_file(folder.path() / "scene.yaml", test_scene::with("grid.xyz", "none.xyz", scene));
    CHECK_THROWS_WITH_AS(static_cast<void>(io::read_scene(folder.path())), doctest::Contains("scene.yaml:3:3: error:"), core::ConfigError);
    auto folded = two_boxes();
    std::swap(folded.blocks[1](1, 1, 1), folded.blocks[1](1, 2, 1));
    write_file(folder.path() / "grid.xyz", as_text(folded.blocks));
    write_file(folder.path() / "scene.yaml", scene);
    CHECK_THROWS_WITH_AS(static_cast<void>(io::read_scene(folder.path())), doctest::Contains("of block 1 is folded"), core::ConfigError);
}
