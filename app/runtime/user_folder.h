#pragma once

#include <string>
#include <string_view>

namespace terratact {

/// Returns a folder of this user, of the XDG base directory specification. It is that of the environment variable, such
/// as XDG_STATE_HOME, else `below` the home folder, such as ".local/state". The home folder is $HOME, else that of the
/// user database. Variables count only if they begin with '/'. Empty: there is no home folder.
std::string userFolder(const char* variable, std::string_view below);

}  // namespace terratact
