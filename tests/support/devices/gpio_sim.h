#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace terratact {

/// A chip of the kernel's gpio-sim with named lines; the test drives their outside.
class GpioSim {
public:
    static bool available() { return std::filesystem::exists(kConfig); }

    /// The chip appears as /dev/gpiochip*. Only one chip may exist per label.
    GpioSim(std::string label, const std::vector<std::string>& lines)
        : device_(kConfig + ("terratact-" + std::move(label))), bank_(device_ + "/bank")
    {
        std::filesystem::create_directory(device_);
        std::filesystem::create_directory(bank_);
        write(bank_ + "/num_lines", std::to_string(lines.size()));
        write(bank_ + "/label", device_.substr(device_.rfind("terratact-") + 10));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines[i].empty()) continue;
            const std::string line = bank_ + "/line" + std::to_string(i);
            std::filesystem::create_directory(line);
            write(line + "/name", lines[i]);
        }
        plugIn();
    }
    ~GpioSim()
    {
        std::error_code ignored;
        std::ofstream(device_ + "/live") << "0";
        // configfs: removes directories only, innermost first
        std::vector<std::filesystem::path> lines;
        for (const auto& entry : std::filesystem::directory_iterator(bank_, ignored))
            if (entry.is_directory(ignored)) lines.push_back(entry.path());
        for (const auto& line : lines) std::filesystem::remove(line, ignored);
        std::filesystem::remove(bank_, ignored);
        std::filesystem::remove(device_, ignored);
    }
    GpioSim(const GpioSim&) = delete;
    GpioSim& operator=(const GpioSim&) = delete;

    void plugIn()
    {
        write(device_ + "/live", "1");
        chip_ = read(bank_ + "/chip_name");
        lines_ = "/sys/devices/platform/" + read(device_ + "/dev_name") + "/" + chip_ + "/sim_gpio";
    }
    void unplug() { write(device_ + "/live", "0"); }

    const std::string& chip() const { return chip_; }  ///< "gpiochip0"

    /// Drives an input line from outside.
    void drive(std::size_t line, bool high)
    {
        write(lines_ + std::to_string(line) + "/pull", high ? "pull-up" : "pull-down");
    }

    /// Returns the level of a line, as a lamp on it would show.
    bool level(std::size_t line) const
    {
        return read(lines_ + std::to_string(line) + "/value") == "1";
    }

private:
    static constexpr const char* kConfig = "/sys/kernel/config/gpio-sim/";

    static void write(const std::string& path, const std::string& text)
    {
        std::ofstream out(path);
        out << text << std::flush;
        if (!out) throw std::runtime_error("gpio-sim: cannot write " + text + " to " + path);
    }
    static std::string read(const std::string& path)
    {
        std::ifstream in(path);
        std::string text;
        if (!(in >> text)) throw std::runtime_error("gpio-sim: cannot read " + path);
        return text;
    }

    std::string device_, bank_, chip_, lines_;
};

}  // namespace terratact
