#pragma once

#include <string>

#include "core/result.hpp"

namespace farrier::report {

// Beginning of every picture. Colours of Okabe and Ito (2008), which most colour-blind people can tell apart.
inline constexpr const char* kPictureStart = R"(reset
set encoding utf8
set style line 1 lc rgb "#000000" lw 1.2
set style line 2 lc rgb "#0072b2" lw 1.2
set style line 3 lc rgb "#d55e00" lw 1
set style line 9 lc rgb "#d8dde1" lw 0.5
set border 3 lc rgb "#667078"
set tics nomirror out scale 0.5 textcolor rgb "#333333"
set grid xtics ytics ls 9
)";

/// Makes out_dir/data and out_dir/pictures; refuses what the disk does not allow.
Result<Done> make_picture_folders(const std::string& out_dir);

/// Writes the data of a picture to `path`. Refuses if the disk does not take all of it.
Result<Done> write_plot_data(const std::string& path, const std::string& lines);

/// Keeps `script` as out_dir/data/pictures.gp and runs it from out_dir. Refuses as run_gnuplot does.
Result<Done> draw(const std::string& out_dir, const std::string& script);

/// Runs gnuplot on a script, with `directory` as its working directory; `script` is a path from there. Refuses if
/// gnuplot is not installed or rejects the script, in gnuplot's own words.
Result<Done> run_gnuplot(const std::string& directory, const std::string& script);

}  // namespace farrier::report
