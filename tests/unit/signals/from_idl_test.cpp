// Files of idl/ that from_idl reads, and files that it refuses.

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "signals/from_idl/idl_file.hpp"

namespace farrier::from_idl {
namespace from_idl_test {

constexpr const char* kHead =
    "// Topic 3: joint/measurement, version 2.\n"
    "// joint_node -> estimator_service: the measurement.\n"
    "module wire {\n\n@final\nstruct JointMeasurement {\n";

class FromIdl : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) const {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "from_idl_test.idl";
    std::ofstream(path) << text;
    return path;
  }
  /// Error of a struct with these fields; empty if it is read.
  std::string error(const std::string& fields) const {
    try {
      read(file(kHead + fields + "};\n\n};\n"));
    } catch (const std::runtime_error& refusal) {
      return refusal.what();
    }
    return {};
  }
};

TEST_F(FromIdl, ReadsTopicKeyFieldsAndComments) {
  const IdlFile idl = read(file(std::string(kHead) + "  @key unsigned short joint;\n"
                                                     "  // A comment of\n  // two lines.\n"
                                                     "  double force_N[3];  // load cell\n"
                                                     "};\n\n};\n"));
  EXPECT_EQ(idl.number, 3);
  EXPECT_EQ(idl.topic, "joint/measurement");
  EXPECT_EQ(idl.version, "2");
  EXPECT_EQ(idl.readers, "estimator_service");
  EXPECT_EQ(idl.structure, "JointMeasurement");
  EXPECT_EQ(idl.key(), "joint");
  ASSERT_EQ(idl.fields.size(), 2u);
  EXPECT_EQ(idl.fields[1].declaration(), "double force_N[3];");
  EXPECT_EQ(idl.fields[1].comment, "A comment of two lines. load cell");
}

TEST_F(FromIdl, RefusesWithFileAndLine) {
  EXPECT_NE(error("  @key unsigned short joint;\n  float force_N;\n").find("from_idl_test.idl:8: '  float force_N;'"),
            std::string::npos);
  EXPECT_NE(
      error("  @key unsigned short joint;\n  octet state;\n  @key octet phase;\n").find(":9: key fields come first"),
      std::string::npos);
  EXPECT_NE(error("  octet state;\n").find("first field is its @key"), std::string::npos);
  EXPECT_EQ(error("  @key unsigned short joint;\n  octet state;\n"), "");
}

TEST_F(FromIdl, RefusesFileWithoutTopic) { EXPECT_THROW(read(file("module wire {\n};\n")), std::runtime_error); }

}  // namespace from_idl_test
}  // namespace farrier::from_idl
