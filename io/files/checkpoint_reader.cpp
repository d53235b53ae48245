// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/files/checkpoint.hpp"

#include <algorithm>
#include <filesystem>

namespace io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why)
{
    throw core::FileError(core::text(path, ": ", why, ". This checkpoint is damaged and will not be used."));
}

std::int64_t values_in(std::span<const std::int64_t> extents)
{
    std::int64_t count = 0;
    for (std::size_t e = 0; e + 2 < extents.size(); e += 3) count += extents[e] * extents[e + 1] * extents[e + 2];
    return count;
}

} // namespace

CheckpointReader::CheckpointReader(const std::string& path, const core::Communicator& ranks) : ranks_(ranks)
{
    hdf5::together(ranks_, [&] {
        file_ = hdf5::File::open(path);
        read_contents();
    });
}

void CheckpointReader::read_contents()
{
    const std::string ending = "/checksums";
    for (const std::string& name : file_->datasets()) {
        if (!name.ends_with(ending)) continue;
        const std::string item = name.substr(0, name.size() - ending.size());
        hashes_[item] = file_->read<std::uint64_t>(name);
        contents_.set(item, hashes_[item]);
        if (!item.starts_with("fields/")) continue;
        extents_[item] = file_->read<std::int64_t>(item + "/extents");
        if (values_in(extents_[item]) != file_->shape(item + "/values").total)
            refuse(file_->path(), "dataset '" + item + "/extents' disagrees with the number of values");
    }
    for (const std::string& name : file_->attributes("scalars"))
        contents_.set_scalar(name, scalars_[name] = file_->number_attribute("scalars", name));
    for (const std::string& name : file_->attributes("notes"))
        contents_.set_note(name, notes_[name] = file_->text_attribute("notes", name));
    if (file_->text_attribute("/", "format") != "isago checkpoint 1") refuse(file_->path(), "it has another format");
    if (file_->text_attribute("/", "seal") != contents_.seal())
        refuse(file_->path(), "the seal over its checksums, scalars and notes is broken");
}

std::vector<double> CheckpointReader::block(const std::string& name, core::BlockId block) const
{
    const auto& extents = extents_.at(name);
    const std::size_t width = extents.size() / hashes_.at(name).size();
    const std::span all(extents);
    const std::int64_t first = values_in(all.first(std::size_t(block) * width));
    auto values = file_->read<double>(name + "/values", {first, values_in(all.subspan(std::size_t(block) * width, width))});
    if (block_hash(values, block) != hashes_.at(name)[std::size_t(block)])
        refuse(file_->path(), core::text("dataset '", name, "/values' does not agree with its checksum in block ", block));
    return values;
}

void CheckpointReader::field(const FieldViews<double>& field, const BlockList& blocks) const
{
    const std::string name = "fields/" + field.name;
    hdf5::together(ranks_, [&] {
        core::require<core::FileError>(extents_.contains(name), core::text(file_->path(), ": there is no field '", field.name, "'"));
        const auto& extents = extents_.at(name);
        const std::size_t count = hashes_.at(name).size(), width = count ? extents.size() / count : 0;
        core::require<core::FileError>(count == std::size_t(blocks.total), core::text(file_->path(), ": field '", field.name, "' has ",
                                                                                      count, " blocks, this run has ", blocks.total));
        for (std::size_t b = 0; b < blocks.own.size(); ++b) {
            std::vector<std::int64_t> expected;
            for (const auto& view : field.blocks[b])
                for (int axis = 0; axis < 3; ++axis) expected.push_back(view.extents()[axis]);
            const auto found = std::span(extents).subspan(std::size_t(blocks.own[b]) * width, width);
            core::require<core::FileError>(
                std::ranges::equal(expected, found),
                core::text(file_->path(), ": field '", field.name, "', block ", blocks.own[b], ": its size differs from that of this run"));
            set_interior(field.blocks[b], block(name, blocks.own[b]));
        }
    });
}

