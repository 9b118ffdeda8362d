#pragma once

// Types of messages as ROS 2 describes them: REP 2016.

#include <map>

#include "ros_messages/messages.hpp"

namespace farrier::ros_messages {

/// One field, with the numbers of type_description_interfaces/msg/FieldType.
struct FieldDescription {
  std::string name;
  int type_id = 0;
  std::size_t capacity = 0;         ///< of an array
  std::size_t string_capacity = 0;  ///< of a bounded string
  std::string nested;               ///< "std_msgs/msg/Header", or empty
};

/// A type and those that it needs, each with its fields.
struct TypeDescription {
  std::string name;
  std::map<std::string, std::vector<FieldDescription>> types;
};

template <Message M>
TypeDescription describe();

/// "RIHS01_" and the SHA-256 of the description in JSON, as rosidl_generator_type_description writes it.
std::string type_hash(const TypeDescription& description);

/// The definition in the form of ros2msg: fields of the type, then those of each other type behind a line of "=" and
/// "MSG: package/Type".
std::string message_text(const TypeDescription& description);

template <Message M>
std::string type_hash() {
  return type_hash(describe<M>());
}

namespace type_description_parts {

template <class T>
void describe_type(FieldDescription& field) {
  if constexpr (Message<T>) {
    field.type_id += 1;
    field.nested = T::kRosName;
  } else if constexpr (kIsString<T>) {
    field.type_id += kBound<T> == 0 ? 17 : 21;
    field.string_capacity = kBound<T>;
  } else {
    field.type_id += std::is_same_v<T, std::uint8_t>    ? 3
                     : std::is_same_v<T, std::int32_t>  ? 6
                     : std::is_same_v<T, std::uint32_t> ? 7
                     : std::is_same_v<T, double>        ? 11
                     : std::is_same_v<T, bool>          ? 15
                                                        : 16;  // std::byte
  }
}

template <Message M>
void add_type(TypeDescription& all);

template <class T>
void add_nested(TypeDescription& all) {
  if constexpr (Message<T>) {
    add_type<T>(all);
  }
}

/// Visitor that notes each field.
struct Describer {
  TypeDescription& all;
  std::vector<FieldDescription>& fields;

  template <class T>
  void operator()(const char* name, const T& /*field*/) const {
    FieldDescription field{.name = name, .nested = {}};
    if constexpr (kIsSequence<T>) {
      field.type_id = 144;
      describe_type<typename T::value_type>(field);
      add_nested<typename T::value_type>(all);
    } else if constexpr (kArraySize<T> != 0) {
      field.type_id = 48;
      field.capacity = kArraySize<T>;
      describe_type<typename T::value_type>(field);
      add_nested<typename T::value_type>(all);
    } else {
      describe_type<T>(field);
      add_nested<T>(all);
    }
    fields.push_back(std::move(field));
  }
};

template <Message M>
void add_type(TypeDescription& all) {
  if (all.types.contains(M::kRosName)) {
    return;
  }
  std::vector<FieldDescription> fields;
  const M none{};
  M::visit(none, Describer{all, fields});
  all.types.emplace(M::kRosName, std::move(fields));
}

}  // namespace type_description_parts

template <Message M>
TypeDescription describe() {
  TypeDescription all;
  all.name = M::kRosName;
  type_description_parts::add_type<M>(all);
  return all;
}

}  // namespace farrier::ros_messages
