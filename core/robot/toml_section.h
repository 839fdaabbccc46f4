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

// Strict, bounded reader for TOML files from users. Every refusal names its line and key. For a missing key it names
// the line where its table begins. It names no line for the file's top section. Only core sources that read a file
// format include this header.

/// Refusal of a file: a sentence without the file's name. readTomlFile() catches it.
class TomlRefused : public Failure {
public:
    using Failure::Failure;
};

/// Closed range: both ends belong to it.
struct TomlRange {
    double least, most;
};

// These throw TomlRefused.
double tomlNumber(const toml::node& node, const std::string& key, TomlRange range);
const toml::array& tomlArray(const toml::node& node, std::string_view key, std::size_t least,
                             std::size_t most);
Message tomlLine(const toml::node& node);  ///< "line 7"

/// One table of the file. Every key that is read must exist; refuseUnknown() refuses all other keys.
/// Throws TomlRefused.
class TomlSection {
public:
    TomlSection(const toml::table& table, std::string prefix);

    std::string path(std::string_view key) const { return prefix_ + std::string(key); }
    const toml::node& node(std::string_view key);
    bool has(std::string_view key) const { return table_.contains(key); }

    double number(std::string_view key, TomlRange range);
    std::string text(std::string_view key);  ///< must satisfy isReadableName()
    /// Returns the position of the key's text among the choices.
    std::size_t choice(std::string_view key, std::initializer_list<std::string_view> choices);

    /// Reads the section of that name with `read`, and refuses keys that `read` did not ask for.
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

/// Reads the file's top section with `read`, and refuses keys that `read` did not ask for. Errors
/// name the file and the cause. It cannot be read, is empty, or is larger than 64 KiB. It is not
/// TOML, or nests too deep for the parser. `read` refused it.
Status readTomlFile(const std::string& path, const std::function<void(TomlSection&)>& read);

/// Reads the same from a text; errors call it `name`.
Status readToml(const std::string& name, const std::string& text,
                const std::function<void(TomlSection&)>& read);

}  // namespace terratact
