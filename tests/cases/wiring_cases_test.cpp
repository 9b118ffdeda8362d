// Recordings as users have them whose cables or columns are wrong: the fault is named before any physical effect.

#include <algorithm>
#include <utility>

#include "diagnosis/wiring/wiring.hpp"
#include "tests/unit/diagnosis/recording.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::diagnosis {
namespace wiring_cases {

class WiringCase : public RecordingFile {
 protected:
  /// Returns the findings of a file of the rig with these columns.
  std::vector<Finding> said_of(const CsvFile& file) const {
    const auto recording = read(file);
    EXPECT_TRUE(recording.ok());
    return recording ? wiring_findings(find_wiring(recording.value(), joint()), recording.value(), joint())
                     : std::vector<Finding>{};
  }

  static const robot::Joint& joint() {
    static const robot::Robot robot = robot::load_shipped("fc1d");
    return robot.joints.front();
  }

  /// A second of the rig under force control, with its pressures.
  static CsvFile good() {
    static const auto trial = truth::generate(
        joint(), 1e-3, {.seed = 11, .excitation = truth::Excitation::kForceTracking, .hidden = {}, .duration_s = 1.1});
    const truth::Samples& s = trial.value().samples;
    CsvFile file{.names = {"time_s", "position_m", "force_N", "valve_current_A", "velocity_m_s", "pressure_a_Pa",
                           "pressure_b_Pa"},
                 .rows = {}};
    for (std::size_t i = 0; i < s.force.size(); ++i) {
      file.rows.push_back({CsvFile::number(1e-3 * static_cast<double>(i)), CsvFile::number(s.position[i]),
                           CsvFile::number(s.force[i]), CsvFile::number(s.valve_current_A[i]),
                           CsvFile::number(s.velocity[i]), CsvFile::number(s.pressure_a_Pa[i]),
                           CsvFile::number(s.pressure_b_Pa[i])});
    }
    return file;
  }
};

TEST_F(WiringCase, AGoodRecordingHasNoFault) { EXPECT_TRUE(said_of(good()).empty()); }

TEST_F(WiringCase, ExchangedPressuresAreNamed) {
  CsvFile file = good();
  std::swap(file.names[5], file.names[6]);
  const std::vector<Finding> said = said_of(file);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said.front().what, "exchanged");
  EXPECT_NE(said.front().text.find("pressure_a_Pa and pressure_b_Pa are exchanged"), std::string::npos)
      << said.front().text;
}

TEST_F(WiringCase, AReversedForceIsNamed) {
  CsvFile file = good();
  for (auto& row : file.rows) {
    row[2] = CsvFile::number(-std::stod(row[2]));
  }
  const std::vector<Finding> said = said_of(file);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said.front().what, "reversed");
  EXPECT_NE(said.front().text.find("force_N is reversed: the load cell's wires are exchanged"), std::string::npos)
      << said.front().text;
}

}  // namespace wiring_cases
}  // namespace farrier::diagnosis
