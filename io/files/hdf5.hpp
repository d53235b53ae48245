// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// HDF5 files with owners for every identifier: rows written by all ranks together, read by each rank alone.
#include "core/comm/communicator.hpp"
#include <cstdint>
#include <hdf5.h>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace io::hdf5 {

/// Owner of one HDF5 identifier.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    Handle() = default;
    Handle(hid_t id, Close close) : id_(id), close_(close) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept
    {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    [[nodiscard]] hid_t get() const { return id_; }
    [[nodiscard]] bool valid() const { return id_ >= 0; }
    /// Closes it now; false if HDF5 could not.
    bool reset() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

/// Consecutive rows of a dataset.
struct Range {
    std::int64_t first = 0, count = 0;
};

/// Rows of `components` numbers: how many the dataset has, and which of them this rank holds, in ascending order.
struct Rows {
    std::int64_t total = 0;
    int components = 1;
    std::vector<Range> mine;
};

enum class Packing { plain, compressed };
/// `checked`: metadata carries checksums (needs HDF5 1.10); `compatible`: readable by old VTK and ParaView.
enum class Format { checked, compatible };

/// One file. Names are paths inside it; groups on the way are made as needed.
/// Element types: double, float, std::int64_t, std::uint64_t, std::uint8_t.
/// @throws core::FileError with the names of file and dataset.
class File {
public:
    /// A new file, opened by all `ranks` together: every call that writes is then collective, in the same order. Room on the
    /// disk is reserved before each dataset: HDF5 itself does not survive a full disk.
    static File create(const std::string& path, const core::Communicator& ranks, Format format);
    /// An old file, opened for reading by this rank alone.
    static File open(const std::string& path);

    template <class T>
    void write(const std::string& name, std::span<const T> values, const Rows& rows, Packing packing = Packing::plain);
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& name, Range range) const;
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& name) const
    {
        return read<T>(name, {0, shape(name).total});
    }
    /// Total number of rows and components; `mine` stays empty.
    [[nodiscard]] Rows shape(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// True if the elements of the dataset are integers.
    [[nodiscard]] bool integers(const std::string& name) const;
    /// Paths of all datasets, sorted.
    [[nodiscard]] std::vector<std::string> datasets() const;

    void make_group(const std::string& name);
    void set_attribute(const std::string& object, const std::string& name, double value);
    void set_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
    /// Stored as a scalar string of fixed length, which is what VTK's readers expect.
    void set_attribute(const std::string& object, const std::string& name, const std::string& value);
    [[nodiscard]] std::vector<std::string> attributes(const std::string& object) const;
    [[nodiscard]] double number_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name) const;
    /// `name` here shows what `target` is in another file; a relative file name starts from this file's folder.
    void link(const std::string& name, const std::string& file, const std::string& target);

    /// Sends everything to the disk.
    void flush();
    /// Closes the file and gives back the room that was not needed.
    void close();
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    File(std::string path, Handle file, std::optional<core::Communicator> writers);
    void reserve(std::size_t bytes);
    void set_attribute(const std::string& object, const std::string& name, std::pair<hid_t, hid_t> type_and_space, const void* value);
    [[nodiscard]] Handle attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] Handle dataset(const std::string& name) const;
    /// Throws unless `good`; the message says what could not be done with which part, and HDF5's own reason.
    void check(bool good, const std::string& action, const std::string& name) const;

    std::string path_;
    std::optional<core::Communicator> writers_;
    std::size_t reserved_ = 0; ///< an upper bound of the size of the file [bytes]
    Handle file_;
};

/// Collective: throws core::FileError on every rank if any rank has a message, the one of the lowest such rank.
void agree(const core::Communicator& ranks, const std::string& message);

/// Runs `action` on every rank and agrees on its outcome.
template <class Action>
void together(const core::Communicator& ranks, Action action)
{
    std::string message;
    try {
        action();
    } catch (const std::exception& error) {
        message = error.what();
    }
    agree(ranks, message);
}

} // namespace io::hdf5
