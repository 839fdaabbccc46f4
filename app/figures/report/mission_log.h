#pragma once

#include <cstddef>
#include <functional>

#include "app/figures/report/report_document.h"
#include "app/figures/wording.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Largest number of rows of a table. A report only counts the other rows.
inline constexpr std::size_t kMaxReportRows = 20'000;

/// Returns the decisions and their numbers in the order of time: verdicts, proposals, phases, arming, link states and
/// notes. An action of the operator has the text that was on the screen. Alarms and entries of the event list are left
/// out. An estimate has its error if the truth was recorded. Errors name the session's file: the draws of an estimate
/// cannot be read. progress(share) cancels by returning false, which is an Error.
/// wording: makes the texts. Beyond maxRows a last row has the number of rows that are left out.
Result<DocumentPart> missionDecisions(SessionReader& session, const RobotModel& robot,
                                      const std::function<bool(double)>& progress = {},
                                      std::size_t maxRows = kMaxReportRows,
                                      const Wording& wording = inEnglish);

/// Returns each alarm with three times: when it was raised, when it was acknowledged, and when its cause ended.
DocumentPart missionAlarms(const SessionReader& session, const Wording& wording = inEnglish);

/// Returns the settings of the estimates, a row from each change on.
DocumentPart missionSettings(const SessionReader& session, std::size_t maxRows = kMaxReportRows,
                             const Wording& wording = inEnglish);

}  // namespace terratact
