// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A sum of reals without any rounding: its bits depend on what is added alone, not on the order, the threads or the ranks.
#include <array>
#include <cmath>
#include <cstdint>

namespace core {

/// A fixed-point number with 640 bits. Terms are cut off at 2^-320; those from 2^287 on, or not finite, are left out: whatever makes
/// them fails by itself.
/// @source  Kulisch (2013), Computer arithmetic and validity: the long accumulator.
class ExactSum {
public:
    static constexpr int digits = 20;
    using Digits = std::array<std::int64_t, digits>;

    void add(double x)
    {
        if (x == 0.0 || !(std::abs(x) < 0x1p287)) return;
        int exponent = 0;
        const double share = std::frexp(std::abs(x), &exponent);
        auto mantissa = std::uint64_t(std::ldexp(share, mantissa_bits));
        int place = exponent - mantissa_bits - lowest;
        if (place < 0) {
            mantissa = place > -mantissa_bits ? mantissa >> -place : 0;
            place = 0;
        }
        const auto first = std::size_t(place / digit_bits);
        const int shift = place % digit_bits;
        const std::int64_t sign = x < 0.0 ? -1 : 1;
        const std::uint64_t low = (mantissa & mask) << shift, high = (mantissa >> digit_bits) << shift;
        digit_[first] += sign * std::int64_t(low & mask);
        digit_[first + 1] += sign * std::int64_t((low >> digit_bits) + (high & mask));
        digit_[first + 2] += sign * std::int64_t(high >> digit_bits);
        if (++pending_ == most_pending) carry();
    }

    void add(const ExactSum& other) { add(other.parts()); }
    /// Adds parts(), or the sum of those of many ranks, digit by digit.
    void add(const Digits& parts)
    {
        carry();
        for (std::size_t n = 0; n < digits; ++n) digit_[n] += parts[n];
        carry();
    }
    /// Digits that may be added to those of up to 2^30 others before they are read.
    [[nodiscard]] Digits parts() const
    {
        ExactSum copy = *this;
        copy.carry();
        return copy.digit_;
    }

    [[nodiscard]] double value() const
    {
        ExactSum size = *this;
        size.carry();
        const bool negative = size.digit_.back() < 0;
        if (negative) {
            for (std::int64_t& d : size.digit_) d = -d;
            size.carry();
        }
        double sum = 0.0;
        for (int n = digits - 1; n >= 0; --n) sum += std::ldexp(double(size.digit_[std::size_t(n)]), lowest + digit_bits * n);
        return negative ? -sum : sum;
    }

private:
    static constexpr int digit_bits = 32, mantissa_bits = 53, lowest = -320;
    static constexpr std::uint64_t mask = (std::uint64_t(1) << digit_bits) - 1;
    static constexpr int most_pending = 1 << 28;

    /// All digits but the highest become 0..2^32 - 1.
    void carry()
    {
        for (std::size_t n = 0; n + 1 < digits; ++n) {
            const std::int64_t over = digit_[n] >> digit_bits;
            digit_[n] -= over << digit_bits;
            digit_[n + 1] += over;
        }
        pending_ = 0;
    }

    Digits digit_{};
    int pending_ = 0;
};

} // namespace core
