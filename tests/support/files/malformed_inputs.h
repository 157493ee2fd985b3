#pragma once
// Inputs with a fault, and the exact line that a user must read. Also used by tests/system/cli.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace refraster::test {

/// A file to write before the test: its content, then zero bytes up to size_bytes, then `patch` over the bytes at
/// patch_at.
struct TestFile {
  std::string name, content;
  std::uint64_t size_bytes = 0, patch_at = 0;
  std::string patch = {};
};

/// Which function reads `input`. scene: `refraster render`; image: `refraster compare`; merl: `refraster brdf info`.
enum class Reader { scene, obj, image, texture, merl };

struct MalformedInput {
  std::string name; // what is wrong, for the test's report
  Reader reader;
  std::string input;           // the file to read, in the folder of the test
  std::vector<TestFile> files; // a name that ends in '/' is a folder
  std::string expected;        // what InputError says; names of files as seen from that folder
};

const std::vector<MalformedInput>& malformed_inputs();

/// A number as it lies in memory: in little-endian order.
template <class Value>
std::string bytes_of(Value value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// A sound scene of one sphere, in which `from` is replaced by `to`; `from` must be there exactly once.
std::string scene_with(const std::string& from, const std::string& to);

void write_files(const std::filesystem::path& folder, const std::vector<TestFile>& files);

/// A folder of its own under the system's temporary folder, gone at the end.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  std::filesystem::path path;
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

} // namespace refraster::test
