// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Draws scenes without a display: EGL on no surface and OpenGL 4.5, in software (Mesa) or on a graphics card.
#include "io/picture/picture.hpp"
#include "io/picture/png.hpp"
#include <memory>

namespace io {

/// To be made and used by one and the same thread.
class Renderer {
public:
    /// @throws core::Error if this machine cannot draw, with what to install
    Renderer(int width, int height);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    [[nodiscard]] Image draw(const PictureScene& scene);

private:
    struct Canvas;
    std::unique_ptr<Canvas> canvas_;
};

} // namespace io
