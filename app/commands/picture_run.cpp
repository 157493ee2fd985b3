#include "app/commands/picture_run.h"

#include <refraster/notes.h>

#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/progress_line.h"
#include "io/file/limits.h"

namespace refraster {

std::vector<Option> scene_options(PictureRun& run) {
  return {scene_argument(run.scene), outside_option(run.reading.outside), exposure_option(run.reading.exposure_stops),
          shadow_option(run.reading), cache_option(run.reading.mesh_cache)};
}

std::vector<Option> shading_options(PictureRun& run) {
  return {choice_option("--precision", run.precision, precision_names(),
                        "number type of shading; `refraster list precisions`"),
          samples_option(run.asked, "samples a pixel, at the standard positions; shaded once a triangle"),
          srgb_option(run.asked, "apply the sRGB curve (not to floats)"), linear_option(run.asked)};
}

OptionGroup file_options(PictureRun& run) {
  return {"Files", {bits_option(run.files), quality_option(run.files), transparent_option(run.files)}};
}

Option threads_option(PictureRun& run) {
  return number_option("--threads", run.threads, Range{0, double(limit::threads.value)},
                       "threads; 0: as many as this machine has");
}

std::vector<Option> diagnostic_options(PictureRun& run) {
  return {strict_option(run.diagnostics), quiet_option(run.diagnostics)};
}

void set_limits(PictureRun& run) {
  run.reading.memory = set_memory_limit(run.max_memory, run.threads);
  run.reading.threads = run.threads;
}

SceneSource read_source(PictureRun& run, PictureFile file, std::vector<std::string>* said) {
  NoteList notes;
  auto line = progress_line(run.diagnostics, "reading " + run.scene);
  SceneOptions reading = run.reading;
  reading.notes = &notes;
  SceneSource source = read_scene_source(run.scene, reading, run.changes.edits());
  line.reset(); // before anything is printed
  print_file_notes(notes, run.diagnostics);
  if (said)
    for (const Note& note : notes.notes()) said->push_back(note.text());
  const Picture picture = run.asked.over(source.view.picture);
  run.size = {picture.width, picture.height}, run.samples = picture.samples;
  const bool floats = file == PictureFile::image && writes_radiance(run.files, run.output);
  run.transfer = floats ? Transfer::linear : picture.transfer;
  return source;
}

RenderOptions render_options(const PictureRun& run, PictureFile file) {
  RenderOptions options;
  options.width = run.size.width;
  options.height = run.size.height;
  options.precision = value_named<Precision>(run.precision).value();
  options.samples = run.samples;
  options.threads = run.threads;
  options.transfer = run.transfer;
  if (file == PictureFile::image) ask_for_output(run.files, run.output, options);
  options.cancel = &interrupted();
  options.memory = run.reading.memory;
  return options;
}

} // namespace refraster
