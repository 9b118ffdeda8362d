// idl/ read as text: it says what signals/fields.hpp says.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "bus/key.hpp"
#include "bus/topics.hpp"
#include "signals/idl_text.hpp"

namespace farrier::contract {
namespace contract_text_test {

constexpr std::size_t kMaxKeySize = 16;  // a longer key travels as a hash, which Cyclone cannot turn back

struct Field {
  bool key = false;
  std::string text;  ///< "double a[9]"

  std::string name() const { return text.substr(text.rfind(' ') + 1); }  ///< of a key, which is no array
  friend bool operator==(const Field&, const Field&) = default;
};

void PrintTo(const Field& field, std::ostream* out) { *out << (field.key ? "@key " : "") << field.text; }

struct IdlFile {
  std::string text;
  std::string structure;  ///< its name
  std::vector<Field> fields;
};

std::string path_of(const std::string& name) { return std::string(FARRIER_IDL_DIR) + '/' + name; }

IdlFile read_idl(const std::string& name) {
  IdlFile file;
  std::ifstream in(path_of(name));
  std::stringstream text;
  text << in.rdbuf();
  file.text = text.str();
  const std::string code = std::regex_replace(file.text, std::regex("//[^\n]*"), "");
  std::smatch match;
  if (std::regex_search(code, match, std::regex(R"(struct\s+(\w+))"))) {
    file.structure = match[1];
  }
  const std::regex field(
      R"((@key\s+)?((?:unsigned )?(?:long long|long|short)|octet|char|double|sequence<.*>)\s+(\w+)(?:\[(\d+)\])?;)");
  for (std::sregex_iterator i(code.begin(), code.end(), field), end; i != end; ++i) {
    const std::smatch& found = *i;
    file.fields.push_back({found[1].matched, found[2].str() + ' ' + found[3].str() +
                                                 (found[4].matched ? '[' + found[4].str() + ']' : std::string())});
  }
  return file;
}

template <class Signal>
std::vector<Field> fields_of() {
  std::vector<Field> fields;
  signals::visit_fields(Signal{}, [&](const char* name, const auto& field) {
    fields.push_back({fields.size() < bus::kKeyFields<Signal>, signals::idl_text(name, field)});
  });
  return fields;
}

template <class Signal>
std::size_t key_size() {
  std::size_t size = 0;
  std::size_t index = 0;
  signals::visit_fields(Signal{}, [&](const char*, const auto& field) {
    size += index++ < bus::kKeyFields<Signal> ? sizeof(field) : 0;
  });
  return size;
}

std::string comma_separated_keys(const std::vector<Field>& fields) {
  std::string keys;
  for (const Field& field : fields) {
    keys += field.key ? (keys.empty() ? "" : ", ") + field.name() : "";
  }
  return keys;
}

TEST(Contract, IdlDeclaresTheFieldsTypesOrderAndKeysOfEverySignal) {
#define FARRIER_COMPARE(Signal, file)                                  \
  {                                                                    \
    SCOPED_TRACE(#file ".idl");                                        \
    const IdlFile idl = read_idl(#file ".idl");                        \
    EXPECT_EQ(idl.structure, #Signal);                                 \
    EXPECT_EQ(idl.fields, fields_of<signals::Signal>());               \
  }
  FARRIER_SIGNALS(FARRIER_COMPARE)
#undef FARRIER_COMPARE
}

TEST(Contract, TextThatIsHashedHasTypesArraySizesAndKeys) {
  const std::string text = bus::contract_text();
  for (const char* part : {"joint/model_estimate wire::JointModelEstimate ", "\nJointModelEstimate: @key unsigned short joint;",
                           " double a[9];", "sequence<octet, 32000> bytes;"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
  }
}

TEST(Contract, EveryTopicHasItsFileAndEveryFileItsTopic) {
  std::set<std::string> declared;
  for (const bus::TopicSpec& topic : bus::topics()) {
    EXPECT_TRUE(declared.insert(topic.idl).second) << topic.idl << " serves two topics";
    const IdlFile idl = read_idl(topic.idl);
    EXPECT_EQ("wire::" + idl.structure, topic.type_name);
    EXPECT_EQ(comma_separated_keys(idl.fields), topic.key) << topic.name;
  }
  std::set<std::string> present;
  for (const auto& entry : std::filesystem::directory_iterator(FARRIER_IDL_DIR)) {
    if (entry.path().extension() == ".idl") {
      present.insert(entry.path().filename());
    }
  }
  EXPECT_EQ(present, declared);
}

TEST(Contract, EveryFileIsFinalAndInModuleWire) {
  for (const bus::TopicSpec& topic : bus::topics()) {
    const std::string text = read_idl(topic.idl).text;
    EXPECT_TRUE(std::regex_search(text, std::regex(R"(module wire \{\s*@final\s*struct )"))) << topic.idl;
    EXPECT_EQ(text.find("@appendable"), std::string::npos) << topic.idl;
    EXPECT_EQ(text.find("@mutable"), std::string::npos) << topic.idl;
  }
}

TEST(Contract, KeysFitWhereBothVendorsCarryThemInFull) {
#define FARRIER_KEY_SIZE(Signal, file) EXPECT_LE(key_size<signals::Signal>(), kMaxKeySize) << #Signal;
  FARRIER_SIGNALS(FARRIER_KEY_SIZE)
#undef FARRIER_KEY_SIZE
}

}  // namespace contract_text_test
}  // namespace farrier::contract
