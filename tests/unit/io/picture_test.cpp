// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/picture/picture_renderer.hpp"
#include "io/picture/picture_slice.hpp"
#include "io/picture/picture_text.hpp"
#include "io/picture/picture_worker.hpp"
#include "tests/support/pipe_picture.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/sample_state.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

namespace {

std::array<int, 3> pixel(const io::Image& image, int x, int y)
{
    const std::uint8_t* p = &image.rgb[3 * std::size_t(y * image.width + x)];
    return {p[0], p[1], p[2]};
}

io::PictureScene one_sphere()
{
    io::PictureScene scene;
    scene.spheres.push_back({0, 0, 0, 1, {0.9f, 0.1f, 0.1f}});
    scene.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30.0};
    return scene;
}

double luminance(const io::Colour& c) { return 0.2126 * std::pow(c[0], 2.2) + 0.7152 * std::pow(c[1], 2.2) + 0.0722 * std::pow(c[2], 2.2); }

} // namespace

TEST_CASE("a sphere covers the disc that perspective says")
{
    const io::Image image = io::Renderer(400, 400).draw(one_sphere());
    const auto red = [&](int x, int y) { return pixel(image, x, y)[0] > 2 * pixel(image, x, y)[2]; };
    CHECK(red(200, 200));
    // Outline at tan(asin(1/10)) from the axis, of tan(15 degrees) at the edge of the picture.
    const double expected = 200.0 * std::tan(std::asin(0.1)) / std::tan(std::numbers::pi / 12.0);
    int width = 0;
    for (int x = 0; x < 400; ++x) width += red(x, 200);
    CHECK(width == test::relative(2.0 * expected).epsilon(0.02)); // one pixel at either end
}

TEST_CASE("what is nearer hides what is behind, also where spheres overlap")
{
    io::PictureScene scene = one_sphere();
    scene.spheres.push_back({0.5f, 0, -0.5f, 1, {0.1f, 0.1f, 0.9f}}); // partly inside the first, farther away
    const io::Image image = io::Renderer(400, 400).draw(scene);
    // The spheres meet where x = -z + ... : the plane through the circle of intersection is x = z + 0.5.
    CHECK(pixel(image, 200, 200)[0] > pixel(image, 200, 200)[2]);
    CHECK(pixel(image, 275, 200)[2] > pixel(image, 275, 200)[0]);
}

TEST_CASE("the same scene gives the same bytes")
{
    const auto scene = support::pipe_picture(60, 1.5, 20);
    const auto first = io::Renderer(300, 200).draw(scene), second = io::Renderer(300, 200).draw(scene);
    CHECK(first.rgb == second.rgb);
}

TEST_CASE("letters are drawn where they should be and have the height they should have")
{
    io::Image image{200, 60, std::vector<std::uint8_t>(3 * 200 * 60, 255)};
    io::draw_text(image, "H", {20, 45, 30, {0, 0, 0}});
    int top = 60, bottom = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 200; ++x)
            if (pixel(image, x, y)[0] < 128) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    CHECK(bottom - top == test::relative(30 * 1.11).epsilon(0.06)); // capital height and the width of the stroke
    CHECK(io::text_width("mm", 12) == test::relative(2 * io::text_width("m", 12)));
}

TEST_CASE("the colour map gets lighter all the way")
{
    for (int n = 0; n < 50; ++n) CHECK(luminance(io::sequential_colour(n / 50.0)) < luminance(io::sequential_colour((n + 1) / 50.0)));
    for (int n = 0; n <= 50; ++n) // no part is cut off, or the hue would have a kink there
        for (const float part : io::sequential_colour(n / 50.0)) CHECK((part > 0.0f && part < 1.0f));
    CHECK(io::sequential_colour(-1.0) == io::sequential_colour(0.0));
    const io::Colour white = io::from_oklab(1.0, 0.0, 0.0);
    for (const float part : white) CHECK(part == test::relative(1.0).epsilon(1e-3));
}

TEST_CASE("fit_camera sees every corner of the box")
{
    const core::Vec3 low(0, -1, -1), high(4, 1, 1);
    const io::Camera camera = io::fit_camera(low, high, {-0.5, -0.4, -0.8}, 1.5);
    io::PictureScene scene;
    scene.camera = camera;
    for (int corner = 0; corner < 8; ++corner)
        scene.spheres.push_back({float(corner & 1 ? 4 : 0), corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f, 0.02f, {1, 0, 0}});
    const io::Image image = io::Renderer(600, 400).draw(scene);
    for (int y = 0; y < 400; ++y)
        for (const int x : {0, 599}) CHECK_FALSE(pixel(image, x, y)[0] > 2 * pixel(image, x, y)[2]);
}

