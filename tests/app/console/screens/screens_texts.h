#pragma once

#include <QStringList>
#include <set>
#include <string>

namespace terratact {

/// Returns true if a text may equal the English one, because it has only names, units, files and shared words.
bool isSameEverywhere(const std::string& text);

/// Returns true for the first or last line of a tip that quotes a DBC file (plainTip()).
bool isWordsOfAFile(const std::string& text);

/// Returns a text and the parts it is composed of.
std::set<std::string> partsOf(const std::string& text);

/// Returns the entries of `says` that occur in none of the texts; in an entry, %1 matches anything.
QStringList missingIn(const QStringList& texts, const QStringList& says);

}  // namespace terratact
