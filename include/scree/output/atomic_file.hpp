/// Files that are either the old or the new ones, never halves: temporary name, fsync, rename. One rank only.
#pragma once

#include <string>

namespace scree {

/// Name under which a file is written before it takes its place: "<path>.part".
std::string temporary_name(const std::string& path);

/// Flushes `temporary` to the disk and renames it to `path`. Throws std::runtime_error, leaving the old `path` as it
/// is.
void move_into_place(const std::string& temporary, const std::string& path);

/// Replaces the content of `path`. Throws std::runtime_error (disk full, no permission), leaving the old file as it is.
void write_text_atomically(const std::string& path, const std::string& text);

}  // namespace scree
