#include "diagnosis/data/csv_columns.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include "core/text.hpp"
#include "diagnosis/data/csv_faults.hpp"
#include "diagnosis/data/csv_header.hpp"
#include "diagnosis/data/csv_text.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kMostOthers = 64;

/// Why a file cannot be read at all; empty when it can.
std::vector<Finding> refusal(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    return {{"directory", 0, "cannot read the file " + path + ": it is a directory; name a CSV file"}};
  }
  errno = 0;
  std::ifstream file(path);
  if (!file) {
    return {{"unreadable", 0, "cannot read the file " + path + ": " + std::strerror(errno == 0 ? EIO : errno)}};
  }
  if (file.peek() == std::ifstream::traits_type::eof()) {
    return {{"empty", 0, "the file " + path + " is empty; record at least " + rounded(kShortestDuration_s) + " s"}};
  }
  return {};
}

/// Reads one file.
class ColumnReader {
 public:
  ColumnReader(const std::string& path, const std::vector<std::string>& names, const std::optional<CsvFilter>& filter,
               const CsvNaming& naming)
      : names_(names), filter_(filter), naming_(naming), lines_(path), faults_(names.size()) {
    table_.present.resize(names.size());
    table_.columns.resize(names.size());
    header_ = read_csv_header(path, names, naming);
  }

  CsvColumns read() && {
    table_.findings = header_.findings;
    table_.header_line = header_.line;
    while (lines_.next() && lines_.number() < header_.line) {
    }
    if (table_.findings.empty()) {
      table_.remarks = header_.remarks;
      choose_places();
      read_rows();
    }
    return std::move(table_);
  }

 private:
  void choose_places() {
    table_.header = header_.cells;
    table_.read.assign(header_.cells.size(), false);
    place_.clear();
    factor_.clear();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      place_.push_back(header_.place_of(names_[i]));
      table_.present[i] = place_[i] < header_.cells.size();
      factor_.push_back(table_.present[i] ? header_.meaning.columns[place_[i]]->factor : 1.0);
      if (table_.present[i]) {
        table_.read[place_[i]] = true;
      }
    }
    joint_column_ = naming_.joint.empty() ? header_.cells.size() : header_place_of("joint");
  }

  /// Rows and header may end with a separator, which makes an empty cell.
  bool fits_header() {
    const std::size_t columns = table_.header.size();
    if (cells_.size() == columns + 1 && cells_.back().empty()) {
      cells_.pop_back();
      ends_with_separator_ = true;
    } else if (cells_.size() + 1 == columns && table_.header.back().empty()) {
      cells_.emplace_back();
    }
    return cells_.size() == columns;
  }

  void read_rows() {
    bool first = true;
    while (lines_.next()) {
      split(lines_.text(), header_.separator, cells_);
      if (std::exchange(first, false) && naming_.meanings && take_units(header_, cells_, names_, naming_)) {
        if (!header_.findings.empty()) {
          table_.findings = header_.findings;
          return;
        }
        choose_places();
        continue;
      }
      const bool whole = fits_header();
      const std::size_t filter_place = filter_ ? header_place_of(filter_->column) : joint_column_;
      const std::string& filter_value = filter_ ? filter_->value : naming_.joint;
      if (whole && filter_place < cells_.size() && cells_[filter_place] != filter_value) {
        note_other(cells_[filter_place]);
        continue;
      }
      if (table_.line.size() == kMostSamples) {
        table_.findings.push_back({"too_long", lines_.number(),
                                   "line " + std::to_string(lines_.number()) + " is beyond " +
                                       counted(kMostSamples, "sample") + "; cut out the part to be diagnosed"});
        break;
      }
      if (!whole) {
        ragged_.add(cells_.size(), lines_);
      }
      table_.line.push_back(lines_.number());
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (table_.present[i]) {
          table_.columns[i].push_back(whole ? factor_[i] * faults_[i].read(cells_[place_[i]], lines_.number())
                                            : std::numeric_limits<double>::quiet_NaN());
        }
      }
    }
    report();
  }

  void report() {
    if (lines_.too_long()) {
      table_.findings.push_back(not_text(lines_.number() + 1));
    }
    ragged_.report(table_);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      faults_[i].report(names_[i], table_.findings);
    }
    table_.remarks.insert(table_.remarks.end(), header_.meaning.remarks.begin(), header_.meaning.remarks.end());
    if (ends_with_separator_) {
      table_.remarks.push_back("Rows end with a separator, which is no column.");
    }
    if (joint_column_ < table_.header.size() && !filter_) {
      report_joint();
    }
  }

  void report_joint() {
    if (table_.line.empty() && !table_.others.empty()) {
      table_.findings.push_back({"no_such_joint", 0,
                                 "the file has no rows of joint " + naming_.joint + "; it has " +
                                     join(table_.others, ", ") + ": give --joint one of them"});
    } else if (!table_.others.empty()) {
      table_.remarks.push_back("Rows of joint " + naming_.joint + " are read, not those of " +
                               join(table_.others, ", ") + ".");
    }
  }

  std::size_t header_place_of(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(table_.header, name) - table_.header.begin());
  }

  void note_other(const std::string& other) {
    auto& others = table_.others;
    if (others.size() < kMostOthers && std::find(others.begin(), others.end(), other) == others.end()) {
      others.push_back(other);
    }
  }

  const std::vector<std::string>& names_;
  const std::optional<CsvFilter>& filter_;
  const CsvNaming& naming_;
  CsvLines lines_;
  CsvHeader header_;
  std::size_t joint_column_ = 0;
  bool ends_with_separator_ = false;
  std::vector<double> factor_;
  CsvColumns table_{};
  std::vector<std::string> cells_;
  std::vector<std::size_t> place_;
  std::vector<CellFaults> faults_;
  RaggedRows ragged_;
};

}  // namespace

CsvColumns read_columns(const std::string& path, const std::vector<std::string>& names,
                        const std::optional<CsvFilter>& filter, const CsvNaming& naming) {
  CsvColumns refused;
  refused.findings = refusal(path);
  return refused.findings.empty() ? ColumnReader(path, names, filter, naming).read() : refused;
}

std::vector<std::string> read_header(const std::string& path) {
  std::vector<std::string> header;
  if (refusal(path).empty()) {
    CsvLines lines(path);
    if (lines.next()) {
      split(lines.text(), separator_of(lines.text()), header);
    }
  }
  return header;
}

}  // namespace farrier::diagnosis
