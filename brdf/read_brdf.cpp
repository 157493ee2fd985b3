#include "brdf/read_brdf.h"

#include <refraster/files.h>

#include "io/file/nearest.h"

#include <filesystem>
#include <system_error>

namespace refraster {

Brdf read_brdf(const std::string& word, MerlLookup lookup) {
  if (means_model(word)) return {word, read_models(word).lobes};
  std::error_code ignored;
  if (word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, ignored))
    throw InputError(InputFault{word, 0, 0, "", "no such file", "a MERL table, or " + one_of(model_names(), word)});
  Merl table;
  table.table = read_merl(word);
  table.lookup = lookup;
  return {word, table};
}

} // namespace refraster
