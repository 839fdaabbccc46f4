#include "app/modelling/findings_tables.h"

#include <array>

namespace terratact {

std::span<const SqliteTable> findingsTables()
{
    static const std::array kTables{
        SqliteTable{"bin_error",
                    "CREATE TABLE bin_error(position INTEGER PRIMARY KEY, scene INTEGER NOT NULL, "
                    "run INTEGER NOT NULL, bin INTEGER NOT NULL, error_m REAL NOT NULL, crps_m "
                    "REAL NOT NULL, "
                    "pit REAL NOT NULL, in_50 INTEGER NOT NULL, in_80 INTEGER NOT NULL, "
                    "in_95 INTEGER NOT NULL, width_m REAL NOT NULL, origin INTEGER NOT NULL, "
                    "novelty REAL NOT NULL, truth_sd_m REAL NOT NULL) STRICT"},
        SqliteTable{"content",
                    "CREATE TABLE content(position INTEGER PRIMARY KEY, sha256 TEXT NOT NULL) "
                    "STRICT"},
        SqliteTable{"meta", "CREATE TABLE meta(position INTEGER PRIMARY KEY, key TEXT NOT NULL, "
                            "value TEXT NOT NULL) STRICT"},
        SqliteTable{"method",
                    "CREATE TABLE method(position INTEGER PRIMARY KEY, name TEXT NOT NULL) STRICT"},
        SqliteTable{"method_run",
                    "CREATE TABLE method_run(position INTEGER PRIMARY KEY, label TEXT NOT NULL, "
                    "scenes INTEGER NOT NULL, converged INTEGER NOT NULL, "
                    "ended_by_sweeps INTEGER NOT NULL, ended_by_time INTEGER NOT NULL, "
                    "failed INTEGER NOT NULL, "
                    "seconds REAL NOT NULL) STRICT"},
        SqliteTable{
            "part",
            "CREATE TABLE part(position INTEGER PRIMARY KEY, number INTEGER NOT NULL, count "
            "INTEGER NOT NULL, total INTEGER NOT NULL, "
            "seed TEXT NOT NULL, step_limit_m REAL NOT NULL, sd_limit_m REAL NOT NULL, "
            "classes INTEGER NOT NULL) STRICT"},
        SqliteTable{"probe_run",
                    "CREATE TABLE probe_run(position INTEGER PRIMARY KEY, label TEXT NOT NULL, "
                    "rule TEXT NOT NULL) STRICT"},
        SqliteTable{
            "probe_trial",
            "CREATE TABLE probe_trial(position INTEGER PRIMARY KEY, run INTEGER NOT NULL, "
            "ahead_before_m REAL NOT NULL, all_before_m REAL NOT NULL, ahead_after_m REAL NOT "
            "NULL, "
            "all_after_m REAL NOT NULL, probes INTEGER NOT NULL, settled INTEGER NOT NULL) STRICT"},
        SqliteTable{
            "scene",
            "CREATE TABLE scene(position INTEGER PRIMARY KEY, run TEXT NOT NULL, "
            "t_s REAL NOT NULL, under_flipper INTEGER NOT NULL, class TEXT NOT NULL) STRICT"},
        SqliteTable{
            "step_forecast",
            "CREATE TABLE step_forecast(position INTEGER PRIMARY KEY, scene INTEGER NOT NULL, "
            "run INTEGER NOT NULL, place INTEGER NOT NULL, probability REAL NOT NULL, "
            "observed INTEGER NOT NULL) STRICT"},
    };
    return kTables;
}

}  // namespace terratact
