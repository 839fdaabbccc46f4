#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTimer>
#include <array>
#include <chrono>
#include <string>

#include "app/console/pages/signals_page.h"
#include "app/shell/preferences/preference_store.h"
#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/devices/counting_alarm_sound.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/signal_table.h"

/// A console with a robot on a bus, and frames of other devices.
namespace terratact {

struct Pages : testing::Test, RobotOnBench {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(const QStringList& dbc = {})
    {
        startRobot();
        MainWindow::Options options =
            linked({.mode = CanSource::Mode::Transmit, .bitrate = 500'000.0});
        options.exploration = {};  // the link is lost soon after the bus, as in use
        Preferences preferences;
        preferences.dbc = dbc;
        options.preferences = std::make_unique<PreferenceStore>(LoadedPreferences{}, preferences);
        show(std::move(options));
    }
    void openWithoutBus()
    {
        auto source = std::make_unique<ScriptedSource>();
        MainWindow::Options options;
        options.robot = model;
        options.source = std::move(source);
        show(std::move(options));
    }
    void show(MainWindow::Options options)
    {
        options.model = [] {
            return Result<LoadedModel>(
                LoadedModel{.estimate = [](const EstimateRequest&,
                                           const Watch&) { return equalSides(stepEstimate()); },
                            .name = "fake.ttm",
                            .details = "made up"});
        };
        options.alarmSound = std::make_unique<CountingAlarmSound>(sounds);
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1280, 720);
        gui::showActive(*window);
    }
    void picture(const QString& name)
    {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (!folder.isEmpty()) window->grab().save(folder + "/" + name + ".png");
    }
    QString valueOf(const QString& signal)
    {
        const SignalTable* table = window->signalsPage()->table();
        for (int row = 0; row < table->rows(); ++row)
            if (table->text(row, SignalTable::Name) == signal)
                return table->text(row, SignalTable::Value);
        return "no such signal";
    }
    QString tipOf(const QString& signal, SignalTable::Column column) const
    {
        const QAbstractItemModel* rows = window->signalsPage()->table()->model();
        for (int row = 0; row < rows->rowCount(); ++row)
            if (rows->index(row, SignalTable::Name).data().toString() == signal)
                return rows->index(row, column).data(Qt::ToolTipRole).toString();
        return {};
    }

    int sounds = 0;
    std::unique_ptr<MainWindow> window;
};

struct ForeignFramesOnThePage : Pages {
    ForeignFramesOnThePage()
    {
        directory.write("gas.dbc", "BO_ 1280 GasSensor: 8 Payload\n"
                                   " SG_ Oxygen : 7|16@0+ (0.01,0) [0|25] \"%\" C\n"
                                   " SG_ State : 16|2@1+ (1,0) [0|2] \"\" C\n"
                                   "BO_ 2566836481 Battery: 4 Payload\n"
                                   " SG_ Power : 0|32@1- (1,0) [0|0] \"W\" C\n"
                                   "CM_ BO_ 1280 \"Of the <b>air</b>.\";\n"
                                   "CM_ SG_ 1280 Oxygen \"Below 19.5 % no human may enter.\";\n"
                                   "VAL_ 1280 State 1 \"ready\" ;\n"
                                   "SIG_VALTYPE_ 2566836481 Power : 1;\n");
        directory.write("clash.dbc", "BO_ 34 Tilt: 8 P\nBO_ 1280 Other: 8 P\n");
        directory.write("bad.dbc", "nothing\n");
        payload = bus.join("payload");
        QObject::connect(&sending, &QTimer::timeout, [this] {
            std::array<BusFrame, 64> heard;
            (void)payload->receive(heard, std::chrono::milliseconds(0));  // keeps the bus end alive
            (void)payload->send({.id = 1280, .length = 3, .data = {0x08, 0x17, 1}});
            (void)payload->send(
                {.id = 0x18FED101, .extended = true, .length = 4, .data = {0, 0x80, 0x3B, 0x43}});
        });
        sending.start(20);
    }
    ~ForeignFramesOnThePage() override { sending.stop(); }
    QString file(const std::string& name) const
    {
        return QString::fromStdString(directory.file(name));
    }
    TemporaryDirectory directory;
    std::unique_ptr<CanBus> payload;
    QTimer sending;
};

}  // namespace terratact
