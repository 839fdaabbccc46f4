#include "app/runtime/user_folder.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace terratact {
namespace {

bool isAbsolute(const char* folder)
{
    return folder && *folder == '/';
}

}  // namespace

std::string userFolder(const char* variable, std::string_view below)
{
    if (const char* const own = std::getenv(variable); isAbsolute(own)) return own;
    const char* home = std::getenv("HOME");
    if (const passwd* const user = ::getpwuid(::getuid()); user && !isAbsolute(home))
        home = user->pw_dir;
    return isAbsolute(home) ? std::string(home).append("/").append(below) : std::string();
}

}  // namespace terratact
