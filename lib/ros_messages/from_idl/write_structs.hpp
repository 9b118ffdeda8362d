#pragma once

#include <ostream>
#include <string>

namespace farrier::ros_from_idl {

/// Writes the C++ structs of `idl`, the text of ros.idl: package::Type with the fields of package::msg::dds_::Type_, and a
/// function that visits them by name; at the end a list of all of them. It knows what that file uses of IDL: modules, structs, scoped names, strings,
/// sequences and arrays. Throws std::runtime_error for anything else.
void write_structs(const std::string& idl, std::ostream& out);

}  // namespace farrier::ros_from_idl
