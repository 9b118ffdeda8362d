#include "thesis/report/study_pictures.hpp"

#include "report/page/draw_pictures.hpp"

namespace farrier::thesis {
namespace {

std::string picture_name(const Study& study, std::size_t index) {
  return std::string(study.number) + "_" + std::to_string(index + 1);
}

}  // namespace

std::string picture_path(const Study& study, std::size_t index) {
  return "pictures/" + picture_name(study, index) + ".svg";
}

Result<Done> draw_studies(const std::string& out_dir, std::span<const StudyRun> runs) {
  report::Drawing drawing(out_dir);
  for (const StudyRun& run : runs) {
    const StudyResult* result = shown(run);
    for (std::size_t i = 0; result != nullptr && i < result->pictures.size(); ++i) {
      Picture picture = result->pictures[i];
      picture.key = report::Key::kBelow;  // a key inside covers data
      drawing.add(picture_name(run.study, i), picture);
    }
  }
  return drawing.draw();
}

}  // namespace farrier::thesis
