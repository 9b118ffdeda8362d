#pragma once

#include <cstddef>
#include <cstdint>

#include "signals/structs.hpp"

namespace farrier::signals {

/// The part of a topic's registration that its file in idl/ states.
struct TopicText {
  const char* name;         ///< DDS topic name
  const char* type_name;    ///< DDS type name, "wire::X"
  const char* idl;          ///< its file in idl/
  const char* readers;      ///< processes that it is meant for, for people: everybody may read
  const char* key;          ///< names of the key fields, for people
  std::uint32_t version;    ///< raised with every change of the fields or of their meaning
  std::size_t key_fields;   ///< the first fields are the key
  const char* declaration;  ///< struct name and fields as IDL has them, for the contract's hash
};

/// Specialised for every signal in signals/field_lists.hpp.
template <class Signal>
inline constexpr TopicText kTopicText{};

}  // namespace farrier::signals
