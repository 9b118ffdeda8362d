#include "ros_messages/type_description.hpp"

#include <openssl/sha.h>

#include <cstdio>

namespace farrier::ros_messages {
namespace {

constexpr int kArray = 48;
constexpr int kSequence = 144;

std::string fields_json(const std::string& type, const std::vector<FieldDescription>& fields) {
  std::string text = "{\"type_name\": \"" + type + "\", \"fields\": [";
  for (const FieldDescription& field : fields) {
    text += (text.back() == '[' ? "" : ", ");
    text += "{\"name\": \"" + field.name + "\", \"type\": {\"type_id\": " + std::to_string(field.type_id) +
            ", \"capacity\": " + std::to_string(field.capacity) +
            ", \"string_capacity\": " + std::to_string(field.string_capacity) + ", \"nested_type_name\": \"" +
            field.nested + "\"}}";
  }
  return text + "]}";
}

/// "geometry_msgs/Pose" of "geometry_msgs/msg/Pose".
std::string short_name(std::string name) {
  const std::string middle = "/msg/";
  const std::size_t at = name.find(middle);
  return at == std::string::npos ? name : name.replace(at, middle.size(), "/");
}

std::string field_type_text(const FieldDescription& field) {
  const int element = field.type_id % kArray;
  const std::string type = element == 1    ? short_name(field.nested)
                           : element == 3  ? "uint8"
                           : element == 6  ? "int32"
                           : element == 7  ? "uint32"
                           : element == 11 ? "float64"
                           : element == 15 ? "bool"
                           : element == 16 ? "byte"
                           : element == 17 ? "string"
                                           : "string<=" + std::to_string(field.string_capacity);
  return field.type_id > kSequence ? type + "[]"
         : field.type_id > kArray  ? type + "[" + std::to_string(field.capacity) + "]"
                                   : type;
}

std::string fields_text(const std::vector<FieldDescription>& fields) {
  std::string text;
  for (const FieldDescription& field : fields) {
    text += field_type_text(field) + " " + field.name + "\n";
  }
  return text;
}

}  // namespace

std::string type_hash(const TypeDescription& description) {
  std::string text = "{\"type_description\": " + fields_json(description.name, description.types.at(description.name)) +
                     ", \"referenced_type_descriptions\": [";
  for (const auto& [name, fields] : description.types) {
    if (name != description.name) {
      text += (text.back() == '[' ? "" : ", ") + fields_json(name, fields);
    }
  }
  text += "]}";
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  std::string hash = "RIHS01_";
  for (const unsigned char byte : digest) {
    char hex[3];
    std::snprintf(hex, sizeof hex, "%02x", byte);
    hash += hex;
  }
  return hash;
}

std::string message_text(const TypeDescription& description) {
  std::string text = fields_text(description.types.at(description.name));
  for (const auto& [name, fields] : description.types) {
    if (name != description.name) {
      text += std::string(80, '=') + "\nMSG: " + short_name(name) + "\n" + fields_text(fields);
    }
  }
  return text;
}

}  // namespace farrier::ros_messages
