#pragma once

#include <sqlite3.h>

#include <stdexcept>
#include <string>

namespace terratact {

/// Executes SQL on a file as another program would. Throws std::runtime_error with SQLite's message.
inline void executeSql(const std::string& path, const std::string& sql)
{
    sqlite3* file = nullptr;
    sqlite3_open(path.c_str(), &file);
    const int code = sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr);
    const std::string message = sqlite3_errmsg(file);
    sqlite3_close(file);
    if (code != SQLITE_OK) throw std::runtime_error(sql + ": " + message);
}

}  // namespace terratact
