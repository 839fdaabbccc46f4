#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/modelling/session_reruns.h"
#include "app/recording/export/session_export.h"
#include "core/base/result.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

// The subcommands of `terratact session` (docs/sessions.md). Each returns an Error of one sentence if it fails.

/// Prints the content of each session, and whether its hash chain holds.
Status showSessions(const std::vector<std::string>& files);

/// Prints a line for each recording of a folder: start, duration, verdicts, probes, alarms, notes and size. Empty: the
/// folder of this user's sessions. A file that is not a session gets a line with the reason.
Status listSessions(const std::string& folder);

struct VerifyOptions {
    std::vector<std::string> files;
    std::string link;  ///< last link of the chain, noted elsewhere; empty: unknown
};
/// Reads everything and checks every hash. Returns an Error if a check fails.
Status verifySessions(const VerifyOptions& options);

struct RecoverOptions {
    std::vector<std::string> files;
    std::string out;  ///< new session for a damaged one; empty: NAME-recovered.tts
};
/// Closes sessions whose program died. A session or its journal may be damaged, the journal may be missing, or the
/// session be read-only. Its undamaged rows are then copied to a new session. The old file and its journal stay
/// unchanged. Returns an Error if nothing could be saved.
Status recoverSessions(const RecoverOptions& options);

struct SessionScenesOptions {
    std::vector<std::string> files;
    std::string out;        ///< CSV of scenes
    bool measured = false;  ///< heights of contacts and arm if the truth is unknown
    bool tracks = false;    ///< readings and heights of both sides
    bool drives = false;    ///< also the way between the scenes: a file of drives
};
Status exportScenes(const SessionScenesOptions& options);

struct SessionStripOptions {
    std::string file;
    std::string out;  ///< its ending selects the format (app/figures/report/strip_file.h)
    std::optional<int> section{};  ///< the only one, from 1; empty: all
};
/// Writes the strip of felt ground of a session as a profile, a point cloud or a picture
/// (app/figures/report/strip_file.h).
Status exportStrip(const SessionStripOptions& options);

struct SessionExportOptions {
    std::string file, out;
    std::optional<ExportFormat> format;  ///< empty: chosen by the ending of `out`
    ExportSelection selection;
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
};
Status exportSession(const SessionExportOptions& options);

struct SessionMergeOptions {
    std::vector<std::string> files;
    std::string out;
};
/// Merges consecutive sessions of one robot into a new one.
Status mergeSessions(const SessionMergeOptions& options);

struct SessionReportOptions {
    std::string file, out;
    std::int64_t scene = 0;          ///< 0: the last estimated scene
    bool mission = false;            ///< the whole session instead of a scene
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
};
Status reportSession(const SessionReportOptions& options);

struct WhatIfOptions {
    SessionReruns::Options rerun{};
    std::vector<std::string> files;  ///< sessions or folders
    std::string out;                 ///< CSV output; empty: none
};
/// Recomputes recorded estimates and prints the differences. Without changes, returns an Error unless every estimate is
/// equal up to the last bits (Match in app/recording/what_if.h).
Status whatIf(const WhatIfOptions& options);

struct SessionImportOptions {
    std::string log, out;
    std::string interface;  ///< needed if the log holds several
    std::string robot;      ///< robot file to store in the session
};
/// Converts a CAN log to a session.
Status importLog(const SessionImportOptions& options);

struct ImportOptions {
    std::string file;     ///< recording of another program
    std::string mapping;  ///< mapping file; empty with `probe`
    std::string robot;    ///< robot file to store in the session
    std::string out;      ///< session to write; empty: none
    std::string scenes;   ///< CSV of scenes to write; empty: none
    bool probe = false, check = false;
};
/// Reads a recording of another program. It prints the contents (probe) or the doubtful values (check), or
/// writes a session and its scenes. With check, returns an Error if a value is doubtful.
Status importOrProbe(const ImportOptions& options);

}  // namespace terratact
