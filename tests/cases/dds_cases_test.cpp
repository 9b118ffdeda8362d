// A user's own DDS settings, made for other programs: they are honoured, or named and set aside, and the robot starts.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "bus/settings/peer_address.hpp"
#include "bus/settings/user_settings.hpp"
#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace dds_cases {

using bus::SettingUse;
using Environment = std::vector<std::pair<std::string, std::string>>;

/// Output of a command in an environment, and its exit status.
std::string output_of(const std::vector<std::string>& arguments, const Environment& environment,
                      int* status = nullptr) {
  std::string output;
  const int ended = run_farrier(arguments, &output, {.prepare = [&environment] {
                                  for (const auto& [name, value] : environment) {
                                    ::setenv(name.c_str(), value.c_str(), 1);
                                  }
                                }});
  if (status != nullptr) {
    *status = ended;
  }
  return output;
}

/// Output of a short trot of one leg; it must have run to its end.
std::string trot_in(const Environment& environment, const char* vendor) {
  const ScratchDirectory scratch;
  const std::string output =
      output_of({"trot", "--robot", std::string(FARRIER_ROBOTS) + "/electric_leg.yaml", "--dds", vendor, "--duration",
                 "0.2", "--start-limit", "15", "--out", scratch.file("out")},
                environment);
  EXPECT_NE(output.find("too short to be judged"), std::string::npos) << "it does not start: " << output;
  return output;
}

/// Uses by name of the settings of a CYCLONEDDS_URI.
std::string uses_of(const std::string& uri, const bus::NetworkOptions& network = {}) {
  std::string text;
  for (const bus::UserSetting& setting : bus::cyclone_settings(uri, network).settings) {
    const char* const use = setting.use == SettingUse::kHonoured ? "honoured"
                            : setting.use == SettingUse::kFits   ? "fits"
                                                                 : "aside";
    text += (text.empty() ? "" : ", ") + (setting.name.empty() ? "all" : setting.name) + " " + use;
  }
  return text;
}

TEST(CycloneSettings, OfTheUsualLoopbackFileFitOrAreSetAsideWithTheirLines) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("lo.xml")) << "<?xml version=\"1.0\"?>\n<CycloneDDS xmlns=\"https://cdds.io/config\">\n"
                                           "<Domain id=\"any\">\n<General><Interfaces>\n"
                                           "<NetworkInterface name=\"lo\"/>\n</Interfaces></General>\n<Discovery>\n"
                                           "<MaxAutoParticipantIndex>1000</MaxAutoParticipantIndex>\n</Discovery>\n"
                                           "</Domain></CycloneDDS>\n";
  for (const std::string& uri : {"file://" + scratch.file("lo.xml"), scratch.file("lo.xml")}) {
    EXPECT_EQ(uses_of(uri), "General/Interfaces/NetworkInterface fits, Discovery/MaxAutoParticipantIndex aside");
    const auto read = bus::cyclone_settings(uri, {});
    EXPECT_EQ(read.config, "");
    EXPECT_EQ(read.settings[0].place, scratch.file("lo.xml") + ":5");
    EXPECT_EQ(read.settings[1].place, scratch.file("lo.xml") + ":8");
  }
}

TEST(CycloneSettings, OfSeveralInterfacesAllowTheOneOfTheAddress) {
  EXPECT_EQ(
      uses_of("<Domain><General><Interfaces><NetworkInterface address=\"10.99.0.7\"/><NetworkInterface name='lo'/>"
              "</Interfaces></General></Domain>"),
      "General/Interfaces/NetworkInterface aside, General/Interfaces/NetworkInterface fits");
  EXPECT_EQ(uses_of("<General><NetworkInterfaceAddress>lo</NetworkInterfaceAddress></General>"),
            "General/NetworkInterfaceAddress fits");
  EXPECT_EQ(
      uses_of("<General><Interfaces><NetworkInterface name='lo'/></Interfaces></General>", {.address = "10.0.0.5"}),
      "General/Interfaces/NetworkInterface aside");
}

