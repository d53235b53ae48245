// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/files/checkpoint.hpp"
#include "io/files/durable.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numeric>

namespace io {
namespace {

namespace fs = std::filesystem;
constexpr const char* part = ".part";

/// Extents of every array of every block, by global id; throws unless each block has exactly one owner.
std::vector<std::int64_t> all_extents(const FieldViews<const double>& field, const BlockList& blocks, const core::Communicator& ranks)
{
    std::int64_t arrays = field.blocks.empty() ? 0 : std::int64_t(field.blocks.front().size());
    ranks.max({&arrays, 1});
    std::vector<std::int64_t> extents(std::size_t(3 * arrays * blocks.total), 0), owners(std::size_t(blocks.total), 0);
    for (std::size_t b = 0; b < blocks.own.size(); ++b) {
        auto* size = &extents[std::size_t(3 * arrays * blocks.own[b])];
        for (const auto& view : field.blocks[b])
            for (int axis = 0; axis < 3; ++axis) *size++ = view.extents()[axis];
        ++owners[std::size_t(blocks.own[b])];
    }
    ranks.sum(extents);
    ranks.sum(owners);
    for (std::size_t b = 0; b < owners.size(); ++b)
        core::require<core::Error>(owners[b] == 1, core::text("field '", field.name, "': block ", b, " has ", owners[b], " owners"));
    return extents;
}

/// First value of each block in the file, and after the last block the number of values.
std::vector<std::int64_t> offsets(const std::vector<std::int64_t>& extents, int blocks)
{
    std::vector<std::int64_t> first(std::size_t(blocks) + 1, 0);
    const std::size_t width = blocks ? extents.size() / std::size_t(blocks) : 0;
    for (std::size_t b = 0; b < std::size_t(blocks); ++b) {
        first[b + 1] = first[b];
        for (std::size_t e = b * width; e < (b + 1) * width; e += 3) first[b + 1] += extents[e] * extents[e + 1] * extents[e + 2];
    }
    return first;
}

hdf5::Rows only_on_root(const core::Communicator& ranks, std::size_t total, int components = 1)
{
    hdf5::Rows rows{std::int64_t(total), components, {}};
    if (ranks.rank() == 0) rows.mine = {{0, rows.total}};
    return rows;
}

template <class T>
std::span<const T> on_root(const core::Communicator& ranks, const std::vector<T>& values)
{
    return ranks.rank() == 0 ? std::span<const T>(values) : std::span<const T>();
}

} // namespace

CheckpointWriter::CheckpointWriter(const std::string& directory, std::int64_t step, const core::Communicator& ranks)
    : ranks_(ranks), path_((fs::path(directory) / fmt::format("checkpoint_{:010}.h5", step)).string()), temporary_(path_ + part)
{
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() != 0) return;
        make_directory(directory);
        for (const auto& entry : fs::directory_iterator(directory))
            if (entry.path().extension() == part && entry.path().filename().string().starts_with("checkpoint_")) fs::remove(entry.path());
        make_empty_file(temporary_);
    });
    hdf5::together(ranks_, [&] { file_ = hdf5::File::create(temporary_, ranks_, hdf5::Format::checked); });
}

CheckpointWriter::~CheckpointWriter()
{
    if (!file_) return;
    file_.reset();
    std::error_code ignored;
    if (ranks_.rank() == 0) fs::remove(temporary_, ignored);
}

void CheckpointWriter::checksums(const std::string& name, const Hashes& hashes)
{
    file_->write(name + "/checksums", on_root(ranks_, hashes), only_on_root(ranks_, hashes.size()));
    contents_.set(name, hashes);
}

void CheckpointWriter::field(const FieldViews<const double>& field, const BlockList& blocks)
{
    const std::string name = "fields/" + field.name;
    const auto extents = all_extents(field, blocks, ranks_);
    const auto first = offsets(extents, blocks.total);
    Hashes hashes(std::size_t(blocks.total), 0);
    std::vector<double> values;
    hdf5::Rows rows{first.back(), 1, {}};
    for (const core::LocalBlock b : in_global_order(blocks)) {
        const core::BlockId id = blocks.own[std::size_t(b)];
        const auto mine = interior(field.blocks[std::size_t(b)]);
        hashes[std::size_t(id)] = block_hash(mine, id);
        rows.mine.push_back({first[std::size_t(id)], std::int64_t(mine.size())});
        values.insert(values.end(), mine.begin(), mine.end());
    }
    sum_over_ranks(ranks_, hashes);
    hdf5::together(ranks_, [&] {
        const int width = blocks.total ? int(extents.size()) / blocks.total : 1;
        file_->write(name + "/values", std::span<const double>(values), rows);
        file_->write(name + "/extents", on_root(ranks_, extents), only_on_root(ranks_, std::size_t(blocks.total), width));
        checksums(name, hashes);
    });
}

template <class T>
void CheckpointWriter::rows(const std::string& name, std::span<const T> values, int components, std::int64_t first, std::int64_t total)
{
    const std::int64_t count = std::int64_t(values.size()) / components;
    Hashes hashes = row_hashes(std::as_bytes(values), sizeof(T) * std::size_t(components), first, total);
    sum_over_ranks(ranks_, hashes);
    hdf5::together(ranks_, [&] {
        file_->write("rows/" + name + "/values", values, {total, components, {{first, count}}});
        checksums("rows/" + name, hashes);
    });
}

template void CheckpointWriter::rows<double>(const std::string&, std::span<const double>, int, std::int64_t, std::int64_t);
template void CheckpointWriter::rows<std::int64_t>(const std::string&, std::span<const std::int64_t>, int, std::int64_t, std::int64_t);

void CheckpointWriter::scalar(const std::string& name, double value)
{
    hdf5::together(ranks_, [&] { file_->set_attribute("scalars", name, value); });
    contents_.set_scalar(name, value);
}

void CheckpointWriter::note(const std::string& name, const std::string& text)
{
    hdf5::together(ranks_, [&] { file_->set_attribute("notes", name, text); });
    contents_.set_note(name, text);
}

std::string CheckpointWriter::finish(int keep)
{
    hdf5::together(ranks_, [&] {
        file_->set_attribute("/", "format", std::string("isago checkpoint 1"));
        file_->set_attribute("/", "seal", contents_.seal());
        file_->flush();
    });
    hdf5::together(ranks_, [&] { file_->close(); });
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() != 0) return;
        rename_durably(temporary_, path_);
        auto all = list_checkpoints(fs::path(path_).parent_path().string());
        std::erase_if(all, [&](const std::string& other) { return other > path_; });
        for (std::size_t n = std::size_t(keep); n < all.size(); ++n) fs::remove(all[n]);
    });
    file_.reset();
    return path_;
}

} // namespace io