std::int64_t CheckpointReader::row_count(const std::string& name) const { return file_->shape("rows/" + name + "/values").total; }

template <class T>
std::vector<T> CheckpointReader::checked_rows(const std::string& name, std::int64_t first, std::int64_t count) const
{
    const hdf5::Rows shape = file_->shape(name + "/values");
    if (count == 0) return {};
    const std::int64_t low = first / rows_per_hash * rows_per_hash;
    const std::int64_t high = std::min(shape.total, (first + count + rows_per_hash - 1) / rows_per_hash * rows_per_hash);
    auto values = file_->read<T>(name + "/values", {low, high - low});
    const auto width = std::size_t(shape.components);
    const Hashes found = row_hashes(std::as_bytes(std::span<const T>(values)), sizeof(T) * width, low, shape.total);
    const Hashes& expected = hashes_.at(name);
    bool same = found.size() == expected.size();
    for (auto chunk = std::size_t(low / rows_per_hash); same && std::int64_t(chunk) * rows_per_hash < high; ++chunk)
        same = found[chunk] == expected[chunk];
    if (!same) refuse(file_->path(), "dataset '" + name + "/values' does not agree with its checksum");
    const auto begin = values.begin() + std::ptrdiff_t(std::size_t(first - low) * width);
    return {begin, begin + std::ptrdiff_t(std::size_t(count) * width)};
}

template <class T>
std::vector<T> CheckpointReader::rows(const std::string& name, std::int64_t first, std::int64_t count) const
{
    std::vector<T> values;
    hdf5::together(ranks_, [&] {
        core::require<core::FileError>(has_rows(name), core::text(file_->path(), ": there is no column '", name, "'"));
        values = checked_rows<T>("rows/" + name, first, count);
    });
    return values;
}

template std::vector<double> CheckpointReader::rows<double>(const std::string&, std::int64_t, std::int64_t) const;
template std::vector<std::int64_t> CheckpointReader::rows<std::int64_t>(const std::string&, std::int64_t, std::int64_t) const;

double CheckpointReader::scalar(const std::string& name) const
{
    const auto found = scalars_.find(name);
    core::require<core::FileError>(found != scalars_.end(), core::text(file_->path(), ": there is no scalar '", name, "'"));
    return found->second;
}

std::string CheckpointReader::note(const std::string& name) const
{
    const auto found = notes_.find(name);
    return found == notes_.end() ? std::string() : found->second;
}

void CheckpointReader::verify() const
{
    hdf5::together(ranks_, [&] {
        std::int64_t turn = 0;
        const auto mine = [&] { return turn++ % ranks_.size() == ranks_.rank(); };
        for (const auto& [name, hashes] : hashes_)
            for (std::size_t part = 0; part < hashes.size(); ++part) {
                if (!mine()) continue;
                if (name.starts_with("fields/")) {
                    (void)block(name, core::BlockId(part));
                    continue;
                }
                const std::int64_t first = std::int64_t(part) * rows_per_hash;
                const std::int64_t count = std::min(rows_per_hash, file_->shape(name + "/values").total - first);
                if (file_->integers(name + "/values")) (void)checked_rows<std::int64_t>(name, first, count);
                else (void)checked_rows<double>(name, first, count);
            }
    });
}

std::vector<std::string> list_checkpoints(const std::string& directory)
{
    std::vector<std::string> paths;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory, missing)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("checkpoint_") && name.ends_with(".h5")) paths.push_back(entry.path().string());
    }
    std::sort(paths.rbegin(), paths.rend());
    return paths;
}

CheckpointChoice newest_good_checkpoint(const std::string& directory, const core::Communicator& ranks)
{
    CheckpointChoice choice;
    for (const std::string& path : list_checkpoints(directory)) {
        try {
            const CheckpointReader reader(path, ranks);
            reader.verify();
            choice.path = path;
            break;
        } catch (const core::FileError& error) {
            choice.refused.emplace_back(error.what());
        }
    }
    return choice;
}

} // namespace io