TEST(CycloneSettings, AreHonouredWhereTheyConcernOneProcess) {
  const auto read = bus::cyclone_settings(
      "<CycloneDDS><Domain "
      "Id='any'><Tracing><Verbosity>config</Verbosity></Tracing><Internal><MonitorPort>-1</MonitorPort>"
      "<HeartbeatInterval>1 s</HeartbeatInterval></Internal><SharedMemory><Enable>true</Enable></SharedMemory></Domain>"
      "</CycloneDDS>",
      {});
  EXPECT_EQ(read.config,
            "<CycloneDDS><Domain Id=\"any\"><Tracing><Verbosity>config</Verbosity></Tracing><Internal><MonitorPort>-1"
            "</MonitorPort></Internal></Domain></CycloneDDS>");
}

TEST(CycloneSettings, OfAnotherDomainAreLeftOut) {
  const std::string uri = "<Domain Id='3'><Discovery><ParticipantIndex>none</ParticipantIndex></Discovery></Domain>";
  EXPECT_EQ(uses_of(uri), "");
  EXPECT_EQ(uses_of(uri, {.domain = 3}), "Discovery/ParticipantIndex aside");
}

TEST(CycloneSettings, OfAListAreReadInOrder) {
  EXPECT_EQ(uses_of(" <Tracing><Category>trace,discovery</Category></Tracing>, "
                    "<Discovery><ParticipantIndex>auto</ParticipantIndex></Discovery> ,/nowhere/none.xml"),
            "Tracing/Category honoured, Discovery/ParticipantIndex fits, all aside");
}

TEST(CycloneSettings, ThatAreBrokenAreSetAsideWithTheLine) {
  const auto read = bus::cyclone_settings("<CycloneDDS>\n<Domain>\n</CycloneDDS>", {});
  ASSERT_EQ(read.settings.size(), 1u);
  EXPECT_EQ(bus::to_string(read.settings[0]),
            "CYCLONEDDS_URI: set aside, it is not well formed XML (line 2: XML_ERROR_MISMATCHED_ELEMENT)");
  std::string deep;
  for (int i = 0; i < 1000; ++i) {
    deep = "<a>" + deep + "</a>";
  }
  const std::string zero("<a/>\0<c/>", 9);
  const std::string long_one = "<a>" + std::string(1 << 20, ' ') + "</a>";
  for (const std::string& broken :
       std::vector<std::string>{"<", "<a", "<a b>", "<a b=c/>", "<a><!--", "</a>", "<a/>text", "<a>", "<a b='c", "<>",
                                "<a/></b><c/>", zero, deep, long_one}) {
    EXPECT_EQ(uses_of(broken), "all aside") << broken.substr(0, 40);
  }
}

TEST(DdsCase, ARobotOverCycloneStartsWithWhatWouldBreakIt) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("user.xml"))
      << "<CycloneDDS><Domain id=\"any\">\n<General><Interfaces><NetworkInterface name=\"lo\"/></Interfaces>\n"
         "<AllowMulticast>true</AllowMulticast><MaxMessageSize>1400B</MaxMessageSize></General>\n"
         "<Discovery><ParticipantIndex>none</ParticipantIndex>\n<Peers><Peer "
         "address=\"10.99.0.7\"/></Peers></Discovery>\n"
         "</Domain></CycloneDDS>\n";
  const std::string output = trot_in({{"CYCLONEDDS_URI", "file://" + scratch.file("user.xml")}}, "cyclone");
  EXPECT_NE(output.find("trot: note: CYCLONEDDS_URI, " + scratch.file("user.xml") +
                        ":4, Discovery/ParticipantIndex none: set aside, each process has a port"),
            std::string::npos)
      << output;
}

TEST(DdsCase, ARobotOverCycloneStartsWithElementsThatCycloneRefuses) {
  const std::string output = trot_in({{"CYCLONEDDS_URI", "<Threads><NoSuchElement/></Threads>"}}, "cyclone");
  EXPECT_NE(output.find("CYCLONEDDS_URI: set aside, Cyclone refuses what it says"), std::string::npos) << output;
}

