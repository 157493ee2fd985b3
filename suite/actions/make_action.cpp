// An image, made by us or by OpenGL, of which nothing is asked.

#include "suite/actions/made_image.h"
#include "suite/actions/thumbnail.h"

namespace refraster::suite {

void make_image(Task& task) {
  const MadeImage made = make_image_of(task, Floats::unwanted);
  task.result.thumbnail = thumbnail_of(made.rgb8);
  write_made(task, made);
  task.result.state = State::done;
  task.result.message = "made";
}

} // namespace refraster::suite
