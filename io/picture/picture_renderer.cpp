// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_renderer.hpp"
#include "core/base/error.hpp"
#include "io/picture/picture_text.hpp"

#ifdef ISAGO_EGL
#include "io/picture/picture_canvas.hpp"
#include "io/picture/picture_light.hpp"
#include "io/picture/picture_shaders.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace io {
namespace {

using Matrix = Eigen::Matrix4f;

Matrix view_of(const Camera& camera)
{
    const core::Vec3 back = (camera.eye - camera.target).normalized(), right = camera.up.cross(back).normalized();
    Matrix view = Matrix::Identity();
    const core::Vec3 axes[3] = {right, back.cross(right), back};
    for (int row = 0; row < 3; ++row) {
        view.block<1, 3>(row, 0) = axes[row].transpose().cast<float>();
        view(row, 3) = float(-axes[row].dot(camera.eye));
    }
    return view;
}

Matrix projection_of(const Camera& camera, double aspect)
{
    const double distance = (camera.eye - camera.target).norm(), near = 0.02 * distance, far = 20.0 * distance;
    const double zoom = 1.0 / std::tan(camera.angle * std::numbers::pi / 360.0);
    Matrix projection = Matrix::Zero();
    projection(0, 0) = float(zoom / aspect);
    projection(1, 1) = float(zoom);
    projection(2, 2) = float(-(far + near) / (far - near));
    projection(2, 3) = float(-2.0 * far * near / (far - near));
    projection(3, 2) = -1.0f;
    return projection;
}

std::vector<float> sphere_stream(const std::vector<Sphere>& spheres)
{
    const auto sky = detail::covered_sky(spheres);
    std::vector<float> values;
    for (std::size_t n = 0; n < spheres.size(); ++n) {
        const Sphere& s = spheres[n];
        values.insert(values.end(), {s.x, s.y, s.z, s.radius});
        values.insert(values.end(), s.colour.begin(), s.colour.end());
        values.insert(values.end(), sky[n].begin(), sky[n].end());
    }
    return values;
}

/// Points with the mean normals of the triangles around them.
std::vector<float> wall_stream(const Surface& wall)
{
    const auto point = [&](int n) { return Eigen::Vector3f(wall.points[std::size_t(n)].data()); };
    std::vector<Eigen::Vector3f> normals(wall.points.size(), Eigen::Vector3f::Zero());
    for (const auto& [a, b, c] : wall.triangles)
        for (const int corner : {a, b, c}) normals[std::size_t(corner)] += (point(b) - point(a)).cross(point(c) - point(a));
    std::vector<float> values;
    for (std::size_t n = 0; n < wall.points.size(); ++n) {
        const Eigen::Vector3f normal = normals[n].normalized();
        values.insert(values.end(), wall.points[n].begin(), wall.points[n].end());
        values.insert(values.end(), normal.data(), normal.data() + 3);
    }
    return values;
}

/// Edges that belong to one triangle only: the ends of a pipe, the rim of a box.
std::vector<float> free_edges(const Surface& wall)
{
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : wall.triangles)
        for (std::size_t n = 0; n < 3; ++n) ++uses[std::minmax(t[n], t[(n + 1) % 3])];
    std::vector<float> values;
    for (const auto& [edge, count] : uses)
        for (const int n : {edge.first, edge.second}) {
            if (count != 1) continue;
            const auto& p = wall.points[std::size_t(n)];
            values.insert(values.end(), {p[0], p[1], p[2], 0.30f, 0.38f, 0.47f, 0.75f});
        }
    return values;
}

std::vector<float> quad_stream(const std::vector<ColouredQuad>& quads)
{
    std::vector<float> values;
    for (const ColouredQuad& quad : quads)
        for (const std::size_t corner : {0, 1, 2, 0, 2, 3}) {
            values.insert(values.end(), quad.corners[corner].begin(), quad.corners[corner].end());
            values.insert(values.end(), {quad.colour[0], quad.colour[1], quad.colour[2], 1.0f});
        }
    return values;
}

} // namespace

struct Renderer::Canvas {
    Canvas(int w, int h) : aspect(double(w) / h), target(w, h) {}

    detail::Context context; // first: everything else lives in it
    double aspect;
    detail::Target target;
    GLuint background = detail::make_program(detail::background_vertex, detail::background_fragment);
    GLuint sphere = detail::make_program(detail::sphere_vertex, detail::sphere_fragment);
    GLuint wall = detail::make_program(detail::wall_vertex, detail::wall_fragment);
    GLuint plain = detail::make_program(detail::plain_vertex, detail::plain_fragment);

    void use(GLuint program, const Camera& camera) const
    {
        const Matrix view = view_of(camera), projection = projection_of(camera, aspect);
        const Eigen::Vector3f light = Eigen::Vector3f(-0.45f, 0.75f, 0.62f).normalized(); // over the viewer's left shoulder
        glUseProgram(program);
        glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view.data());
        glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection.data());
        glUniform3fv(glGetUniformLocation(program, "light"), 1, light.data());
    }

    void draw_background() const
    {
        const detail::Mesh nothing({});
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        glUseProgram(background);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
    }

    void draw_plain(const std::vector<float>& values, GLenum kind, const Camera& camera) const
    {
        if (values.empty()) return;
        const detail::Mesh mesh({values, {3, 4}});
        use(plain, camera);
        glDrawArrays(kind, 0, GLsizei(values.size() / 7));
    }

    void draw_spheres(const PictureScene& scene) const
    {
        const auto values = sphere_stream(scene.spheres);
        const detail::Mesh mesh({values, {4, 3, 4}, 1});
        use(sphere, scene.camera);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(scene.spheres.size()));
    }

    /// The far half of a wall, or the near one.
    void draw_wall(const Surface& surface, const Camera& camera, GLenum hidden) const
    {
        std::vector<unsigned> indices;
        for (const auto& t : surface.triangles) indices.insert(indices.end(), t.begin(), t.end());
        const auto values = wall_stream(surface);
        const detail::Mesh mesh({values, {3, 3}}, indices);
        use(wall, camera);
        glUniform1f(glGetUniformLocation(wall, "opacity"), hidden == GL_FRONT ? 0.10f : 0.035f);
        glEnable(GL_CULL_FACE);
        glCullFace(hidden);
        glDrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, nullptr);
        glDisable(GL_CULL_FACE);
        draw_plain(free_edges(surface), GL_LINES, camera);
    }

    void draw(const PictureScene& scene) const
    {
        target.clear();
        draw_background();
        draw_plain(quad_stream(scene.quads), GL_TRIANGLES, scene.camera);
        draw_spheres(scene);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        for (const GLenum hidden : {GL_FRONT, GL_BACK})
            for (const Surface& surface : scene.walls) draw_wall(surface, scene.camera, hidden);
    }
};

Renderer::Renderer(int width, int height) : canvas_(std::make_unique<Canvas>(width, height)) {}
Renderer::~Renderer() = default;

Image Renderer::draw(const PictureScene& scene)
{
    canvas_->draw(scene);
    Image image = canvas_->target.read();
    draw_caption(image, scene.caption);
    return image;
}

} // namespace io

#else

namespace io {

struct Renderer::Canvas {};
Renderer::Renderer(int, int)
{
    throw core::Error(
        "this program was built without EGL and cannot draw pictures: install libegl-dev, libgl-dev and libopengl-dev and build again");
}
Renderer::~Renderer() = default;
Image Renderer::draw(const PictureScene&) { return {}; }

} // namespace io

#endif
