// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The programs that run on the graphics side (OpenGL Shading Language 4.5).

namespace io::detail {

/// A quiet gradient behind everything: one triangle that covers the picture.
inline constexpr const char* background_vertex = R"(#version 450
out float height;
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    height = 0.5 * corner.y + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
})";
inline constexpr const char* background_fragment = R"(#version 450
in float height;
out vec4 pixel;
void main() { pixel = vec4(mix(vec3(0.905, 0.92, 0.935), vec3(0.99, 0.99, 0.985), smoothstep(0.0, 0.8, height)), 1.0); })";

/// A square that faces the eye and just covers the outline of the sphere.
inline constexpr const char* sphere_vertex = R"(#version 450
layout(location = 0) in vec4 sphere;
layout(location = 1) in vec3 colour;
layout(location = 2) in vec4 sky;
uniform mat4 view, projection;
sample out vec3 point;
flat out vec4 ball;
flat out vec3 paint;
flat out vec4 cover;
void main()
{
    vec3 centre = (view * vec4(sphere.xyz, 1.0)).xyz;
    float distance = length(centre);
    vec3 ahead = centre / distance;
    vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0))), up = cross(right, ahead);
    float size = 1.02 * sphere.w * distance / sqrt(max(distance * distance - sphere.w * sphere.w, 1e-3 * distance * distance));
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    point = centre + size * (corner.x * right + corner.y * up);
    ball = vec4(centre, sphere.w);
    paint = colour;
    cover = vec4(mat3(view) * sky.xyz, sky.w);
    gl_Position = projection * vec4(point, 1.0);
})";

/// The exact point where the ray meets the sphere; key light, sky light between the neighbours, a soft highlight, and a
/// slightly darker rim that sets each grain off from the next.
inline constexpr const char* sphere_fragment = R"(#version 450
sample in vec3 point;
flat in vec4 ball;
flat in vec3 paint;
flat in vec4 cover;
uniform mat4 view, projection;
uniform vec3 light;
out vec4 pixel;
void main()
{
    vec3 ray = normalize(point);
    float along = dot(ray, ball.xyz);
    float inside = along * along - dot(ball.xyz, ball.xyz) + ball.w * ball.w;
    if (inside < 0.0) discard;
    vec3 hit = ray * (along - sqrt(inside)), normal = (hit - ball.xyz) / ball.w;
    vec4 place = projection * vec4(hit, 1.0);
    gl_FragDepth = 0.5 * place.z / place.w + 0.5;

    float open = 1.0 - clamp(0.60 * (cover.w + dot(cover.xyz, normal)), 0.0, 0.82);
    float lit = clamp(1.0 - 0.9 * max(0.0, cover.w + dot(cover.xyz, light)), 0.25, 1.0);
    float up = 0.5 + 0.5 * dot(normal, mat3(view) * vec3(0.0, 1.0, 0.0));
    float key = max(0.0, dot(normal, light)), facing = max(0.0, -dot(normal, ray));
    vec3 base = pow(paint, vec3(2.2));
    vec3 sky = mix(vec3(0.52, 0.50, 0.50), vec3(0.80, 0.85, 0.92), up) * open;
    vec3 shine = base * (0.62 * sky + 0.72 * lit * key * vec3(1.0, 0.97, 0.92));
    shine += 0.10 * lit * pow(max(0.0, dot(normal, normalize(light - ray))), 48.0);
    shine *= mix(0.55, 1.0, smoothstep(0.0, 0.42, facing));
    pixel = vec4(pow(shine, vec3(1.0 / 2.2)), 1.0);
})";

/// Walls of clear glass: seen edge-on they show, face-on they hardly do.
inline constexpr const char* wall_vertex = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
uniform mat4 view, projection;
out vec3 point, across;
void main()
{
    vec4 seen = view * vec4(place, 1.0);
    point = seen.xyz;
    across = mat3(view) * normal;
    gl_Position = projection * seen;
})";
inline constexpr const char* wall_fragment = R"(#version 450
in vec3 point, across;
uniform vec3 light;
uniform float opacity;
out vec4 pixel;
void main()
{
    vec3 ray = normalize(point), normal = normalize(across);
    float grazing = 1.0 - abs(dot(normal, ray));
    if (dot(normal, ray) > 0.0) normal = -normal;
    float glint = pow(max(0.0, dot(normal, normalize(light - ray))), 60.0);
    pixel = vec4(mix(vec3(0.46, 0.58, 0.70), vec3(1.0), glint), opacity + 0.34 * pow(grazing, 3.5) + 0.30 * glint);
})";

/// Plain colours: quads of cross-sections, and the free edges of walls.
inline constexpr const char* plain_vertex = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
uniform mat4 view, projection;
out vec4 paint;
void main()
{
    paint = colour;
    gl_Position = projection * (view * vec4(place, 1.0));
})";
inline constexpr const char* plain_fragment = R"(#version 450
in vec4 paint;
out vec4 pixel;
void main() { pixel = paint; })";

} // namespace io::detail
