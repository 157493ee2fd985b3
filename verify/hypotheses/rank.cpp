#include "verify/hypotheses/rank.h"

#include "verify/hypotheses/hypothesis_list.h"
#include "verify/hypotheses/tally.h"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <optional>

namespace refraster::hypotheses {
namespace {

/// Of each kind, on which all are tried; those that are shown then on all. A share is known to 6 % of the pixels then,
/// at two standard deviations.
constexpr std::size_t first_pixels = 256;
/// On which it is decided what is tried beside the most promising single one.
constexpr std::size_t few_pixels = 96;
constexpr std::size_t best_singles = 10, shown_singles = 5, best_pairs = 5;
/// A single hypothesis is enough from this score on; and a pair must be better than the best single by so much, as it
/// fits more images by chance.
constexpr double enough = 0.95, pair_margin = 0.05;

struct Candidate {
  std::vector<std::size_t> of; // in the list of hypotheses: one, or two
  Steps steps;
  Tally tally;

  /// Whether it is to be shown before the other: by what it explains, less what it breaks; of equals the single one,
  /// then the one that stands first in the list.
  bool before(const Candidate& other) const {
    if (tally.score() != other.tally.score()) return tally.score() > other.tally.score();
    if (of.size() != other.of.size()) return of.size() < other.of.size();
    return of < other.of;
  }
};

void count(Tallying& tallying, std::vector<Candidate>& candidates, std::size_t pixels) {
  std::vector<Steps> steps;
  for (const Candidate& candidate : candidates) steps.push_back(candidate.steps);
  const std::vector<Tally> tallies = tallying.over(steps, pixels);
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].tally = tallies[i];
}

void sort(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.before(b); });
}

/// What both change; nothing if both change one step, which is only either of them.
class Pairing {
public:
  explicit Pairing(const std::vector<Hypothesis>& all) : all_(all) {}

  std::optional<Candidate> of(std::size_t a, std::size_t b) const {
    const std::optional<Steps> both = combined(all_[a].steps, all_[b].steps);
    if (!both) return std::nullopt;
    return Candidate{{std::min(a, b), std::max(a, b)}, *both, {}};
  }

private:
  static std::optional<Steps> combined(const Steps& a, Steps b) {
    const Steps right;
    // Two may be missing.
    if (a.missing_object != right.missing_object) std::swap(b.missing_object, b.other_missing_object);
    if (a.missing_light != right.missing_light) std::swap(b.missing_light, b.other_missing_light);
    Steps both = a;
    bool disjoint = true;
    const auto join = [&](auto Steps::*member) {
      if (b.*member == right.*member) return;
      disjoint &= a.*member == right.*member;
      both.*member = b.*member;
    };
    for_each_step(join);
    if (!disjoint) return std::nullopt;
    return both;
  }

  const std::vector<Hypothesis>& all_;
};

/// What may be half of the truth: what scores well, or brings values nearer.
double promise(const Candidate& candidate) {
  return std::max(candidate.tally.score(), candidate.tally.nearness());
}
void sort_by_promise(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return promise(a) > promise(b); });
}

/// Pairs of ten singles: of those that promise most, and of those that promise most beside the first of them, since of
/// two faults the greater may hide what the other does.
class PairSearch {
public:
  PairSearch(const std::vector<Hypothesis>& all, Tallying& tallying, Ranking& ranking)
      : all_(all), pairing_(all), tallying_(tallying), ranking_(ranking) {}