TEST_CASE("the worker writes what was submitted, waits when it must, and reports an error once")
{
    const support::Folder folder;
    io::PictureWorker worker(160, 120, 1);
    for (int n = 0; n < 4; ++n) worker.submit(one_sphere(), folder.path() + "/" + std::to_string(n) + ".png");
    worker.finish();
    CHECK(worker.written() == 4);
    CHECK(worker.take_error().empty());
    std::ifstream file(folder.path() + "/3.png", std::ios::binary);
    std::string head(8, '\0');
    file.read(head.data(), 8);
    CHECK(head == "\x89PNG\r\n\x1a\n");

    worker.submit(one_sphere(), folder.path() + "/absent/picture.png");
    worker.finish();
    CHECK(worker.take_error().find("absent/picture.png") != std::string::npos);
    CHECK(worker.take_error().empty());
    worker.submit(one_sphere(), folder.path() + "/5.png");
    worker.finish();
}

TEST_CASE("a plane cuts a box of cells in faces of the right area and colour")
{
    io::BlockNodes block{{4, 3, 2}, {}};
    core::for_each({0, 0, 0}, {5, 4, 3}, [&](int i, int j, int k) {
        for (const int x : {i, j, k}) block.points.push_back(x);
    });
    core::Array3<double> values({4, 3, 2}, 0, 0.25);
    const auto area = [&](const core::Vec3& normal) {
        double sum = 0.0;
        for (const auto& quad : io::cut(block, std::as_const(values).view(), {{2, 1.5, 1}, normal}, {"", 0.0, 1.0})) {
            CHECK(quad.colour == io::sequential_colour(0.25));
            const auto p = [&](std::size_t n) { return Eigen::Vector3f(quad.corners[n].data()); };
            sum += 0.5 * ((p(1) - p(0)).cross(p(2) - p(0)).norm() + (p(2) - p(0)).cross(p(3) - p(0)).norm());
        }
        return sum;
    };
    CHECK(area({0, 0, 1}) == test::relative(12.0));
    CHECK(area({1, 0, 0}) == test::relative(6.0));
    // Through the middle, holding the i axis and tilted by 1 in 1: width 4, length 2 sqrt(2) between k = 0 and 2.
    CHECK(area({0, 1, 1}) == test::relative(4.0 * 2.0 * std::sqrt(2.0)));
}

TEST_CASE("grains in a pipe are drawn in good time")
{
    const char* path = std::getenv("ISAGO_TEST_PICTURE"); // to look at it, in full
    auto scene = support::pipe_picture(path ? 1600 : 200, 4.0 / 3.0, path ? 220 : 20);
    const io::Image image = io::Renderer(1280, 960).draw(scene);
    CHECK(image.rgb.size() == 3 * 1280 * 960);
    if (!path) return;
    io::write_png(image, path);
    io::BlockNodes block{{60, 1, 40}, {}};
    core::for_each({0, 0, 0}, {61, 2, 41}, [&](int i, int j, int k) {
        for (const double x : {0.0015 * i, 0.02 * j + 0.0005, 0.04 * (k / 40.0 - 0.5)}) block.points.push_back(x);
    });
    core::Array3<double> speed({60, 1, 40}, 0);
    core::for_each_cell({60, 1, 40}, [&](int i, int, int k) { speed(i, 0, k) = 1.5 * std::sin(0.08 * k) * (1 - 0.2 * std::sin(0.2 * i)); });
    scene.caption.bar = io::ColourBar{"speed [m/s]", 0.0, 1.5};
    scene.caption.title = "Slice 0123456789 abcdefghijklmnopqrstuvwxyz";
    scene.caption.detail = "ABCDEFGHIJKLMNOPQRSTUVWXYZ +-=/.,:()%<>'*&#!?;^|";
    scene.quads = io::cut(block, std::as_const(speed).view(), {{0, 0.01, 0}, {0, 1, 0}}, *scene.caption.bar);
    for (io::Sphere& s : scene.spheres) s.colour = io::sequential_colour((s.y + 0.025) / 0.02);
    io::write_png(io::Renderer(1280, 960).draw(scene), std::string(path) + ".slice.png");
}
