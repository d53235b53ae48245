// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/strided_copies.hpp"
#include <utility>

namespace core {
bool StridedCopies::Sheet::lengthen(const Step& at)
{
    const Step way{at.to - line.first.to, at.from - line.first.from};
    if (line.count == 1) line.step = way;
    else if (way != Step{line.count * line.step.to, line.count * line.step.from}) return false;
    ++line.count;
    return true;
}

bool StridedCopies::Sheet::append(const Line& next)
{
    const Step way{next.first.to - line.first.to, next.first.from - line.first.from};
    if (next.count != line.count || (line.count > 1 && next.step != line.step)) return false;
    if (lines == 1) pitch = way;
    else if (way != Step{lines * pitch.to, lines * pitch.from}) return false;
    ++lines;
    return true;
}

void StridedCopies::add(std::ptrdiff_t to, std::ptrdiff_t from)
{
    if (!sheets_.empty() && sheets_.back().lengthen({to, from})) return;
    if (sheets_.size() > 1 && sheets_[sheets_.size() - 2].append(sheets_.back().line)) sheets_.pop_back();
    sheets_.push_back({{{to, from}, {}, 1}, {}, 1});
}

void StridedCopies::copy(const double* from, double* to) const
{
    for (const Sheet& sheet : sheets_) {
        const Line& line = sheet.line;
        Step inner = line.step, outer = sheet.pitch;
        std::ptrdiff_t inner_count = line.count, outer_count = sheet.lines;
        if (outer_count > inner_count) { // layers of a halo are thin, and short loops slow
            std::swap(inner, outer);
            std::swap(inner_count, outer_count);
        }
        for (std::ptrdiff_t m = 0; m < outer_count; ++m) {
            double* target = to + line.first.to + m * outer.to;
            const double* source = from + line.first.from + m * outer.from;
            if (inner == Step{1, 1}) {
#pragma omp simd
                for (std::ptrdiff_t n = 0; n < inner_count; ++n) target[n] = source[n];
            } else
                for (std::ptrdiff_t n = 0; n < inner_count; ++n) target[n * inner.to] = source[n * inner.from];
        }
    }
}

} // namespace core
