#pragma once

// Access of readers. A page on this computer needs only the right name of the host; from elsewhere it needs a token.

#include <string>
#include <string_view>

namespace farrier::web {

/// 32 random letters, too many to guess. No system this runs on refuses them.
std::string random_token();

/// Takes as long whatever the letters are.
bool equal(std::string_view one, std::string_view other) noexcept;

/// True if a browser that sends this Host means this server. A foreign name that was made to resolve to this computer
/// is refused: numbers and localhost cannot be made to. The port may be a tunnel's and is ignored. `loopback`: only
/// this computer's own names are right.
bool host_is_ours(std::string_view host, bool loopback, std::string_view own_name);

/// Value of a cookie in a Cookie header; empty for none.
std::string_view cookie(std::string_view header, std::string_view name);

/// True if an address is of this computer alone.
bool is_loopback(std::string_view ip);

}  // namespace farrier::web
