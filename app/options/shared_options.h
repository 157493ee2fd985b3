#pragma once
// Options that several commands have, each declared once.

#include <refraster/files.h>

#include "app/diagnostics.h"
#include "app/options/option.h"
#include "io/parts/shard.h"
#include "verify/images/image_pair.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace refraster {

/// The argument SCENE.
Option scene_argument(std::string& path);

/// --allow-outside, for the commands that read scenes.
Option outside_option(Outside& outside);

/// --exposure EV, for the commands that make or judge a picture of a scene.
Option exposure_option(double& stops);

/// --shadow: what lights with a shadow have instead of theirs.
Option shadow_option(SceneOptions& reading);

/// --cache, for the commands that read scenes: a folder of large meshes that were read before. check_cache_folder.
Option cache_option(std::string& folder);

/// Whether an alpha channel may be compared as a fourth one.
enum class ComparedAlpha { offered, refused };

/// --alpha: what is done with an alpha that is not 1 everywhere.
Option alpha_option(AlphaUse& use, std::array<double, 3>& background, ComparedAlpha compared);

/// --premultiplied: whether colours are stored multiplied by alpha.
Option premultiplied_option(AlphaEncoding& encoding);

/// --max-memory SIZE; 0 if it is not given.
Option memory_option(std::uint64_t& bytes);

/// --shard I/N. `shard`: a Shard, or one that need not be there.
template <class ShardToSet>
Option shard_option(ShardToSet& shard, std::string meaning) {
  return parsed_option("--shard", "I/N", shard, shard_from, "I/N, a part from 1 to N", std::move(meaning));
}

/// --strict, for commands that read scenes, meshes or textures.
Option strict_option(Diagnostics& diagnostics);

/// -q, --quiet: neither progress nor notes; nor, where the command has one, its report.
Option quiet_option(Diagnostics& diagnostics,
                    const std::string& meaning = "print errors only: no progress, notes or warnings");

} // namespace refraster