TEST(DdsCase, ARobotOverFastDdsStartsInARosShell) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("super_client.xml"))
      << "<?xml version=\"1.0\"?>\n<dds><profiles xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">\n"
         "<participant profile_name=\"super\" is_default_profile=\"true\"><rtps><builtin><discovery_config>"
         "<discoveryProtocol>SUPER_CLIENT</discoveryProtocol></discovery_config></builtin></rtps></participant>\n"
         "</profiles></dds>\n";
  const std::string output = trot_in({{"ROS_DISCOVERY_SERVER", "127.0.0.1:11811"},
                                      {"ROS_SUPER_CLIENT", "TRUE"},
                                      {"ROS_LOCALHOST_ONLY", "1"},
                                      {"FASTRTPS_DEFAULT_PROFILES_FILE", scratch.file("super_client.xml")}},
                                     "fast");
  EXPECT_NE(output.find("trot: note: ROS_DISCOVERY_SERVER=127.0.0.1:11811: set aside"), std::string::npos) << output;
  EXPECT_NE(output.find("super_client.xml:3, profiles/participant super: set aside"), std::string::npos) << output;
  EXPECT_EQ(output.find("ROS_LOCALHOST_ONLY"), std::string::npos) << "it fits: " << output;
}

TEST(DdsCase, AStartThatASettingPreventsNamesIt) {
  const ScratchDirectory scratch;
  int status = 0;
  const std::string output =
      output_of({"trot", "--robot", std::string(FARRIER_ROBOTS) + "/electric_leg.yaml", "--start-limit", "2", "--out",
                 scratch.file("out")},
                {{"CYCLONEDDS_URI", "<Internal><Test><XmitLossiness>1000</XmitLossiness></Test></Internal>"}}, &status);
  EXPECT_EQ(status, 1) << output;
  EXPECT_NE(output.find("the start is not complete after 2 s"), std::string::npos) << output;
  EXPECT_NE(output.find("DDS settings of the environment may be the cause; start the run without those that are "
                        "honoured:\n  CYCLONEDDS_URI, Internal/Test: honoured"),
            std::string::npos)
      << output;
}

TEST(DdsCase, TheDoctorNamesEachSetting) {
  const std::string output = output_of({"doctor", "--look", "0.2"}, {{"CYCLONEDDS_URI", "/nowhere/cyclonedds.xml"},
                                                                     {"ROS_DISCOVERY_SERVER", "10.0.0.1"},
                                                                     {"ROS_LOCALHOST_ONLY", "1"},
                                                                     {"ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"},
                                                                     {"ROS_STATIC_PEERS", "10.0.0.1;10.0.0.2"}});
  for (const char* line :
       {"CYCLONEDDS_URI, /nowhere/cyclonedds.xml: set aside, the file cannot be read or is empty",
        "ROS_DISCOVERY_SERVER=10.0.0.1: set aside", "ROS_LOCALHOST_ONLY=1: fits",
        "ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET: set aside, --address and --peers say where processes are searched",
        "ROS_STATIC_PEERS=10.0.0.1;10.0.0.2: set aside, --peers names the computers"}) {
    EXPECT_NE(output.find(line), std::string::npos) << line << "\n" << output;
  }
}

TEST(DdsCase, PeersAndAddressesThatCannotBeAreRefused) {
  struct Wrong {
    const char* option;
    const char* value;
    const char* answer;
  };
  for (const Wrong& wrong :
       {Wrong{"--peers", "no-such-host.invalid", "'no-such-host.invalid' does not resolve"},
        Wrong{"--peers", "127.0.0.1,::1", "'::1' is an IPv6 address, and DDS uses IPv4 here: give an IPv4 address"},
        Wrong{"--peers", "fe80::1%lo", "'fe80::1%lo' is an IPv6 address"},
        Wrong{"--address", "::1", "'::1' is an IPv6 address"}, Wrong{"--address", "lo", "'lo' is no IPv4 address"}}) {
    for (const char* verb : {"doctor", "echo", "topics"}) {
      int status = 0;
      std::vector<std::string> arguments{verb, wrong.option, wrong.value};
      if (std::string(verb) == "echo") {
        arguments.emplace_back("clock/tick");
      }
      const std::string output = output_of(arguments, {}, &status);
      EXPECT_EQ(status, 2) << output;
      EXPECT_NE(output.find(wrong.answer), std::string::npos) << output;
    }
  }
  EXPECT_EQ(bus::resolve_peer("localhost").value(), "127.0.0.1");
}

}  // namespace dds_cases
}  // namespace farrier::test
