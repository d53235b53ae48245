// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The OpenGL side of the renderer: a context without a display, programs, and meshes on their way to it.
#include "io/picture/png.hpp"
#define EGL_EGLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <span>
#include <vector>

namespace io::detail {

/// The current OpenGL context of this thread, from construction to destruction. @throws core::Error
class Context {
public:
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// Where pictures are drawn: four samples for each pixel, with depth.
class Target {
public:
    Target(int width, int height);
    void clear() const;
    [[nodiscard]] Image read() const;

private:
    int width_, height_;
    GLuint sampled_ = 0, resolved_ = 0;
};

/// @throws core::Error with the compiler's words
[[nodiscard]] GLuint make_program(const char* vertex, const char* fragment);

/// Floats of one vertex (or of one instance) in one stream, and the widths of the attributes they make up.
struct Stream {
    std::span<const float> values;
    std::vector<int> widths;
    GLuint divisor = 0;
};

/// A mesh on the graphics side, for one drawing.
class Mesh {
public:
    explicit Mesh(const Stream& stream, std::span<const unsigned> indices = {});
    ~Mesh();
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;
    void bind() const { glBindVertexArray(array_); }

private:
    GLuint array_ = 0;
    GLuint buffers_[2] = {0, 0};
};

} // namespace io::detail
