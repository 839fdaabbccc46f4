#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "app/review/review_window.h"
#include "tests/support/absolem.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

/// A recorded session under review.
struct ReviewOf : testing::Test {
    void record(double seconds = 4.0)
    {
        auto writer = robotSession(path.toStdString(), seconds);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    void open(QStringList models = {})
    {
        auto session = SessionReader::open(path.toStdString());
        ASSERT_TRUE(session) << session.error().text;
        window = std::make_unique<ReviewWindow>(ReviewWindow::Options{
            .session = std::move(*session), .robot = absolem(), .models = std::move(models)});
        gui::showActive(*window);
    }
    void press(int key, Qt::KeyboardModifiers with = {})
    {
        QTest::keyClick(window.get(), static_cast<Qt::Key>(key), with);
    }
    double now() const { return window->player().position(); }
    /// Returns the cut texts that remain after the layout has settled.
    std::vector<std::string> cutWhenSettled() const { return gui::cutWhenSettled(*window); }

    TemporaryDirectory directory;
    QString path = QString::fromStdString(directory.file("review.tts"));
    std::unique_ptr<ReviewWindow> window;
};

}  // namespace terratact
