// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Copies of single values from one array to another, kept as rectangles at equal steps: most of a halo is a few of them.
#include <cstddef>
#include <vector>

namespace core {

class StridedCopies {
public:
    /// Adds the copy of element `from` to element `to`; one that goes on as those before lengthens their rectangle.
    void add(std::ptrdiff_t to, std::ptrdiff_t from);
    /// @param from, to  Element 0 of the arrays, which may be the same array: no element is both read and written.
    void copy(const double* from, double* to) const;

private:
    /// Steps of the places read and written.
    struct Step {
        std::ptrdiff_t to = 0, from = 0;
        bool operator==(const Step&) const = default;
    };
    struct Line {
        Step first, step;
        std::ptrdiff_t count = 1;
    };
    /// `lines` copies of a line.
    struct Sheet {
        Line line;
        Step pitch;
        std::ptrdiff_t lines = 1;
        /// Lengthens the line or takes it in as the next one; false if it does not fit.
        bool lengthen(const Step& at);
        bool append(const Line& next);
    };
    std::vector<Sheet> sheets_; ///< the last is one line, that may still grow
};

} // namespace core
