#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

// How core reads somebody's TOML: strictly, within bounds, every refusal with its line and key.  For the
// sources of core that read a file format; their headers show none of it.

/// Why a file is refused: a sentence that lacks the file's name.  readTomlFile() catches it.
struct TomlRefused {
    std::string cause;
};

/// Both ends belong to the range.
struct TomlRange {
    double least, most;
};

// These throw TomlRefused.
double tomlNumber(const toml::node& node, const std::string& key, TomlRange range);
const toml::array& tomlArray(const toml::node& node, const std::string& key, std::size_t least,
                             std::size_t most);
std::string tomlLine(const toml::node& node);  ///< "line 7"

/// One table of the file.  Every key it is asked for must be there; the others are refused in the end.
/// Throws TomlRefused.
class TomlSection {
public:
    TomlSection(const toml::table& table, std::string prefix);

    std::string path(std::string_view key) const { return prefix_ + std::string(key); }
    const toml::node& node(std::string_view key);
    bool has(std::string_view key) const { return table_.contains(key); }

    double number(std::string_view key, TomlRange range);
    std::string text(std::string_view key);  ///< as isReadableName() wants it
    /// The position of the key's text among the choices.
    std::size_t choice(std::string_view key, std::initializer_list<std::string_view> choices);

    /// Reads the section of that name with `read` and refuses what it did not ask for.
    template <class Read>
    void section(std::string_view key, Read read)
    {
        TomlSection inner(table(key), path(key) + ".");
        read(inner);
        inner.refuseUnknown();
    }

    void refuseUnknown() const;

private:
    const toml::table& table(std::string_view key);

    const toml::table& table_;
    std::string prefix_;
    std::set<std::string, std::less<>> known_;
};

/// Reads the file's top section with `read` and refuses what it did not ask for.  Errors name the file:
/// it cannot be read, is empty, larger than 64 KiB, nests too deep for the parser, is not TOML, or
/// `read` refused it.
Status readTomlFile(const std::string& path, const std::function<void(TomlSection&)>& read);

/// The same for a text at hand, which errors call `name`.
Status readToml(const std::string& name, const std::string& text,
                const std::function<void(TomlSection&)>& read);

}  // namespace terratact
