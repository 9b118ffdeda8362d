#pragma once

// Who may read. A page on this computer needs nothing but the right name of the host; from elsewhere it needs a token.

#include <string>
#include <string_view>

namespace farrier::web {

/// 32 letters that nobody guesses. Refused by no system this runs on.
std::string random_token();

/// Takes as long whatever the letters are.
bool equal(std::string_view one, std::string_view other) noexcept;

/// Whether a browser that sends this Host means this server. Somebody else's name that has been made to resolve to this
/// computer is refused: numbers and localhost cannot be made to. The port may be a tunnel's and is not looked at.
/// `loopback`: only this computer's own names are right.
bool host_is_ours(std::string_view host, bool loopback, std::string_view own_name);

/// Value of a cookie in a Cookie header; empty for none.
std::string_view cookie(std::string_view header, std::string_view name);

/// Whether an address is of this computer alone.
bool is_loopback(std::string_view ip);

}  // namespace farrier::web
