// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#ifdef ISAGO_EGL
#include "io/picture/picture_canvas.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

namespace io::detail {
namespace {

void need(bool condition, const char* what)
{
    core::require<core::Error>(condition, core::text("pictures cannot be drawn here: ", what, " (EGL error ", eglGetError(),
                                                     "). Install libegl-mesa0 and libgl1-mesa-dri, or leave pictures out."));
}

} // namespace

Context::Context()
{
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    need(display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr), "there is no EGL display without a screen");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display_, wanted, &config, 1, &count);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, count ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    need(context_ != EGL_NO_CONTEXT, "OpenGL 4.5 is missing");
    need(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_), "its context cannot be used");
}

Context::~Context()
{
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_); // the display stays: other renderers share it
}

Target::Target(int width, int height) : width_(width), height_(height)
{
    constexpr int samples = 4;
    std::array<GLuint, 3> stores{};
    glGenRenderbuffers(3, stores.data());
    glGenFramebuffers(1, &sampled_);
    glGenFramebuffers(1, &resolved_);
    const auto attach = [&](GLuint store, int count, GLenum format, GLenum place) {
        glBindRenderbuffer(GL_RENDERBUFFER, store);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, store);
    };
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    attach(stores[0], samples, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(stores[1], samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    need(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "a picture of this size is refused");
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    attach(stores[2], 0, GL_RGBA8, GL_COLOR_ATTACHMENT0);
}

void Target::clear() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    glViewport(0, 0, width_, height_);
    glDepthMask(GL_TRUE); // clearing obeys the mask
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Image Target::read() const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    const auto row = std::size_t(3 * width_);
    std::vector<std::uint8_t> rising(row * std::size_t(height_));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, rising.data());
    need(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
    Image image{width_, height_, std::vector<std::uint8_t>(rising.size())};
    for (std::size_t y = 0; y < std::size_t(height_); ++y)
        std::copy_n(rising.begin() + std::ptrdiff_t(row * (std::size_t(height_) - 1 - y)), row,
                    image.rgb.begin() + std::ptrdiff_t(row * y));
    return image;
}

GLuint make_program(const char* vertex, const char* fragment)
{
    const GLuint program = glCreateProgram();
    for (const auto& [kind, text] : {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(GLenum(kind));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        GLint good = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        std::string words(1000, '\0');
        if (!good) glGetShaderInfoLog(shader, GLsizei(words.size()), nullptr, words.data());
        need(good, words.c_str());
    }
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    std::string words(1000, '\0');
    if (!good) glGetProgramInfoLog(program, GLsizei(words.size()), nullptr, words.data());
    need(good, words.c_str());
    return program;
}

Mesh::Mesh(const Stream& stream, std::span<const unsigned> indices)
{
    glGenVertexArrays(1, &array_);
    glGenBuffers(2, buffers_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(stream.values.size_bytes()), stream.values.data(), GL_STREAM_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size_bytes()), indices.data(), GL_STREAM_DRAW);
    const int total = std::accumulate(stream.widths.begin(), stream.widths.end(), 0);
    std::size_t offset = 0;
    for (GLuint n = 0; n < stream.widths.size(); ++n) {
        glEnableVertexAttribArray(n);
        glVertexAttribPointer(n, stream.widths[n], GL_FLOAT, GL_FALSE, GLsizei(total * int(sizeof(float))),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(n, stream.divisor);
        offset += sizeof(float) * std::size_t(stream.widths[n]);
    }
}

Mesh::~Mesh()
{
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(2, buffers_);
}

} // namespace io::detail
#endif
