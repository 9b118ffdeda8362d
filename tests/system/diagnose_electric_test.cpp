// farrier diagnose of an electric joint, as a user runs it: on what the simulation records, and on what it must refuse.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "farrier_command.hpp"

namespace farrier::test {
namespace diagnose_electric_test {

namespace fs = std::filesystem;

const std::string kShipped = std::string(FARRIER_ROBOTS) + "/electric_leg.yaml";

/// The shipped leg with softer springs in its joints than its file says, and its trace.
class ElectricLegWithSofterSprings : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchDirectory>();
    std::string file = read_file(kShipped);
    const std::string stiffness = "spring_stiffness_Nm_rad: 1e4";
    ASSERT_NE(file.find(stiffness), std::string::npos);
    std::ofstream(machine()) << file.replace(file.find(stiffness), stiffness.size(), "spring_stiffness_Nm_rad: 6e3");
    std::string output;
    const int status = run_farrier({"trot", "--world", "bench", "--robot", machine(), "--dds", "inproc", "--design",
                                    "swing", "--duration", "6", "--out", scratch_->file("trot"), "--trace", trace()},
                                   &output);
    ASSERT_TRUE(status == 0 || status == 1) << output;
  }
  static void TearDownTestSuite() { scratch_.reset(); }

  static std::string machine() { return scratch_->file("machine.yaml"); }
  static std::string trace() { return scratch_->file("trace.csv"); }
  /// JSON of a diagnosis of the hip by a model.
  static nlohmann::json found_by(const std::string& model, std::string& output) {
    EXPECT_EQ(run_farrier({"diagnose", trace(), "--model", model, "--joint", "hfe", "--out", scratch_->file("out"),
                           "--json", scratch_->file("found.json")},
                          &output),
              0)
        << output;
    return read_json(scratch_->file("found.json"));
  }

  static inline std::unique_ptr<ScratchDirectory> scratch_;
};

TEST_F(ElectricLegWithSofterSprings, AreNamedWithTheirStiffness) {
  std::string output;
  const nlohmann::json json = found_by(kShipped, output);
  EXPECT_EQ(json["verdict"], "effects") << output;
  ASSERT_EQ(json["effects"].size(), 1u) << output;
  EXPECT_EQ(json["effects"][0]["name"], "gear_stiffness");
  EXPECT_NEAR(json["effects"][0]["value"].get<double>(), 6e3, 200.0);
  EXPECT_EQ(json["channels"][0]["name"], "drive");
  EXPECT_TRUE(fs::exists(scratch_->file("out/index.html")));
  EXPECT_EQ(json["extended_model"], scratch_->file("out/electric_leg_hfe_extended.yaml"));
  EXPECT_LT(json["extended_model_held_out"]["nrmse_after"].get<double>(),
            0.2 * json["extended_model_held_out"]["nrmse_before"].get<double>());

  fs::rename(scratch_->file("out/electric_leg_hfe_extended.yaml"), scratch_->file("extended.yaml"));
  EXPECT_EQ(found_by(scratch_->file("extended.yaml"), output)["verdict"], "none") << output;
}

TEST_F(ElectricLegWithSofterSprings, AreExplainedByTheirOwnFile) {
  std::string output;
  const nlohmann::json json = found_by(machine(), output);
  EXPECT_EQ(json["verdict"], "none") << output;
  EXPECT_NE(output.find("the model explains this recording"), std::string::npos) << output;
}

TEST(DiagnoseOfAnElectricJoint, RefusesPositionsAndForcesOfACylinder) {
  const ScratchDirectory scratch;
  std::ofstream file(scratch.file("run.csv"));
  file << "time_s,position_m,force_N\n";
  for (int i = 0; i < 2000; ++i) {
    file << 1e-3 * i << "," << 1.3 + 0.1 * std::sin(0.01 * i) << "," << 20.0 * std::cos(0.01 * i) << "\n";
  }
  file.close();
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("run.csv"), "--model", kShipped, "--joint", "hfe"}, &output), 2);
  EXPECT_NE(output.find("joint hfe is electric; record angle_rad, velocity_rad_s and torque_Nm"), std::string::npos)
      << output;
}

}  // namespace diagnose_electric_test
}  // namespace farrier::test
