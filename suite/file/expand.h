#pragma once
// From an entry of a suite file to those that it stands for.

#include "suite/file/suite_keys.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster::suite {

/// Entries of one object of the file. Their names are those of the scenes, or the one given, with what tells the
/// combinations apart: "ball", "ball@softpipe".
struct NamedEntries {
  std::vector<Entry> entries;
  std::vector<std::string> suffixes; // "@softpipe" of each
};

/// Told of what is wrong.
using ExpandFault = std::function<void(const std::string& found, const std::string& expected)>;

/// Each scene that the patterns match, with each combination of the lists. Paths are taken relative to `folder`.
NamedEntries expanded(const EntryText& text, const std::string& folder, const ExpandFault& fault);

/// All entries, with names that differ: where several scenes have one name, the names of their folders stand before it,
/// as many as are needed. What cannot be told apart so is a fault of its group.
std::vector<Entry>
named_apart(std::vector<NamedEntries> groups,
            const std::function<void(std::size_t group, const std::string& found, const std::string& expected)>& fault);

/// A path of a file in `folder`, as seen from the current directory.
std::string path_from(const std::string& folder, const std::string& path);

/// Files that a pattern of the shell (*, ?, []) matches, sorted by bytes; the path itself if it is no pattern.
std::vector<std::string> matching_files(const std::string& pattern);

/// As a file name: letters, digits and -_.@+ stay, everything else becomes '_'.
std::string file_name_of(std::string_view name);

} // namespace refraster::suite
