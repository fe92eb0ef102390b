#include "files/output_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "mesh/bad_input.hpp"

namespace osem::host {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw BadInput(name + ": cannot be written: " + why);
}

std::string last_fault() { return std::generic_category().message(errno); }

// Mode "x" creates the file or fails, so a file of someone else is never taken over.
bool create_new(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wbx");
    if (file == nullptr) return false;
    static_cast<void>(std::fclose(file)); // nothing was written
    return true;
}

} // namespace

OutputFile::OutputFile(const std::string& target) : name_(target), target_(target) {
    if (target.empty()) refuse("output", "the name is empty");
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) refuse(name_, "it is a directory");
    if (fs::is_regular_file(status)) target_ = fs::canonical(target, error).string();
    if (error && error != std::errc::no_such_file_or_directory) refuse(name_, error.message());
    if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(target, error))) {
        refuse(name_, "it is a link to a file that is not there");
    }

    const bool direct = fs::exists(status) && !fs::is_regular_file(status);
    if (!direct) create_beside();
    stream_.open(direct ? target_ : temporary_, std::ios::binary | std::ios::trunc);
    if (!stream_) refuse(name_, last_fault());
}

void OutputFile::create_beside() {
    constexpr int attempts = 1000;
    for (int i = 0; i < attempts; ++i) {
        const std::string candidate = target_ + ".part" + std::to_string(i);
        if (create_new(candidate)) {
            temporary_ = candidate;
            return;
        }
        if (errno != EEXIST) refuse(name_, last_fault());
    }
    refuse(name_, "too many unfinished files beside it");
}

void OutputFile::probe(const std::string& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    // Opening a pipe would tell its reader that everything has been written.
    if (fs::is_other(status)) return;
    OutputFile attempt(target);
}

OutputFile::~OutputFile() {
    stream_.close();
    if (!temporary_.empty()) static_cast<void>(std::remove(temporary_.c_str()));
}

void OutputFile::commit() {
    stream_.close();
    if (!stream_) refuse(name_, "the device is full or gone");
    if (temporary_.empty()) return;
    std::error_code error;
    const fs::file_status before = fs::status(target_, error);
    if (fs::exists(before)) fs::permissions(temporary_, before.permissions(), error);
    if (fs::exists(before) && error) refuse(name_, error.message());
    fs::rename(temporary_, target_, error);
    if (error) refuse(name_, error.message());
    temporary_.clear();
}

} // namespace osem::host
