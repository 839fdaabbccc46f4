#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// What the arguments ask for: to be run once all of them are parsed.
using Job = std::function<Status()>;

// Each adds subcommands to the program, in the order of its help.  A subcommand owns its options: its callback, which
// CLI11 calls where the arguments name it, keeps them and sets the job that takes them.

/// simulate, train, reconstruct, evaluate, hazards, merge, tradeoff.
/// words: of the command behind the program's name; models and parts remember them.
void addModelling(CLI::App& app, Job& job, const std::vector<std::string>& words);
/// contacts, ghost, probes, calibrate, model: what measurements and models are worth.
void addInspection(CLI::App& app, Job& job);
/// panel, demo, robot, can.
void addBuses(CLI::App& app, Job& job);
/// session and what is below it.
void addSessions(CLI::App& app, Job& job);

}  // namespace terratact
