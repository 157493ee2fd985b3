#pragma once
// Names of numbered frames: "out/####.png".

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace refraster {

/// A name with a run of # in its last part, for which a number stands.
class FrameNames {
public:
  /// Nothing unless the last part of `pattern` has exactly one run of #.
  static std::optional<FrameNames> of(std::string_view pattern);

  /// Of frame i, counted from 0: "out/0001.png" is the first. More digits than there are # where the number needs them.
  std::string name(std::size_t i) const;
  /// "out/turntable.json", or "out/ball.json" of "out/ball_####.png".
  std::string report_name() const;

private:
  std::string before_, after_;
  std::size_t digits_ = 0;
};

} // namespace refraster
