#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/recording/session_export.h"
#include "core/base/result.h"
#include "core/infer/estimate/quality.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

// The subcommands of `terratact session` (docs/sessions.md).  Each returns what stood in its way, in one sentence.

/// Prints what is in each session, and whether it holds.
Status showSessions(const std::vector<std::string>& files);

struct VerifyOptions {
    std::vector<std::string> files;
    std::string link;  ///< the last link of the chain, as it was noted elsewhere; empty: not known
};
/// Reads everything and checks every hash.  An Error where anything does not hold.
Status verifySessions(const VerifyOptions& options);

struct RecoverOptions {
    std::vector<std::string> files;
    std::string out;  ///< what a damaged one becomes; empty: NAME-recovered.tts beside it
};
/// Closes sessions whose program died.  Of one that is damaged, lacks its journal or cannot be written, what is whole
/// goes into a new session; the old file stays as it is.  An Error where nothing could be saved.
Status recoverSessions(const RecoverOptions& options);

struct SessionScenesOptions {
    std::vector<std::string> files;
    std::string out;        ///< scenes CSV
    bool measured = false;  ///< heights of contacts and arm where no truth is known
};
Status exportScenes(const SessionScenesOptions& options);

struct SessionExportOptions {
    std::string file, out;
    std::optional<ExportFormat> format;  ///< empty: by the ending of `out`
    ExportSelection selection;
    std::vector<std::string> dbc{};  ///< files for frames that are not the protocol's
};
Status exportSession(const SessionExportOptions& options);

struct SessionMergeOptions {
    std::vector<std::string> files;
    std::string out;
};
/// Puts sessions of one robot that follow each other into a new one.
Status mergeSessions(const SessionMergeOptions& options);

struct SessionReportOptions {
    std::string file, out;
    std::int64_t scene = 0;  ///< 0: the last that was estimated
};
Status reportSession(const SessionReportOptions& options);

struct WhatIfOptions {
    std::vector<std::string> files;  ///< or folders
    std::int64_t estimate = 0;       ///< 0: all
    std::string shippedModel;        ///< where the session's model is looked for
    std::string model;               ///< to estimate with; empty: the session's
    std::string out;                 ///< CSV; empty: none
    // What is to be other than it was.
    std::optional<Method> method{};
    std::optional<Quality> quality{};
    std::optional<double> threshold{};  ///< [N]
    std::optional<std::uint64_t> seed{};
};
/// Computes recorded estimates again and prints the differences.  An Error where nothing was to be other and a
/// recorded estimate does not come out the same, at least but for the last bits (Match in app/recording/what_if.h).
Status whatIf(const WhatIfOptions& options);

struct SessionImportOptions {
    std::string log, out;
    std::string interface;  ///< of a log that holds several
    std::string robot;      ///< robot file that becomes the session's
};
/// Makes a session of a log of CAN frames.
Status importLog(const SessionImportOptions& options);

}  // namespace terratact
