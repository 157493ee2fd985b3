#pragma once
// What images are expected to be: a folder with refs.json, and an image for each reference that is one.

#include "suite/entry/entry.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace refraster::suite {

/// A reference, and how it came about.
struct Reference {
  ReferenceKind kind = ReferenceKind::image;
  std::string sha256; // of the image's file, or of float_image_digest()
  int width = 0, height = 0;
  std::string version, precision; // of the program, and of shading
  std::string reason;             // why it was stored; may be empty
  std::string stored;             // when: UTC
  double seconds = 0;             // that the entry took then: what shards go by

  static void fields(auto& self, auto&& field) {
    field("reference", self.kind);
    field("sha256", self.sha256);
    field("width", self.width);
    field("height", self.height);
    field("version", self.version);
    field("precision", self.precision);
    field("reason", self.reason);
    field("stored", self.stored);
    field("seconds", self.seconds);
  }
  bool operator==(const Reference&) const = default;
};

/// A folder of references. Its images have the names of their entries. refs.json is what counts: where an update was
/// ended after that was written and before all images had their names, the others are still found, under the names they
/// were written by.
class References {
public:
  /// A folder without refs.json, or none at all, has no records; images may lie there all the same, from another
  /// program. Throws InputError for a refs.json that is not as it should be.
  explicit References(std::string folder);

  const std::string& folder() const { return folder_; }
  /// Null without a record.
  const Reference* find(const std::string& name) const;
  /// The image of this entry; empty if there is none.
  std::string image_of(const std::string& name) const;
  const std::map<std::string, Reference>& all() const { return all_; }

private:
  std::string folder_;
  std::map<std::string, Reference> all_;
};

/// refs.json of these, in the order of their names.
std::string references_json(const std::map<std::string, Reference>& all);

/// Under this name a new image waits in the folder until refs.json says that it counts.
std::string waiting_name(const std::string& name, std::string_view sha256);

/// sha256 of an image of floats: of its size, and of every value's bits.
std::string float_image_digest(const Image<float>& image);

inline constexpr std::string_view references_file = "refs.json";

} // namespace refraster::suite
