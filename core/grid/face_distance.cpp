// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/face_distance.hpp"
#include "core/grid/boundary_faces.hpp"

#include <algorithm>

namespace core {
namespace {

double distance_to_edge(const Vec3& x, const Vec3& a, const Vec3& b)
{
    const Vec3 edge = b - a;
    const double square = edge.squaredNorm();
    const double share = square > 0 ? std::clamp((x - a).dot(edge) / square, 0.0, 1.0) : 0.0;
    return (x - a - share * edge).norm();
}

Vec3 middle(const Quad& q) { return 0.25 * (q[0] + q[1] + q[2] + q[3]); }

/// Of the four triangles about its middle: neighbours share their edges whatever their shape.
double distance_to_face(const Vec3& x, const Quad& q)
{
    const Vec3 centre = middle(q);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < 4; ++n) nearest = std::min(nearest, distance_to_triangle(x, centre, q[n], q[(n + 1) % 4]));
    return nearest;
}

double distance_to_box(const Vec3& x, const Vec3& low, const Vec3& high) { return (low - x).cwiseMax(x - high).cwiseMax(0.0).norm(); }

} // namespace

double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const auto inside = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(x - from).dot(normal) >= 0; };
    const double area = normal.norm();
    if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a)) return std::abs((x - a).dot(normal)) / area;
    return std::min({distance_to_edge(x, a, b), distance_to_edge(x, b, c), distance_to_edge(x, c, a)});
}

FaceDistance::FaceDistance(const Mesh& mesh, std::span<const std::string> names) : images_{Motion()}
{
    for_each_boundary_face(mesh, names, [&](const Boundary&, const Quad& face) { faces_.push_back(face); });
    for (const Vec3& period : mesh.periods())
        for (std::size_t n = 0, before = images_.size(); n < before; ++n)
            for (const double sense : {-1.0, 1.0}) images_.push_back(images_[n].then(Motion(sense * period)));
    if (const auto& turn = mesh.turn())
        for (std::size_t n = 0, before = images_.size(); n < before; ++n)
            for (const Motion& m : {turn->motion().inverse(), turn->motion()}) images_.push_back(images_[n].then(m));
    if (!faces_.empty()) build(0, int(faces_.size()));
}

int FaceDistance::build(int first, int last)
{
    constexpr int most_in_leaf = 4;
    const auto begin = faces_.begin();
    Node node{(*(begin + first))[0], (*(begin + first))[0], first, last};
    for (int n = first; n < last; ++n)
        for (const Vec3& x : *(begin + n)) node.low = node.low.cwiseMin(x), node.high = node.high.cwiseMax(x);
    const int mine = int(nodes_.size());
    nodes_.push_back(node);
    if (last - first <= most_in_leaf) return mine;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const int half = (first + last) / 2;
    std::nth_element(begin + first, begin + half, begin + last,
                     [axis](const Quad& p, const Quad& q) { return middle(p)[axis] < middle(q)[axis]; });
    build(first, half);
    const int upper = build(half, last);
    nodes_[std::size_t(mine)].upper_child = upper;
    return mine;
}

void FaceDistance::search(const Vec3& x, double& nearest) const
{
    std::array<int, 128> waiting; // two for each level of the tree
    int count = 0;
    waiting[std::size_t(count++)] = 0;
    const auto distance = [&](int n) { return distance_to_box(x, nodes_[std::size_t(n)].low, nodes_[std::size_t(n)].high); };
    while (count > 0) {
        const int number = waiting[std::size_t(--count)];
        const Node& node = nodes_[std::size_t(number)];
        if (distance(number) > nearest) continue;
        if (node.upper_child == 0) {
            for (int n = node.first; n < node.last; ++n) nearest = std::min(nearest, distance_to_face(x, faces_[std::size_t(n)]));
            continue;
        }
        const int lower = number + 1, upper = node.upper_child;
        const bool lower_first = distance(lower) < distance(upper);
        waiting[std::size_t(count++)] = lower_first ? upper : lower;
        waiting[std::size_t(count++)] = lower_first ? lower : upper;
    }
}

double FaceDistance::at(const Vec3& x, double enough) const
{
    double nearest = enough;
    if (nodes_.empty()) return nearest;
    for (const Motion& image : images_) search(image.of_position(x), nearest);
    return nearest;
}

Array3<double> FaceDistance::of_cells(const BlockGeometry& geometry) const
{
    Array3<double> distance(geometry.cells);
    Vec3 last = geometry.centre(0, 0, 0);
    double there = at(last);
    for_each_cell(geometry.cells, [&](int i, int j, int k) {
        const Vec3 x = geometry.centre(i, j, k);
        constexpr double round_off = 1 + 1e-9;
        there = at(x, round_off * (there + (x - last).norm()));
        distance(i, j, k) = there;
        last = x;
    });
    return distance;
}

} // namespace core
