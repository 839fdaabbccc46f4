#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/wording.h"
#include "app/link/dbc_book.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Returns lines of a report with the values that other devices had sent before a time of a session. An example is
/// "payload" and "500 Gas: Oxygen 20.5 %, 0.4 s before". The lines have the newest values of each described frame
/// within kPayloadWindow. The last line counts the frames beyond kMaxPayloadFacts. book: null: no lines. wording: makes
/// the texts.
std::vector<std::pair<std::string, std::string>>
payloadFacts(SessionReader& session, const std::shared_ptr<const DbcBook>& book, SessionTime time,
             const Wording& wording = inEnglish);
inline constexpr double kPayloadWindow = 10.0;  ///< [s]
inline constexpr std::size_t kMaxPayloadFacts = 8;

}  // namespace terratact