  std::vector<Candidate> best(std::vector<Candidate> singles) {
    sort_by_promise(singles);
    const std::size_t first = singles.front().of[0];
    std::vector<std::size_t> tried;
    for (std::size_t i = 0; i < std::min(best_singles / 2, singles.size()); ++i) tried.push_back(singles[i].of[0]);
    std::vector<Candidate> beside;
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (auto pair = pairing_.of(first, i)) beside.push_back(std::move(*pair));
    tally(beside, few_pixels);
    sort_by_promise(beside);
    for (const Candidate& pair : beside) {
      const std::size_t other = pair.of[0] == first ? pair.of[1] : pair.of[0];
      if (tried.size() == best_singles) break;
      if (std::find(tried.begin(), tried.end(), other) == tried.end()) tried.push_back(other);
    }
    std::vector<Candidate> pairs;
    for (std::size_t i = 0; i < tried.size(); ++i)
      for (std::size_t j = i + 1; j < tried.size(); ++j)
        if (auto pair = pairing_.of(tried[i], tried[j])) pairs.push_back(std::move(*pair));
    tally(pairs, first_pixels);
    sort(pairs);
    pairs.resize(std::min(pairs.size(), best_pairs));
    count(tallying_, pairs, max_judged_pixels);
    return pairs;
  }

private:
  void tally(std::vector<Candidate>& pairs, std::size_t pixels) {
    count(tallying_, pairs, pixels);
    ranking_.tried += pairs.size();
  }

  const std::vector<Hypothesis>& all_;
  const Pairing pairing_;
  Tallying& tallying_;
  Ranking& ranking_;
};

Cause cause_of(const Candidate& candidate, const std::vector<Hypothesis>& all) {
  Cause cause;
  for (const std::size_t i : candidate.of) {
    cause.keys.push_back(all[i].key);
    cause.text += (cause.text.empty() ? "" : ", and ") + all[i].text;
  }
  cause.explained = candidate.tally.explained_share();
  cause.kept = candidate.tally.kept_share();
  return cause;
}

std::string with_commas(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

} // namespace

const Cause* Ranking::named() const {
  if (causes.empty()) return nullptr;
  const Cause& best = causes.front();
  return best.explained > 0.5 && best.score() > 0 ? &best : nullptr;
}

Ranking rank_hypotheses(const RankRequest& request) {
  Ranking ranking;
  ranking.unexplained_in_image = std::max<std::uint64_t>(request.unexplained_in_image, request.unexplained.size());
  if (request.unexplained.empty()) return ranking;
  assert(request.unexplained.size() <= max_judged_pixels && request.explained.size() <= max_judged_pixels);
  Tallying tallying(request);
  ranking.background = tallying.background_suspect();
  for (std::size_t i = 0; i < tallying.suspects().size(); ++i)
    if (tallying.suspects()[i]) ranking.objects.push_back(static_cast<std::uint32_t>(i));

  const std::vector<Hypothesis> all = hypotheses_for(request.scene);
  std::vector<Candidate> singles;
  for (std::size_t i = 0; i < all.size(); ++i) singles.push_back({{i}, all[i].steps, {}});
  count(tallying, singles, first_pixels);
  ranking.tried = singles.size();
  sort(singles);
  std::vector<Candidate> best(singles.begin(),
                              singles.begin() + static_cast<std::ptrdiff_t>(std::min(singles.size(), shown_singles)));
  count(tallying, best, max_judged_pixels);
  sort(best);

  if (best.front().tally.score() < enough) {
    std::vector<Candidate> pairs = PairSearch(all, tallying, ranking).best(singles);
    const double single_score = best.front().tally.score();
    for (Candidate& pair : pairs)
      if (pair.tally.score() > single_score + pair_margin) best.push_back(std::move(pair));
    sort(best);
  }
  for (const Candidate& candidate : best)
    if (candidate.tally.score() > 0 && candidate.tally.fits > 0) ranking.causes.push_back(cause_of(candidate, all));
  return ranking;
}

std::string sentence(const Cause& cause, const Ranking& ranking, const Scene& scene) {
  std::string text = cause.text + ": explains " + percent(cause.explained) + " of " +
                     with_commas(ranking.unexplained_in_image) + " unexplained pixel" +
                     (ranking.unexplained_in_image == 1 ? "" : "s");
  std::vector<std::string> owners;
  for (const std::uint32_t object : ranking.objects) owners.push_back("`" + scene.objects[object].name + "`");
  if (ranking.background) owners.push_back("the background");
  for (std::size_t i = 0; i < owners.size(); ++i)
    text += (i == 0 ? " of " : i + 1 == owners.size() ? " and " : ", ") + owners[i];
  return text;
}

} // namespace refraster::hypotheses
