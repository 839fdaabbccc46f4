#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/figures/wording.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/strip/strip.h"

namespace terratact {

/// Returns the strip of a whole session (core/log/session_strip.h). progress(share) cancels by returning false: null is
/// returned.
std::shared_ptr<const Strip> stripOf(SessionReader& session, const RobotModel& robot,
                                     const std::function<bool(double)>& progress = {});

/// Returns the metres of ground that a strip holds [m].
double groundOf(const Strip& strip);

/// Returns the title of a strip of a session's file. Empty: of a running drive.
Message stripTitle(const std::string& file);

/// Writes a strip of felt ground by the file ending. .csv is a profile and .ply a point cloud
/// (app/recording/export/strip_export.h). .png, .svg, .pdf and .html are pictures (app/figures/report/strip_figure.h).
/// title: name of the drive. wording: makes the texts of a picture. section: the only section to write, from 1; empty:
/// all. Errors name the file: another ending, no ground, no such section, not writable.
Status writeStrip(const std::string& path, const std::shared_ptr<const Strip>& strip,
                  const RobotModel& robot, const std::string& title,
                  std::optional<int> section = {}, const Wording& wording = inEnglish);

}  // namespace terratact
