#include "core/log/rows/session_schema.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

namespace terratact {
namespace {

constexpr SessionSchema kVersion1{
    SchemaEntry{
        "table", "batch",
        "CREATE TABLE batch(id INTEGER PRIMARY KEY, t_first INTEGER NOT NULL, "
        "t_last INTEGER NOT NULL, frame_first INTEGER NOT NULL, frame_count INTEGER NOT NULL, "
        "frames_hash BLOB NOT NULL, rows_hash BLOB NOT NULL, chain BLOB NOT NULL) STRICT"},
    SchemaEntry{"table", "can_frame",
                "CREATE TABLE can_frame(seq INTEGER PRIMARY KEY, t INTEGER NOT NULL, "
                "channel INTEGER NOT NULL, can_id INTEGER NOT NULL, flags INTEGER NOT NULL, "
                "data BLOB NOT NULL) STRICT"},
    SchemaEntry{"table", "estimate",
                "CREATE TABLE estimate(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, scene INTEGER NOT NULL, settings INTEGER NOT NULL, "
                "model INTEGER NOT NULL, role TEXT NOT NULL, seconds REAL NOT NULL, "
                "step_limit_m REAL NOT NULL, novelty REAL NOT NULL, ending TEXT NOT NULL, "
                "converged INTEGER NOT NULL, warnings TEXT NOT NULL, "
                "draws_sha256 BLOB NOT NULL) STRICT"},
    SchemaEntry{"table", "estimate_bin",
                "CREATE TABLE estimate_bin(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "estimate INTEGER NOT NULL, bin INTEGER NOT NULL, origin TEXT NOT NULL, "
                "height_m REAL NOT NULL, mean_m REAL NOT NULL, sd_m REAL NOT NULL, "
                "q10_m REAL NOT NULL, q90_m REAL NOT NULL, ceiling_m REAL, rhat REAL NOT NULL, "
                "ess REAL NOT NULL) STRICT"},
    SchemaEntry{"table", "estimate_draws",
                "CREATE TABLE estimate_draws(id INTEGER PRIMARY KEY, draws BLOB NOT NULL) STRICT"},
    SchemaEntry{
        "table", "event",
        "CREATE TABLE event(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, kind TEXT NOT NULL, subject TEXT NOT NULL, text TEXT NOT NULL, "
        "number REAL, estimate INTEGER NOT NULL, proposal INTEGER NOT NULL, "
        "shown TEXT NOT NULL) STRICT"},
    SchemaEntry{"view", "messages",
                "CREATE VIEW messages AS SELECT ((SELECT CAST(value AS INTEGER) FROM meta "
                "WHERE key = 'wall_time_ns') + t) / 1e9 AS ts, can_id AS arbitration_id, "
                "flags & 1 AS extended, (flags >> 1) & 1 AS remote, (flags >> 2) & 1 AS error, "
                "flags >> 8 AS dlc, data FROM can_frame"},
    SchemaEntry{"table", "meta",
                "CREATE TABLE meta(key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL) STRICT, "
                "WITHOUT ROWID"},
    SchemaEntry{"table", "model",
                "CREATE TABLE model(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, name TEXT NOT NULL, sha256 TEXT NOT NULL, "
                "details TEXT NOT NULL) STRICT"},
    SchemaEntry{"table", "proposal",
                "CREATE TABLE proposal(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, estimate INTEGER NOT NULL, bin INTEGER NOT NULL, "
                "height_m REAL NOT NULL, q10_m REAL NOT NULL, q90_m REAL NOT NULL, "
                "sd_m REAL NOT NULL, limit_m REAL NOT NULL, arm_sd_m REAL NOT NULL, "
                "seconds REAL NOT NULL, step_limit_m REAL NOT NULL, bits_before REAL NOT NULL, "
                "grounds TEXT NOT NULL) STRICT"},
    SchemaEntry{"table", "proposal_offer",
                "CREATE TABLE proposal_offer(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "proposal INTEGER NOT NULL, bin INTEGER NOT NULL, variance_share REAL NOT NULL, "
                "bits_after REAL NOT NULL) STRICT"},
    SchemaEntry{"table", "reading",
                "CREATE TABLE reading(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "estimate INTEGER NOT NULL, bin INTEGER NOT NULL, height_m REAL NOT NULL, "
                "sd_m REAL NOT NULL) STRICT"},
    SchemaEntry{
        "table", "scene",
        "CREATE TABLE scene(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, robot_time_s REAL NOT NULL, pitch_rad REAL NOT NULL, "
        "roll_rad REAL NOT NULL, front_left_rad REAL NOT NULL, front_right_rad REAL NOT NULL, "
        "rear_left_rad REAL NOT NULL, rear_right_rad REAL NOT NULL, "
        "front_left_a REAL NOT NULL, front_right_a REAL NOT NULL, rear_left_a REAL NOT NULL, "
        "rear_right_a REAL NOT NULL, force1_n REAL NOT NULL, force2_n REAL NOT NULL, "
        "force3_n REAL NOT NULL, force4_n REAL NOT NULL, force5_n REAL NOT NULL, "
        "force6_n REAL NOT NULL, activity INTEGER NOT NULL, refusal INTEGER NOT NULL, "
        "arm_bin INTEGER, arm_height_m REAL, arm_sd_m REAL, "
        "travelled_m REAL, turned_rad REAL) STRICT"},
    SchemaEntry{"table", "scene_truth",
                "CREATE TABLE scene_truth(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "scene INTEGER NOT NULL, bin INTEGER NOT NULL, height_m REAL NOT NULL) STRICT"},
    SchemaEntry{
        "table", "settings",
        "CREATE TABLE settings(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "method TEXT NOT NULL, ceiling TEXT NOT NULL, contacts TEXT NOT NULL, "
        "force_threshold_n REAL NOT NULL, contact_sd_m REAL NOT NULL, draws INTEGER NOT NULL, "
        "stop_early INTEGER NOT NULL, chains INTEGER NOT NULL, burn_in INTEGER NOT NULL, "
        "scan TEXT NOT NULL, precision TEXT NOT NULL, inducing INTEGER NOT NULL, "
        "seed TEXT NOT NULL, probe_above_m REAL NOT NULL, roll_limit_rad REAL NOT NULL, "
        "asymmetry_limit_rad REAL NOT NULL) STRICT"},
};

/// Tables whose statements differ in version 2.
constexpr std::array kVersion2{
    SchemaEntry{"table", "estimate",
                "CREATE TABLE estimate(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, scene INTEGER NOT NULL, settings INTEGER NOT NULL, "
                "model INTEGER NOT NULL, role TEXT NOT NULL, seconds REAL NOT NULL, "
                "step_limit_m REAL NOT NULL, novelty REAL NOT NULL, ending TEXT NOT NULL, "
                "converged INTEGER NOT NULL, warnings TEXT NOT NULL, "
                "draws_sha256 BLOB NOT NULL, felt_to_m REAL NOT NULL) STRICT"},
    SchemaEntry{"table", "estimate_bin",
                "CREATE TABLE estimate_bin(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "estimate INTEGER NOT NULL, bin INTEGER NOT NULL, origin TEXT NOT NULL, "
                "height_m REAL NOT NULL, mean_m REAL NOT NULL, sd_m REAL NOT NULL, "
                "q10_m REAL NOT NULL, q90_m REAL NOT NULL, ceiling_m REAL, rhat REAL NOT NULL, "
                "ess REAL NOT NULL, touch TEXT NOT NULL) STRICT"},
    SchemaEntry{
        "table", "scene",
        "CREATE TABLE scene(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, robot_time_s REAL NOT NULL, pitch_rad REAL NOT NULL, "
        "roll_rad REAL NOT NULL, front_left_rad REAL NOT NULL, front_right_rad REAL NOT NULL, "
        "rear_left_rad REAL NOT NULL, rear_right_rad REAL NOT NULL, "
        "front_left_a REAL, front_right_a REAL, rear_left_a REAL, rear_right_a REAL, "
        "force1_n REAL, force2_n REAL, force3_n REAL, force4_n REAL, force5_n REAL, "
        "force6_n REAL, activity INTEGER NOT NULL, refusal INTEGER NOT NULL, "
        "arm_bin INTEGER, arm_height_m REAL, arm_sd_m REAL, "
        "travelled_m REAL, turned_rad REAL) STRICT"},
    SchemaEntry{
        "table", "settings",
        "CREATE TABLE settings(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "method TEXT NOT NULL, ceiling TEXT NOT NULL, contacts TEXT NOT NULL, "
        "force_threshold_n REAL NOT NULL, contact_sd_m REAL NOT NULL, draws INTEGER NOT NULL, "
        "stop_early INTEGER NOT NULL, chains INTEGER NOT NULL, burn_in INTEGER NOT NULL, "
        "scan TEXT NOT NULL, precision TEXT NOT NULL, inducing INTEGER NOT NULL, "
        "seed TEXT NOT NULL, probe_above_m REAL NOT NULL, roll_limit_rad REAL NOT NULL, "
        "asymmetry_limit_rad REAL NOT NULL, hazard_rate REAL NOT NULL) STRICT"},
};

/// Tables whose statements differ in version 3.
constexpr std::array kVersion3{
    SchemaEntry{"table", "estimate",
                "CREATE TABLE estimate(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, scene INTEGER NOT NULL, settings INTEGER NOT NULL, "
                "model INTEGER NOT NULL, role TEXT NOT NULL, seconds REAL NOT NULL, "
                "step_limit_m REAL NOT NULL, novelty REAL NOT NULL, ending TEXT NOT NULL, "
                "converged INTEGER NOT NULL, warnings TEXT NOT NULL, "
                "draws_sha256 BLOB NOT NULL, felt_to_m REAL NOT NULL, "
                "contradicts INTEGER NOT NULL, messages TEXT NOT NULL) STRICT"},
    SchemaEntry{
        "table", "event",
        "CREATE TABLE event(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, kind TEXT NOT NULL, subject TEXT NOT NULL, text TEXT NOT NULL, "
        "number REAL, estimate INTEGER NOT NULL, proposal INTEGER NOT NULL, "
        "shown TEXT NOT NULL, message TEXT NOT NULL) STRICT"},
};

/// Tables whose statements differ in version 4.
constexpr std::array kVersion4{
    SchemaEntry{"table", "estimate",
                "CREATE TABLE estimate(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, scene INTEGER NOT NULL, settings INTEGER NOT NULL, "
                "model INTEGER NOT NULL, role TEXT NOT NULL, seconds REAL NOT NULL, "
                "step_limit_m REAL NOT NULL, novelty REAL NOT NULL, ending TEXT NOT NULL, "
                "converged INTEGER NOT NULL, warnings TEXT NOT NULL, "
                "draws_sha256 BLOB NOT NULL, felt_to_m REAL NOT NULL, "
                "contradicts INTEGER NOT NULL, messages TEXT NOT NULL, one_plane INTEGER NOT NULL, "
                "right_novelty REAL, right_ending TEXT, right_converged INTEGER, "
                "right_warnings TEXT, right_felt_to_m REAL, right_contradicts INTEGER, "
                "right_messages TEXT) STRICT"},
    SchemaEntry{"table", "estimate_bin",
                "CREATE TABLE estimate_bin(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "estimate INTEGER NOT NULL, bin INTEGER NOT NULL, origin TEXT NOT NULL, "
                "height_m REAL NOT NULL, mean_m REAL NOT NULL, sd_m REAL NOT NULL, "
                "q10_m REAL NOT NULL, q90_m REAL NOT NULL, ceiling_m REAL, rhat REAL NOT NULL, "
                "ess REAL NOT NULL, touch TEXT NOT NULL, side TEXT NOT NULL) STRICT"},
    SchemaEntry{"table", "proposal",
                "CREATE TABLE proposal(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, estimate INTEGER NOT NULL, bin INTEGER NOT NULL, "
                "height_m REAL NOT NULL, q10_m REAL NOT NULL, q90_m REAL NOT NULL, "
                "sd_m REAL NOT NULL, limit_m REAL NOT NULL, arm_sd_m REAL NOT NULL, "
                "seconds REAL NOT NULL, step_limit_m REAL NOT NULL, bits_before REAL NOT NULL, "
                "grounds TEXT NOT NULL, side TEXT NOT NULL) STRICT"},
    SchemaEntry{"table", "proposal_offer",
                "CREATE TABLE proposal_offer(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "proposal INTEGER NOT NULL, bin INTEGER NOT NULL, variance_share REAL NOT NULL, "
                "bits_after REAL NOT NULL, side TEXT NOT NULL) STRICT"},
    SchemaEntry{"table", "reading",
                "CREATE TABLE reading(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "estimate INTEGER NOT NULL, bin INTEGER NOT NULL, height_m REAL NOT NULL, "
                "sd_m REAL NOT NULL, side TEXT NOT NULL) STRICT"},
    SchemaEntry{
        "table", "scene",
        "CREATE TABLE scene(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, robot_time_s REAL NOT NULL, pitch_rad REAL NOT NULL, "
        "roll_rad REAL NOT NULL, front_left_rad REAL NOT NULL, front_right_rad REAL NOT NULL, "
        "rear_left_rad REAL NOT NULL, rear_right_rad REAL NOT NULL, "
        "front_left_a REAL, front_right_a REAL, rear_left_a REAL, rear_right_a REAL, "
        "force1_n REAL, force2_n REAL, force3_n REAL, force4_n REAL, force5_n REAL, "
        "force6_n REAL, activity INTEGER NOT NULL, refusal INTEGER NOT NULL, "
        "arm_bin INTEGER, arm_height_m REAL, arm_sd_m REAL, "
        "travelled_m REAL, turned_rad REAL, differential_rad REAL, "
        "front_left_force1_n REAL, front_left_force2_n REAL, front_left_force3_n REAL, "
        "front_left_force4_n REAL, front_left_force5_n REAL, front_left_force6_n REAL, "
        "front_right_force1_n REAL, front_right_force2_n REAL, front_right_force3_n REAL, "
        "front_right_force4_n REAL, front_right_force5_n REAL, front_right_force6_n REAL, "
        "rear_left_force1_n REAL, rear_left_force2_n REAL, rear_left_force3_n REAL, "
        "rear_left_force4_n REAL, rear_left_force5_n REAL, rear_left_force6_n REAL, "
        "rear_right_force1_n REAL, rear_right_force2_n REAL, rear_right_force3_n REAL, "
        "rear_right_force4_n REAL, rear_right_force5_n REAL, rear_right_force6_n REAL, "
        "arm_side TEXT) STRICT"},
    SchemaEntry{"table", "scene_truth",
                "CREATE TABLE scene_truth(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "scene INTEGER NOT NULL, bin INTEGER NOT NULL, height_m REAL NOT NULL, "
                "side TEXT NOT NULL) STRICT"},
};

/// Tables whose statements differ in version 5.
constexpr std::array kVersion5{
    SchemaEntry{"table", "model",
                "CREATE TABLE model(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
                "t INTEGER NOT NULL, name TEXT NOT NULL, sha256 TEXT NOT NULL, "
                "details TEXT NOT NULL, trail_name TEXT NOT NULL, "
                "trail_sha256 TEXT NOT NULL) STRICT"},
    SchemaEntry{
        "table", "scene",
        "CREATE TABLE scene(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, robot_time_s REAL NOT NULL, pitch_rad REAL NOT NULL, "
        "roll_rad REAL NOT NULL, front_left_rad REAL NOT NULL, front_right_rad REAL NOT NULL, "
        "rear_left_rad REAL NOT NULL, rear_right_rad REAL NOT NULL, "
        "front_left_a REAL, front_right_a REAL, rear_left_a REAL, rear_right_a REAL, "
        "force1_n REAL, force2_n REAL, force3_n REAL, force4_n REAL, force5_n REAL, "
        "force6_n REAL, activity INTEGER NOT NULL, refusal INTEGER NOT NULL, "
        "arm_bin INTEGER, arm_height_m REAL, arm_sd_m REAL, "
        "travelled_m REAL, turned_rad REAL, differential_rad REAL, "
        "front_left_force1_n REAL, front_left_force2_n REAL, front_left_force3_n REAL, "
        "front_left_force4_n REAL, front_left_force5_n REAL, front_left_force6_n REAL, "
        "front_right_force1_n REAL, front_right_force2_n REAL, front_right_force3_n REAL, "
        "front_right_force4_n REAL, front_right_force5_n REAL, front_right_force6_n REAL, "
        "rear_left_force1_n REAL, rear_left_force2_n REAL, rear_left_force3_n REAL, "
        "rear_left_force4_n REAL, rear_left_force5_n REAL, rear_left_force6_n REAL, "
        "rear_right_force1_n REAL, rear_right_force2_n REAL, rear_right_force3_n REAL, "
        "rear_right_force4_n REAL, rear_right_force5_n REAL, rear_right_force6_n REAL, "
        "arm_side TEXT, memory BLOB) STRICT"},
};

/// Tables whose statements differ in version 6.
constexpr std::array kVersion6{
    SchemaEntry{
        "table", "event",
        "CREATE TABLE event(id INTEGER PRIMARY KEY, batch INTEGER NOT NULL, "
        "t INTEGER NOT NULL, kind TEXT NOT NULL, subject TEXT NOT NULL, text TEXT NOT NULL, "
        "number REAL, estimate INTEGER NOT NULL, proposal INTEGER NOT NULL, "
        "shown TEXT NOT NULL, message TEXT NOT NULL, shown_message TEXT NOT NULL) STRICT"},
};

void replace(SessionSchema& schema, std::span<const SchemaEntry> newer)
{
    for (const SchemaEntry& entry : newer)
        *std::ranges::find(schema, std::string_view(entry.name), &SchemaEntry::name) = entry;
}

}  // namespace

SessionSchema sessionSchema(std::int64_t version)
{
    SessionSchema schema = kVersion1;
    if (version >= 2) replace(schema, kVersion2);
    if (version >= 3) replace(schema, kVersion3);
    if (version >= 4) replace(schema, kVersion4);
    if (version >= 5) replace(schema, kVersion5);
    if (version >= 6) replace(schema, kVersion6);
    return schema;
}

int sessionColumns(std::int64_t version, std::string_view table)
{
    const SessionSchema schema = sessionSchema(version);
    const auto entry = std::ranges::find(schema, table, &SchemaEntry::name);
    if (entry == schema.end()) throw std::invalid_argument("sessionColumns: no such table");
    return 1 + static_cast<int>(std::ranges::count(std::string_view(entry->sql), ','));
}

}  // namespace terratact
