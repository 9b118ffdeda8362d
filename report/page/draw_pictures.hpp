#pragma once

#include <string>

#include "core/result.hpp"
#include "report/page/picture.hpp"

namespace farrier::report {

/// Draws the pictures of one report with one gnuplot process, into out_dir/pictures. Data and script stay in
/// out_dir/data.
class Drawing {
 public:
  /// Makes the folders.
  explicit Drawing(std::string out_dir);

  /// Writes the data of a picture. Returns the path that its SVG will have from out_dir: "pictures/<name>.svg".
  std::string add(const std::string& name, const Picture& picture);

  /// Draws all that was added. Refuses if the disk did not take a file, or if gnuplot is not installed or rejects the
  /// script, in gnuplot's own words.
  Result<Done> draw() const;

 private:
  void keep(const std::string& path, const std::string& text);

  std::string out_dir_;
  std::string script_;
  Result<Done> kept_ = Done{};  ///< the first refusal
};

}  // namespace farrier::report
