#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// The work that the arguments request; run after parsing.
using Job = std::function<Status()>;

// Each function adds subcommands, in the order of the help. A subcommand owns its options. CLI11 calls its callback if
// the arguments name it; the callback sets the job.

/// Adds simulate.
void addSimulate(CLI::App& app, Job& job);
/// Adds simulate, train, reconstruct, evaluate, hazards, strip, feel-forward, merge, tradeoff. words: arguments after
/// the program's name; models and parts store them.
void addModelling(CLI::App& app, Job& job, const std::vector<std::string>& words);
/// Adds contacts, probes, calibrate, model, which assess measurements and models.
void addInspection(CLI::App& app, Job& job);
/// Adds panel, demo, robot, can.
void addBuses(CLI::App& app, Job& job);
/// Adds truth.
void addTruth(CLI::App& app, Job& job);
/// Adds session and its subcommands, and import.
void addSessions(CLI::App& app, Job& job);

}  // namespace terratact
