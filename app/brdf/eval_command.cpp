// refraster brdf eval BRDF

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/usage_error.h"
#include "brdf/evaluation.h"
#include "brdf/points.h"
#include "io/file/limits.h"

#include <iostream>
#include <iterator>
#include <memory>
#include <vector>

namespace refraster {
namespace {

struct EvalArguments {
  std::string word, points, output, json;
  std::vector<DirectionPair> pairs;
  MerlLookup lookup = MerlLookup::trilinear;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

/// An option that may be given several times, once for each pair of directions.
Option pair_option(const std::string& name, std::string form, std::vector<DirectionPair>& pairs,
                   std::optional<DirectionPair> (*parse)(std::string_view), std::string expected, std::string meaning) {
  const auto read = [&pairs, parse, expected](const std::string& text) -> std::optional<ValueFault> {
    const std::optional<DirectionPair> pair = parse(text);
    if (!pair) return ValueFault{expected};
    pairs.push_back(*pair);
    return std::nullopt;
  };
  Option option = value_option(name, std::move(form), std::move(meaning), read);
  option.occurs = Occurs::repeatedly;
  return option;
}

/// Standard input, as far as a file may be long.
NumberTable table_of_standard_input() {
  std::string text;
  std::vector<char> part(std::size_t{1} << 16);
  while (std::cin.read(part.data(), static_cast<std::streamsize>(part.size())) || std::cin.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
    if (text.size() > limit::csv_bytes.value)
      throw InputError(
          InputFault{"standard input", 0, 0, "", found_of(limit::csv_bytes, text.size()), at_most(limit::csv_bytes)});
  }
  return number_table("standard input", text);
}

std::vector<DirectionPair> all_pairs(const EvalArguments& arguments) {
  std::vector<DirectionPair> pairs = arguments.pairs;
  if (arguments.points.empty()) return pairs;
  const NumberTable table =
      arguments.points == standard_output ? table_of_standard_input() : read_number_table(arguments.points);
  const std::vector<DirectionPair> read = pairs_of(table);
  pairs.insert(pairs.end(), read.begin(), read.end());
  return pairs;
}

ExitCode run(const EvalArguments& arguments) {
  set_memory_limit(arguments.max_memory, 1);
  // One of the two may have standard output: the values as CSV, unless they are asked for otherwise.
  const std::string output =
      arguments.output.empty() && arguments.json != standard_output ? standard_output : arguments.output;
  check_different({output, arguments.json}, {arguments.word, arguments.points});
  for (const std::string& path : {output, arguments.json})
    if (!path.empty()) check_writable(path);
  const std::vector<DirectionPair> pairs = all_pairs(arguments);
  const Brdf brdf = read_brdf(arguments.word, arguments.lookup, arguments.diagnostics);
  if (!arguments.json.empty()) write_text(arguments.json, evaluation_json(brdf, pairs));
  if (!output.empty()) write_text(output, evaluation_csv(brdf, pairs));
  return ExitCode::ok;
}

} // namespace

Command brdf_eval_command() {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  return {
      .name = "eval",
      .meaning = "Values at pairs of directions",
      .groups =
          {{"Reflectance", {brdf_argument("BRDF", a.word, "what to evaluate"), lookup_option(a.lookup)}},
           {"Directions",
            {pair_option("--angles", "THETA_IN,THETA_OUT,DPHI", a.pairs, in_out_from,
                         "three angles in degrees, the first two from 0 to 90",
                         "angles of light and eye from the normal, and the azimuth between them, 180 in a mirror"),
             pair_option("--half", "THETA_H,THETA_D,PHI_D", a.pairs, half_difference_from,
                         "three angles in degrees, the first two from 0 to 90",
                         "Rusinkiewicz's half and difference angles, those of a MERL table"),
             pair_option("--directions", "X,Y,Z,X,Y,Z", a.pairs, directions_from,
                         "six numbers, two vectors that are not 0",
                         "to the light and to the eye, over a surface with normal 0,0,1"),
             file_option("--points", "FILE", a.points,
                         "CSV file with a pair in each row, whose first line names the columns theta_in,theta_out,dphi "
                         "or theta_h,theta_d,phi_d or in_x,in_y,in_z,out_x,out_y,out_z; - is standard input")}},
           {"Report",
            {file_option("-o,--output", "FILE", a.output, "CSV file to write; - and the default are standard output"),
             file_option("--json", "FILE", a.json, "write the values as JSON; - is standard output, without CSV there"),
             memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
      .notes = model_notes(),
      .finish = [arguments]() -> Action {
        check_brdf_word("BRDF", arguments->word);
        if (arguments->pairs.empty() && arguments->points.empty())
          throw UsageError("brdf eval", "nothing", "one of --angles, --half, --directions, --points");
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
