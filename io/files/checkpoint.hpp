// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checkpoints: the whole state of a run in one file that does not depend on the number of ranks. Written under another
// name, sent to the disk and renamed; every dataset carries XXH3 checksums and the file a seal over them.
#include "io/files/digest.hpp"
#include "io/files/hdf5.hpp"
#include <optional>

namespace io {

/// Writes one checkpoint. All calls are collective; every failure is a core::FileError on all ranks, and leaves the older
/// checkpoints as they were.
class CheckpointWriter {
public:
    /// Will become checkpoint_<step>.h5 in `directory`, which is made if it does not exist.
    CheckpointWriter(const std::string& directory, std::int64_t step, const core::Communicator& ranks);
    ~CheckpointWriter();
    CheckpointWriter(const CheckpointWriter&) = delete;
    CheckpointWriter& operator=(const CheckpointWriter&) = delete;

    /// Bits of the interior of every block.
    void field(const FieldViews<const double>& field, const BlockList& blocks);
    /// A column of `total` rows of which this rank holds those from `first`, in their global order (see RowOrder).
    template <class T>
    void rows(const std::string& name, std::span<const T> values, int components, std::int64_t first, std::int64_t total);
    /// A number that belongs to the state (time, ledger totals); the same on all ranks.
    void scalar(const std::string& name, double value);
    /// A text that does not: version, hash of the scene.
    void note(const std::string& name, const std::string& text);

    /// Makes it a checkpoint, then removes all but the newest `keep` of those up to this step.
    /// @return its path
    std::string finish(int keep = 2);

private:
    void checksums(const std::string& name, const Hashes& hashes);

    core::Communicator ranks_;
    std::string path_, temporary_;
    std::optional<hdf5::File> file_;
    Contents contents_;
};

/// Reads a checkpoint on any number of ranks; whatever it returns has been compared with its checksums. The constructor and
/// verify(), field() and rows() are collective, and a core::FileError that names the dataset comes on all ranks.
class CheckpointReader {
public:
    CheckpointReader(const std::string& path, const core::Communicator& ranks);

    [[nodiscard]] bool has_field(const std::string& name) const { return file_->has("fields/" + name + "/values"); }
    [[nodiscard]] bool has_rows(const std::string& name) const { return file_->has("rows/" + name + "/values"); }
    [[nodiscard]] bool has_scalar(const std::string& name) const { return scalars_.contains(name); }
    /// Fills the interiors of this rank's blocks.
    void field(const FieldViews<double>& field, const BlockList& blocks) const;
    [[nodiscard]] std::int64_t row_count(const std::string& name) const;
    /// Rows [first, first + count), not necessarily different ones on each rank. T is the type that was written.
    template <class T>
    [[nodiscard]] std::vector<T> rows(const std::string& name, std::int64_t first, std::int64_t count) const;
    [[nodiscard]] double scalar(const std::string& name) const;
    /// Empty if there is no such note.
    [[nodiscard]] std::string note(const std::string& name) const;

    /// Compares every dataset with its checksums, shared among the ranks.
    void verify() const;
    /// See Contents::digest().
    [[nodiscard]] std::string digest() const { return contents_.digest(); }

private:
    void read_contents();
    [[nodiscard]] std::vector<double> block(const std::string& name, core::BlockId block) const;
    template <class T>
    [[nodiscard]] std::vector<T> checked_rows(const std::string& name, std::int64_t first, std::int64_t count) const;

    core::Communicator ranks_;
    std::optional<hdf5::File> file_;
    Contents contents_;
    std::map<std::string, Hashes> hashes_;
    std::map<std::string, std::vector<std::int64_t>> extents_; ///< of each block of a field: 3 numbers for each array
    std::map<std::string, double> scalars_;
    std::map<std::string, std::string> notes_;
};

/// The checkpoints of a directory, newest step first.
[[nodiscard]] std::vector<std::string> list_checkpoints(const std::string& directory);

struct CheckpointChoice {
    std::string path;                 ///< empty if there is no good one
    std::vector<std::string> refused; ///< why newer ones were not taken
};
/// The newest checkpoint whose every dataset agrees with its checksums. Collective.
[[nodiscard]] CheckpointChoice newest_good_checkpoint(const std::string& directory, const core::Communicator& ranks);

} // namespace io
