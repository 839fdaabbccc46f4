// Names of the pictures of every state of the console, in the order of a mission.
#include <algorithm>
#include <set>

#include "app/display/format.h"
#include "tests/app/console/screens/screens.h"

namespace terratact {

const std::vector<Chapter>& chapters()
{
    static const std::vector<Chapter> kChapters{
        {"start",
         {"no_model", "model_loading", "not_armed", "arming", "hold_to_arm_at_half", "ready",
          "driving", "safe_mode"}},
        {"exploring",
         {"halting", "live_preview", "estimating", "doubtful_ground", "checks_overridden",
          "press_refused_by_the_robot", "moved_meanwhile", "estimate_failed",
          "disarmed_meanwhile"}},
        {"verdict",
         {"clear_to_a_horizon", "clear", "undecided", "blocked", "withheld_stale",
          "withheld_unheard", "withheld_not_converged", "withheld_unlike_training", "withheld_roll",
          "withheld_flippers", "withheld_for_all"}},
        {"probe",
         {"proposed", "draws_second_method_and_a_bin_up_close", "hold_to_approve_at_half",
          "do_not_probe", "probing", "probed", "probe_refused_by_the_robot",
          "question_of_another_model", "approval_void"}},
        {"tooLate",
         {"no_answer_in_time", "probe_took_too_long", "halt_took_too_long", "press_took_too_long",
          "estimate_took_too_long"}},
        {"result",
         {"page_numbers", "page_alarms", "page_signals", "page_training", "page_settings",
          "page_diagnostics", "layout_drive", "layout_review", "keys", "smallest",
          "settings_down_to_the_model_card", "letters_200_percent",
          "letters_200_percent_page_robot", "remembered", "remembered_by_night",
          "remembered_in_high_contrast", "about"}},
        {"gamepad",
         {"no_gamepad", "page_gamepad", "assigns_a_control", "page_gamepad_by_night",
          "page_gamepad_in_high_contrast", "page_gamepad_in_the_smallest_window",
          "page_gamepad_in_letters_of_200_percent"}},
        {"menus", {"menu_quality", "menu_terrain", "menu_needs", "menu_view", "menu_help"}},
        {"stop",
         {"stop_not_confirmed", "stopped", "hold_to_release_stop_at_half", "stop_not_sent"}},
        {"trouble",
         {"no_telemetry_yet", "link_lost", "alarms_of_a_lost_link", "bus_off", "panel_lost",
          "not_recorded"}},
        {"lying",
         {"attitude_alarm", "attitude_alarm_in_the_list", "stuck_imu", "stuck_imu_in_the_list"}},
        {"doubtful_link",
         {"telemetry_lost", "telemetry_unsteady", "disarmed_while_driving",
          "disarmed_while_driving_numbers", "another_console", "bus_warning", "bus_passive",
          "frames_dropped", "force_sensors_unusable", "alarms_of_force_sensors"}},
        {"themes",
         {"not_ready_by_night", "asked_by_night", "stopped_by_night", "link_lost_by_night",
          "alarms_by_night", "not_ready_in_high_contrast", "asked_in_high_contrast",
          "stopped_in_high_contrast", "link_lost_in_high_contrast", "alarms_in_high_contrast",
          "asked_in_the_smallest_window", "asked_in_letters_of_200_percent"}},
        {"following",
         {"no_commands", "following_live_preview", "following_estimate", "stop_has_no_effect",
          "end_of_the_log"}},
        {"training", {"training_running", "training_compared"}},
        {"review",
         {"review", "review_events", "what_if", "what_if_by_another_method",
          "review_letters_200_percent_page_robot", "export", "export_written", "review_has_no_stop",
          "review_with_the_stop_of_its_console"}},
        {"scenes", {"scenes", "scenes_keys", "scenes_list"}},
    };
    return kChapters;
}

QString pictureFile(std::string_view name)
{
    for (std::size_t c = 0; c < chapters().size(); ++c) {
        const auto& pictures = chapters()[c].pictures;
        const auto found = std::ranges::find(pictures, name);
        if (found == pictures.end()) continue;
        return QStringLiteral("%1-%2_%3")
            .arg(c + 1, 2, 10, QLatin1Char('0'))
            .arg(found - pictures.begin() + 1, 2, 10, QLatin1Char('0'))
            .arg(format::text(name));
    }
    return {};
}

TEST(Pictures, haveDistinctNames)
{
    std::set<std::string_view> names;
    std::set<QString> files;
    for (const Chapter& chapter : chapters())
        for (const std::string_view name : chapter.pictures) {
            EXPECT_TRUE(names.insert(name).second) << name;
            EXPECT_TRUE(files.insert(pictureFile(name)).second) << name;
        }
    EXPECT_EQ(pictureFile("not_armed"), "01-03_not_armed");
}

}  // namespace terratact
