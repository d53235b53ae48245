// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one place where the keys of a scene are named, explained and bound to their structs.
#include "io/scene/scene.hpp"
#include "io/scene/schema.hpp"

namespace io {

void describe(Schema& s, Scene& scene);

} // namespace io
