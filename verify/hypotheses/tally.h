#pragma once
// How many pixels hypotheses explain.

#include "verify/hypotheses/pixel_colours.h"
#include "verify/hypotheses/rank.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace refraster::hypotheses {

/// Of one hypothesis, over some pixels.
struct Tally {
  std::size_t unexplained = 0, explained = 0; // looked at
  std::size_t fits = 0, kept = 0;             // of these: those whose value it explains
  double nearer = 0; // sum over unexplained pixels: 1 - distance to the value / that of the reference, in [-1, 1]

  double explained_share() const { return fraction_of(fits, unexplained); }
  double kept_share() const { return explained == 0 ? 1 : fraction_of(kept, explained); }
  double score() const { return explained_share() + kept_share() - 1; }
  double nearness() const { return unexplained == 0 ? 0 : nearer / static_cast<double>(unexplained); }

private:
  static double fraction_of(std::size_t part, std::size_t all) {
    return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
  }
};

/// Draws hypotheses at the pixels of a request. What is the same for all of them is made once.
class Tallying {
public:
  explicit Tallying(const RankRequest& request);

  /// The objects to which unexplained pixels belong.
  const std::vector<bool>& suspects() const { return setting_.suspect; }
  bool background_suspect() const { return setting_.background_suspect; }

  /// One for each of `steps`, over at most so many pixels of each kind, spread evenly over those of the request. Of the
  /// explained ones those count that belong to suspects.
  std::vector<Tally> over(std::span<const Steps> steps, std::size_t pixels);

private:
  struct Judged {
    const JudgedPixel* pixel;
    bool explained;
  };
  /// A pixel as a view has it.
  struct Place {
    std::vector<Tap> taps;
    std::vector<std::vector<Covering>> covering; // of each alternative, tap by tap
  };

  void find_suspects();
  void find_shift();
  const WindowGeometry& geometry(View view);
  std::vector<Place> places(View view, std::span<const Judged> pixels);
  std::vector<Judged> chosen(std::size_t pixels) const;

  const RankRequest& request_;
  ImageKind image_;
  int threads_;
  Prepared prepared_;
  Setting setting_;
  ImageShift shift_;
  std::vector<const JudgedPixel*> of_suspects_; // explained pixels
  std::vector<std::pair<Projection, std::unique_ptr<WindowGeometry>>> geometries_;
};

} // namespace refraster::hypotheses
